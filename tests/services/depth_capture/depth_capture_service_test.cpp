// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/depth_capture_service.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <lcm/lcm-cpp.hpp>
#include <mutex>
#include <thread>
#include <vector>

#include "services/depth_capture/depth_mode.hpp"
#include "tests/services/depth_capture/virtual_camera_control.hpp"

namespace fallen {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using ::testing::HasSubstr;
using virtual_camera::PatternFrame;

constexpr milliseconds kPatience{20000};
constexpr std::int64_t kPeriodUs = 1'000'000 / 60;

/// A plan for the fastest mode, quick to try again.
CapturePlan SmallPlan() {
  CapturePlan plan;
  plan.config.width = 320;
  plan.config.height = 240;
  plan.config.rate_hz = 60;
  plan.config.lost_after_s = 0.3;
  plan.config.first_retry_s = 0.05;
  plan.config.longest_retry_s = 0.1;
  plan.rescan_every = 0;  // virtual cameras are announced, unless a test says otherwise
  return plan;
}

/// Runs the service in a thread; listens to what it publishes.
// One thread for all services of this process, one after the other; it never ends. OpenNI2 asks
// every thread that ever called it whether it still lives, also after a shutdown, and may crash on
// one that has ended. A program has one service in one thread, so this is as in use.
class ServiceThread {
 public:
  static std::future<void> Run(std::function<void()> work) {
    static ServiceThread& instance = *new ServiceThread;
    std::packaged_task<void()> task(std::move(work));
    std::future<void> ended = task.get_future();
    {
      const std::lock_guard lock(instance.mutex_);
      instance.tasks_.push_back(std::move(task));
    }
    instance.changed_.notify_one();
    return ended;
  }

 private:
  ServiceThread() {
    std::thread([this] {
      while (true) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !tasks_.empty(); });
        std::packaged_task<void()> task = std::move(tasks_.front());
        tasks_.pop_front();
        lock.unlock();
        task();
      }
    }).detach();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<void()>> tasks_;
};

class RunningService {
 public:
  explicit RunningService(const CapturePlan& plan) : service_(lcm_, "LEFT", plan) {
    // memq holds everything until it is handled: nothing is lost, however slow the test.
    lcm_.subscribe("DEPTH_LEFT", &RunningService::OnDepth, this)->setQueueCapacity(0);
    lcm_.subscribe("STATUS_DEPTH_CAPTURE", &RunningService::OnStatus, this);
    run_ = ServiceThread::Run([this] {
      service_.Run([this] { return stopped_.load(); });
      ended_ = true;
    });
  }
  ~RunningService() { Stop(); }

  bool HandleUntil(const std::function<bool()>& done) {
    const auto deadline = steady_clock::now() + kPatience;
    while (!done()) {
      if (steady_clock::now() > deadline) return false;
      lcm_.handleTimeout(10);
    }
    return true;
  }
  bool WaitForFrames(std::size_t count) {
    return HandleUntil([&] { return frames.size() >= count; });
  }
  bool WaitForState(std::int8_t state) {
    return HandleUntil([&] { return status.state == state; });
  }
  bool WaitForEnd() {
    const bool has_ended = HandleUntil([&] { return ended_.load(); });
    while (lcm_.handleTimeout(10) > 0) {
    }
    return has_ended;
  }

  void Stop() {
    stopped_ = true;
    if (run_.valid()) run_.wait();
    while (lcm_.handleTimeout(10) > 0) {
    }
  }

  std::vector<StampedDepthImage> frames;
  service_status_t status{};

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
    status = Decode<service_status_t>(buffer);
  }

  lcm::LCM lcm_{"memq://"};
  DepthCaptureService service_;
  std::atomic<bool> stopped_{false};
  std::atomic<bool> ended_{false};
  std::future<void> run_;
};

/// Number that the pattern carries in its first pixel.
int PatternNumber(const StampedDepthImage& frame) { return frame.image.depth.at(0); }

bool IsPattern(const StampedDepthImage& frame) {
  const CameraIntrinsics& camera = frame.image.intrinsics;
  return frame.image.depth == PatternFrame(camera.width, camera.height, PatternNumber(frame));
}

std::int64_t NowUs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

