// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <future>
#include <lcm/lcm-cpp.hpp>

#include "fallen/messages/conversions.hpp"
#include "fallen/service_status_t.hpp"
#include "services/depth_capture/oni_file.hpp"
#include "tests/services/depth_capture/virtual_camera_control.hpp"
#include "tests/support/run_program.hpp"

namespace fallen {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using virtual_camera::PatternFrame;

/// Runs the program among virtual cameras, with what the shell is to do with its streams.
ProgramOutcome RunCapture(const std::string& arguments, const std::string& wrapper = "") {
  return RunShell("LD_LIBRARY_PATH=" FALLEN_OPENNI2_DIR " " + wrapper +
                  " " FALLEN_BIN_DIR "/fallen-depth-capture " + arguments);
}

TEST(DepthCaptureProgramTest, ListsCamerasAndTheirModes) {
  const test::VirtualCameraControl control;
  const ProgramOutcome result = RunCapture("--list");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out,
            "virtual://0  Fallen Virtual camera 0\n"
            "    --width 320 --height 240 --rate 30 --unit 1mm\n"
            "    --width 320 --height 240 --rate 60 --unit 1mm\n"
            "    --width 640 --height 480 --rate 30 --unit 1mm\n"
            "    --width 320 --height 240 --rate 30 --unit 100um\n"
            "    --width 640 --height 480 --rate 30 --unit 100um\n");
  control.Set("unplugged");
  EXPECT_EQ(RunCapture("--list").out, "no camera is plugged in\n");
}

TEST(DepthCaptureProgramTest, RefusesAWrongCallInOneLine) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  std::ofstream(folder / "there.oni") << "there already";
  std::ofstream(folder / "wrong.yaml") << "capture:\n  widht: 3\n";
  struct Case {
    std::string arguments;
    std::string told;
  };
  const std::vector<Case> cases{
      {"--widht 3", "--widht"},
      {"--width x", "--width"},
      {"--width -3", "width is -3, must be in [1, 8192]"},
      {"--unit 5mm", "got '5mm', expected 1mm or 100um"},
      {"--width 800",
       "got 800x480 30 Hz 1mm, expected one of 320x240 30 Hz 1mm, 320x240 60 Hz 1mm"},
      {"--rate 31", "got 640x480 31 Hz 1mm"},
      {(folder / "missing.oni").string(), "missing.oni: cannot be read"},
      {(folder / "there.oni").string(), "there.oni: byte "},
      {"--record " + (folder / "there.oni").string(), "is there already"},
      {"--record " + (folder / "none/a.oni").string(), "a folder that is there"},
      {"--record " + (folder / "a.txt").string(), "expected a name in .oni"},
      {"--loop", "--loop: got it with a camera"},
      {"--epoch 3", "--epoch: got it with a camera"},
      {"x.oni --epoch soon", "--epoch: got 'soon'"},
      {"x.oni --record y.oni", "--record: got it with a recording"},
      {"x.oni --rate 30", "got it with a recording"},
      {"--config " + (folder / "wrong.yaml").string(), "wrong.yaml:2"},
  };
  for (const Case& wrong : cases) {
    const ProgramOutcome result = RunCapture("--lcm-url memq:// " + wrong.arguments + " 2>&1");
    EXPECT_EQ(result.status, 2) << wrong.arguments << "\n" << result.out;
    EXPECT_TRUE(IsOneLine(result.out)) << result.out;
    EXPECT_THAT(result.out, StartsWith("fallen-depth-capture: "));
    EXPECT_THAT(result.out, HasSubstr(wrong.told)) << wrong.arguments;
  }
  EXPECT_EQ(RunCapture("--help").status, 0);
  EXPECT_THAT(RunCapture("--version").out, StartsWith("fallen-depth-capture "));
}

/// Listens on a port of this process.
class Listener {
 public:
  Listener() {
    lcm_.subscribe("DEPTH_CAMERA", &Listener::OnDepth, this);
    lcm_.subscribe("STATUS_DEPTH_CAPTURE", &Listener::OnStatus, this);
  }
  const std::string& url() const { return url_; }

  /// Listens until `result` is there.
  template <class Result>
  void ListenUntil(const std::future<Result>& result) {
    while (result.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      lcm_.handleTimeout(20);
    while (lcm_.handleTimeout(100) > 0) {
    }
  }

  std::vector<StampedDepthImage> frames;
  std::vector<service_status_t> statuses;

 private:
  template <class Message>
  static Message Decode(const lcm::ReceiveBuffer* buffer) {
    Message message;
    EXPECT_GT(message.decode(buffer->data, 0, buffer->data_size), 0);
    return message;
  }
  void OnDepth(const lcm::ReceiveBuffer* buffer, const std::string&) {
    frames.push_back(FromMessage(Decode<depth_image_t>(buffer)));
  }
  void OnStatus(const lcm::ReceiveBuffer* buffer, const std::string&) {
    statuses.push_back(Decode<service_status_t>(buffer));
  }

  // Other tests may run at the same time: LCM tells them apart by port only.
  const std::string url_ = "udpm://239.255.76.67:" + std::to_string(10000 + getpid() % 20000) +
                           "?ttl=0&recv_buf_size=4194304";
  lcm::LCM lcm_{url_};
};

TEST(DepthCaptureProgramTest, SendsPicturesAndRecordsThemUntilItIsStopped) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Listener listener;
  auto result = std::async(std::launch::async, [&] {
    return RunCapture(
        "--lcm-url '" + listener.url() + "' --record " + (folder / "a.oni").string() + " 2>&1",
        "timeout --preserve-status -s TERM 3");
  });
  listener.ListenUntil(result);
  const ProgramOutcome ended = result.get();
  EXPECT_EQ(ended.status, 0) << ended.out;
  EXPECT_GE(listener.frames.size(), 30U);
  for (const StampedDepthImage& frame : listener.frames) {
    EXPECT_EQ(frame.header.sensor_name, "CAMERA");
    EXPECT_TRUE(frame.image.depth == PatternFrame(640, 480, frame.image.depth.at(0)));
  }
  ASSERT_GE(listener.statuses.size(), 3U);
  EXPECT_EQ(listener.statuses.back().state, service_status_t::STOPPING);
  EXPECT_GE(listener.statuses.back().published, static_cast<std::int64_t>(listener.frames.size()));
  // Ended by a signal, and closed its recording all the same.
  EXPECT_GE(OniFile(folder / "a.oni").frame_count(), listener.frames.size());
}

}  // namespace
}  // namespace fallen
