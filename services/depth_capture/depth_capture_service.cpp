// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/depth_capture_service.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "fallen/service/channels.hpp"
#include "services/depth_capture/openni_camera.hpp"
#include "services/depth_capture/openni_session.hpp"
#include "services/depth_capture/raw_depth_frame.hpp"

namespace fallen {
namespace {

constexpr char kService[] = "depth-capture";
/// How soon a signal to stop is seen, and a camera that was pulled out is missed.
constexpr std::chrono::milliseconds kPollInterval{50};
/// "a.oni" for the first, "a-2.oni" for the second camera in a row: a recording ends with its
/// camera.
std::filesystem::path RecordingPath(const std::filesystem::path& path, int number) {
  if (number == 1) return path;
  const std::string name = path.stem().string() + "-" + std::to_string(number);
  return path.parent_path() / (name + path.extension().string());
}

/// Opens the camera of the plan, time and again.
class Opener {
 public:
  explicit Opener(const CapturePlan& plan) : plan_(plan) {}

  std::unique_ptr<Camera> Open(int attempt) {
    const bool is_due = plan_.rescan_every > 0 && attempt % plan_.rescan_every == 0;
    if (!session_ || is_due) Rescan();
    const CaptureConfig& config = plan_.config;
    const DepthMode mode{config.width, config.height, config.rate_hz, config.depth_unit};
    auto camera = std::make_unique<OpenNiCamera>(config.device_uri, mode, NextRecording());
    ++opened_;
    return camera;
  }

 private:
  void Rescan() {
    session_.reset();
    try {
      session_.emplace();
    } catch (const std::runtime_error& error) {
      throw CameraUnavailable(error.what());
    }
  }

  std::optional<std::filesystem::path> NextRecording() const {
    if (!plan_.record) return std::nullopt;
    int number = opened_ + 1;
    while (std::filesystem::exists(RecordingPath(*plan_.record, number))) ++number;
    return RecordingPath(*plan_.record, number);
  }

  const CapturePlan plan_;
  std::optional<OpenNiSession> session_;
  int opened_ = 0;
};

std::chrono::milliseconds Milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * seconds));
}

KeeperOptions KeeperOptionsOf(const CaptureConfig& config) {
  return {Milliseconds(config.lost_after_s), Milliseconds(config.first_retry_s),
          Milliseconds(config.longest_retry_s)};
}

template <class Clock>
std::int64_t NowUs() {
  const auto now = Clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

}  // namespace

DepthCaptureService::DepthCaptureService(lcm::LCM& lcm, const std::string& camera_name,
                                         const CapturePlan& plan)
    : camera_name_(camera_name),
      plan_(plan),
      reporter_(lcm, kService, camera_name),
      T_robot_camera_(plan.config.T_robot_camera()) {
  if (plan.file) {
    file_.emplace(*plan.file);
    return;
  }
  keeper_.emplace(
      [opener = std::make_shared<Opener>(plan)](int attempt) { return opener->Open(attempt); },
      KeeperOptionsOf(plan.config));
  keeper_->OpenIfDue(Clock::now());
}

void DepthCaptureService::Run(const std::function<bool()>& stop_arrived) {
  bool stopped = false;
  const auto stop = [&] { return stopped = stopped || stop_arrived(); };
  if (file_) Play(stop);
  while (!file_ && !stop()) Capture();
  reporter_.SetState(ServiceState::kStopping, "");
  reporter_.PublishStatus();
}

void DepthCaptureService::Capture() {
  reporter_.PublishStatusIfDue();
  std::optional<CameraFrame> frame;
  try {
    frame = keeper_->Read(Clock::now(), kPollInterval);
  } catch (const BadFrame& error) {
    reporter_.CountDamaged(error.what());
  }
  const Clock::time_point now = Clock::now();
  if (!keeper_->is_open()) {
    reporter_.SetState(ServiceState::kLost, keeper_->text());
    std::this_thread::sleep_until(std::min(keeper_->retry_at(), now + kPollInterval));
    return;
  }
  reporter_.SetState(ServiceState::kRunning, keeper_->text());
  if (!frame) return;
  if (connections_ != keeper_->connections()) {
    connections_ = keeper_->connections();
    clock_ = DeviceClock();
  }
  const std::int64_t arrival_us = NowUs<Clock>();
  const std::int64_t utime = clock_.HostTime(frame->device_time_us, arrival_us,
                                             NowUs<std::chrono::system_clock>() - arrival_us);
  reporter_.CountReceived(utime, frame->device_index);
  Publish({{utime, 0, ""}, std::move(frame->image), std::nullopt}, now);
}

void DepthCaptureService::Play(const std::function<bool()>& stop_arrived) {
  const OpenNiSession session;  // across loops: starting OpenNI2 looks for cameras each time
  reporter_.SetState(ServiceState::kRunning, "playing " + plan_.file->string());
  const Clock::time_point start = Clock::now();
  while (!stop_arrived()) {
    reporter_.PublishStatusIfDue();
    const Clock::time_point begin = Clock::now();
    std::optional<StampedDepthImage> frame = file_->Next();
    if (!frame) {
      if (!plan_.loop) return;
      loop_offset_us_ += file_->duration_us();
      file_.emplace(*plan_.file);
      continue;
    }
    const std::int64_t since_first_us = frame->header.utime + loop_offset_us_;
    if (!plan_.as_fast_as_possible &&
        !WaitUntil(start + std::chrono::microseconds(since_first_us), stop_arrived))
      return;
    frame->header.utime = plan_.epoch_us + since_first_us;
    reporter_.CountReceived(frame->header.utime, seq_);
    Publish(std::move(*frame), begin);
  }
}

bool DepthCaptureService::WaitUntil(Clock::time_point time,
                                    const std::function<bool()>& stop_arrived) {
  while (Clock::now() < time) {
    if (stop_arrived()) return false;
    reporter_.PublishStatusIfDue();
    std::this_thread::sleep_until(std::min(time, Clock::now() + kPollInterval));
  }
  return true;
}

void DepthCaptureService::Publish(StampedDepthImage image, Clock::time_point begin) {
  image.header.seq = seq_++;
  image.header.sensor_name = camera_name_;
  image.T_robot_camera = T_robot_camera_;
  const depth_image_t message = ToMessage(image);
  const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
  reporter_.PublishResult(channels::Depth(camera_name_), message, time.count());
}

}  // namespace fallen