TEST(DepthCaptureServiceTest, PublishesWhatTheCameraSeesBitForBit) {
  const test::VirtualCameraControl control;
  CapturePlan plan = SmallPlan();
  plan.config.mounting_position_m = {0.1, 0, 0.95};
  plan.config.mounting_roll_pitch_yaw_deg = {0, 15, 0};
  const std::int64_t before_us = NowUs();
  RunningService service(plan);
  ASSERT_TRUE(service.WaitForFrames(30));
  service.Stop();
  std::int64_t last_utime = before_us - 1;
  for (std::size_t i = 0; i < service.frames.size(); ++i) {
    const StampedDepthImage& frame = service.frames[i];
    EXPECT_TRUE(IsPattern(frame));
    EXPECT_EQ(frame.header.seq, static_cast<std::int64_t>(i));
    EXPECT_EQ(frame.header.sensor_name, "LEFT");
    EXPECT_GT(frame.header.utime, last_utime);
    EXPECT_LE(frame.header.utime, NowUs());
    last_utime = frame.header.utime;
    ASSERT_TRUE(frame.T_robot_camera);
    EXPECT_TRUE(frame.T_robot_camera->isApprox(*plan.config.T_robot_camera()));
  }
  EXPECT_EQ(service.status.state, service_status_t::STOPPING);
  EXPECT_EQ(service.status.service, "depth-capture");
  EXPECT_EQ(service.status.published, static_cast<std::int64_t>(service.frames.size()));
  // What the camera took is either received here, or counted as lost on the way.
  EXPECT_EQ(service.status.received + service.status.lost_upstream,
            PatternNumber(service.frames.back()) - PatternNumber(service.frames.front()) + 1);
}

TEST(DepthCaptureServiceTest, SaysLostWhenTheCameraGoesAndGoesOnWhenItReturns) {
  const test::VirtualCameraControl control;
  RunningService service(SmallPlan());
  ASSERT_TRUE(service.WaitForFrames(10));
  ASSERT_TRUE(service.WaitForState(service_status_t::RUNNING));
  EXPECT_THAT(service.status.text, HasSubstr("virtual://0"));
  control.Set("unplugged");
  ASSERT_TRUE(service.WaitForState(service_status_t::LOST));
  EXPECT_THAT(service.status.text, HasSubstr("tried again in"));
  const std::size_t count = service.frames.size();
  control.Set("plugged");
  ASSERT_TRUE(service.WaitForFrames(count + 10));
  ASSERT_TRUE(service.WaitForState(service_status_t::RUNNING));
  service.Stop();
  std::int64_t last_utime = 0;
  for (std::size_t i = 0; i < service.frames.size(); ++i) {
    EXPECT_TRUE(IsPattern(service.frames[i]));
    EXPECT_EQ(service.frames[i].header.seq, static_cast<std::int64_t>(i));
    EXPECT_GT(service.frames[i].header.utime, last_utime);
    last_utime = service.frames[i].header.utime;
  }
  EXPECT_LT(PatternNumber(service.frames.back()), static_cast<int>(service.frames.size()));
}

TEST(DepthCaptureServiceTest, WaitsForACameraThatIsNotThereYet) {
  const test::VirtualCameraControl control("unplugged");
  RunningService service(SmallPlan());
  ASSERT_TRUE(service.WaitForState(service_status_t::LOST));
  EXPECT_THAT(service.status.text, HasSubstr("no camera is plugged in"));
  EXPECT_TRUE(service.frames.empty());
  control.Set("plugged");
  EXPECT_TRUE(service.WaitForFrames(3));
}

TEST(DepthCaptureServiceTest, FindsACameraThatNobodyAnnounces) {
  const test::VirtualCameraControl control;
  setenv(virtual_camera::kHotplugVariable, "0", 1);
  CapturePlan plan = SmallPlan();
  plan.rescan_every = CapturePlan().rescan_every;
  RunningService service(plan);
  ASSERT_TRUE(service.WaitForFrames(3));
  control.Set("unplugged");
  ASSERT_TRUE(service.WaitForState(service_status_t::LOST));
  const std::size_t count = service.frames.size();
  control.Set("plugged");
  EXPECT_TRUE(service.WaitForFrames(count + 3));
}

TEST(DepthCaptureServiceTest, LosesACameraThatIsSilent) {
  const test::VirtualCameraControl control;
  RunningService service(SmallPlan());
  ASSERT_TRUE(service.WaitForFrames(3));
  control.Set("silent");
  ASSERT_TRUE(service.WaitForState(service_status_t::LOST));
  const std::size_t count = service.frames.size();
  control.Set("plugged");
  EXPECT_TRUE(service.WaitForFrames(count + 3));
}

TEST(DepthCaptureServiceTest, RefusesAModeThatTheCameraDoesNotHave) {
  const test::VirtualCameraControl control;
  CapturePlan plan = SmallPlan();
  plan.config.width = 1280;
  lcm::LCM lcm("memq://");
  EXPECT_THROW(DepthCaptureService(lcm, "LEFT", plan), UnsupportedMode);
}

