// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/tools/view/server/viewer.hpp"
#include "tests/tools/view/server/web_socket.hpp"

namespace fallen {
namespace {

constexpr int kFrames = 60;  // of the shipped recording
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long kMaxGrowth_kB = 1L << 30;  // freed memory is kept back
#else
constexpr long kMaxGrowth_kB = 8 << 10;
#endif

long Resident_kB(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string word; status >> word;)
    if (word == "VmRSS:") {
      long kilobytes = 0;
      status >> kilobytes;
      return kilobytes;
    }
  return 0;
}

void WaitUntilRead(WebSocket& browser) {
  while (true) {
    const WebSocket::Message message = browser.Receive();
    if (!message.is_text) continue;
    const auto json = nlohmann::json::parse(message.bytes);
    if (json["type"] == "topic" && json["name"] == "source" && json["value"]["share_read"] == 1)
      return;
  }
}

/// Asks for each frame and waits until it is there. @return Bytes of all.
std::size_t ReadAllFrames(WebSocket& browser) {
  std::size_t bytes = 0;
  for (int i = 0; i < kFrames; ++i) {
    browser.Send(R"({"want":)" + std::to_string(i) + "}");
    WebSocket::Message message = browser.Receive();
    while (message.is_text) message = browser.Receive();
    bytes += message.bytes.size();
  }
  return bytes;
}

TEST(SlowBrowser, ThatStopsReadingCostsOneMessageAndSlowsNobody) {
  Viewer viewer({FALLEN_SOURCE_DIR "/recordings/demo.lcm"});
  WebSocket reader(viewer.port());
  WaitUntilRead(reader);
  const std::size_t bytes = ReadAllFrames(reader);
  const long before_kB = Resident_kB(viewer.process().pid());
  ASSERT_GT(before_kB, 0);

  WebSocket stuck(viewer.port()), mute(viewer.port());
  constexpr int kWishes = 5000;
  // Had each wish its frame in memory, it would be many times what is allowed.
  ASSERT_GT(bytes / kFrames * kWishes >> 10, static_cast<std::size_t>(20 * (8 << 10)));
  for (int i = 0; i < kWishes; ++i) stuck.Send(R"({"want":)" + std::to_string(i % kFrames) + "}");

  EXPECT_EQ(ReadAllFrames(reader), bytes);
  EXPECT_LT(Resident_kB(viewer.process().pid()) - before_kB, kMaxGrowth_kB);
  EXPECT_EQ(viewer.process().Stop(), 0);
}

}  // namespace
}  // namespace fallen
