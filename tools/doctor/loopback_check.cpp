// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <lcm/lcm-cpp.hpp>

#include "tools/doctor/network_checks.hpp"

namespace fallen {
namespace {

constexpr std::size_t kSmallBytes = 1000;  // one packet
/// An uncompressed 640 x 480 picture with its header: as good as the largest that we send.
constexpr std::size_t kLargeBytes = 640 * 480 * 2 + 100;
constexpr int kMessages = 10;
/// Between messages: as at 30 Hz.
constexpr std::chrono::milliseconds kPeriod{33};
/// For what is still on its way. On loopback 614 KB take 0.4 ms.
constexpr std::chrono::milliseconds kLastWait{300};

/// Counts the messages that arrive as they were sent.
class Listener {
 public:
  explicit Listener(const std::vector<std::uint8_t>& sent) : sent_(sent) {}

  void Receive(const lcm::ReceiveBuffer* buffer, const std::string&) {
    const auto* bytes = static_cast<const std::uint8_t*>(buffer->data);
    if (buffer->data_size == sent_.size() && std::equal(sent_.begin(), sent_.end(), bytes))
      ++count_;
  }
  int count() const { return count_; }

 private:
  const std::vector<std::uint8_t>& sent_;
  int count_ = 0;
};

void HandleFor(lcm::LCM& lcm, std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  for (auto left = time; left.count() > 0;
       left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()))
    if (lcm.handleTimeout(static_cast<int>(left.count())) < 0) return;
}

/// How many of kMessages messages of that size come back whole.
int Exchange(lcm::LCM& lcm, std::size_t bytes) {
  std::vector<std::uint8_t> message(bytes);
  for (std::size_t i = 0; i < bytes; ++i) message[i] = static_cast<std::uint8_t>(i + i / 251);
  // A channel of its own: somebody else may be trying, too.
  const std::string channel =
      "FALLEN_DOCTOR_" + std::to_string(getpid()) + "_" + std::to_string(bytes);
  Listener listener(message);
  lcm::Subscription* subscription = lcm.subscribe(channel, &Listener::Receive, &listener);
  if (subscription == nullptr) return 0;
  for (int i = 0; i < kMessages; ++i) {
    lcm.publish(channel, message.data(), static_cast<unsigned>(message.size()));
    HandleFor(lcm, kPeriod);
  }
  if (listener.count() < kMessages) HandleFor(lcm, kLastWait);
  lcm.unsubscribe(subscription);
  return listener.count();
}

std::string CameBack(int count, std::size_t bytes) {
  return std::to_string(count) + " of " + std::to_string(kMessages) + " messages of " +
         std::to_string(bytes) + " bytes came back";
}

}  // namespace

Finding TryLoopback(const std::string& lcm_url, const std::string& sysctl_file) {
  const std::string check = "LCM loopback";
  const std::string remedy =
      "sudo ip link set lo up multicast on && sudo ip route replace 224.0.0.0/4 dev lo";
  lcm::LCM lcm(lcm_url);
  if (!lcm.good() || lcm.getFileno() < 0)
    return {check, Verdict::kError, "LCM cannot receive on '" + lcm_url + "'", remedy};
  const int small = Exchange(lcm, kSmallBytes);
  if (small < kMessages)
    return {check, Verdict::kError, CameBack(small, kSmallBytes) + ", expected all", remedy};
  const int large = Exchange(lcm, kLargeBytes);
  if (large < kMessages)
    return {check, Verdict::kError, CameBack(large, kLargeBytes) + ", expected all",
            LoadSettingsCommand(sysctl_file)};
  return Good(check, CameBack(large, kLargeBytes));
}

}  // namespace fallen