/// Records about `count` frames and returns what was published meanwhile.
std::vector<StampedDepthImage> Record(const std::filesystem::path& path, std::size_t count) {
  CapturePlan plan = SmallPlan();
  plan.record = path;
  RunningService service(plan);
  EXPECT_TRUE(service.WaitForFrames(count));
  service.Stop();
  return service.frames;
}

CapturePlan PlayPlan(const std::filesystem::path& path) {
  CapturePlan plan;
  plan.file = path;
  plan.as_fast_as_possible = true;
  return plan;
}

TEST(DepthCaptureServiceTest, ReplaysARecordingBitForBit) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  const std::vector<StampedDepthImage> live = Record(folder / "a.oni", 20);
  CapturePlan plan = PlayPlan(folder / "a.oni");
  plan.epoch_us = 5'000'000;
  std::vector<std::vector<StampedDepthImage>> replays;
  for (int round = 0; round < 2; ++round) {
    RunningService service(plan);
    ASSERT_TRUE(service.WaitForEnd());
    replays.push_back(service.frames);
    EXPECT_EQ(service.status.published, static_cast<std::int64_t>(service.frames.size()));
  }
  ASSERT_GE(replays[0].size(), live.size());
  ASSERT_EQ(replays[0].size(), replays[1].size());
  for (std::size_t i = 0; i < replays[0].size(); ++i) {
    const StampedDepthImage& frame = replays[0][i];
    EXPECT_EQ(PatternNumber(frame), static_cast<int>(i) + 1);
    EXPECT_TRUE(IsPattern(frame));
    EXPECT_EQ(frame.header.seq, static_cast<std::int64_t>(i));
    EXPECT_EQ(frame.header.utime, 5'000'000 + static_cast<std::int64_t>(i) * kPeriodUs);
    EXPECT_EQ(frame.header, replays[1][i].header);
    EXPECT_TRUE(frame.image.depth == replays[1][i].image.depth);
  }
}

TEST(DepthCaptureServiceTest, PlaysInRealTimeUnlessToldOtherwise) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Record(folder / "a.oni", 30);
  const auto time_of = [&](bool as_fast_as_possible) {
    CapturePlan plan = PlayPlan(folder / "a.oni");
    plan.as_fast_as_possible = as_fast_as_possible;
    const auto begin = steady_clock::now();
    RunningService service(plan);
    EXPECT_TRUE(service.WaitForEnd());
    EXPECT_GE(service.frames.size(), 30U);
    return std::chrono::duration<double>(steady_clock::now() - begin).count();
  };
  const double real_time_s = time_of(false);
  EXPECT_GE(real_time_s, 29 / 60.0);  // 30 frames have 29 pauses
  EXPECT_LT(time_of(true), real_time_s);
}

TEST(DepthCaptureServiceTest, LoopsWithTimeAndNumbersGoingOn) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  Record(folder / "a.oni", 5);
  const std::size_t length = OniFile(folder / "a.oni").frame_count();
  CapturePlan plan = PlayPlan(folder / "a.oni");
  plan.loop = true;
  RunningService service(plan);
  ASSERT_TRUE(service.WaitForFrames(3 * length));
  service.Stop();
  for (std::size_t i = 0; i < service.frames.size(); ++i) {
    const StampedDepthImage& frame = service.frames[i];
    EXPECT_EQ(PatternNumber(frame), static_cast<int>(i % length) + 1);
    EXPECT_EQ(frame.header.seq, static_cast<std::int64_t>(i));
    EXPECT_EQ(frame.header.utime, static_cast<std::int64_t>(i) * kPeriodUs);
  }
}

TEST(DepthCaptureServiceTest, BeginsANewRecordingWithEachCamera) {
  const test::VirtualCameraControl control;
  const TemporaryFolder folder;
  CapturePlan plan = SmallPlan();
  plan.record = folder / "a.oni";
  {
    RunningService service(plan);
    ASSERT_TRUE(service.WaitForFrames(5));
    control.Set("unplugged");
    ASSERT_TRUE(service.WaitForState(service_status_t::LOST));
    const std::size_t count = service.frames.size();
    control.Set("plugged");
    ASSERT_TRUE(service.WaitForFrames(count + 5));
  }
  EXPECT_GE(OniFile(folder / "a.oni").frame_count(), 5U);
  EXPECT_GE(OniFile(folder / "a-2.oni").frame_count(), 5U);
  EXPECT_FALSE(std::filesystem::exists(folder / "a-3.oni"));
}

}  // namespace
}  // namespace fallen
