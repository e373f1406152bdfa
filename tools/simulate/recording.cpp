// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/recording.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"

namespace fallen::sim {
namespace {

struct EncodedFrame {
  std::int64_t utime = 0;
  std::vector<std::uint8_t> pose, truth, depth;
};

StampedPose ToStampedPose(std::int64_t utime, const RobotPose& pose) {
  StampedPose stamped;
  stamped.utime = utime;
  stamped.translation = {pose.x, pose.y, 0};
  stamped.rotation = Eigen::Quaterniond(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()));
  return stamped;
}

GroundTruth MakeGroundTruth(const Simulation& simulation, int index, const Frame& frame) {
  const Scene& scene = simulation.SceneAt(index);
  GroundTruth truth;
  truth.room = "room-" + std::to_string(simulation.scenario().room);
  if (simulation.IsSomebodyLying(index)) {
    const SceneObject& person = scene.objects[*simulation.person_index()];
    truth.person_box = person.box;
    truth.person = person.name;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    truth.objects.push_back(
        {object.category, object.name, static_cast<std::int32_t>(i + 1), object.box});
  }
  truth.label_width = frame.image.depth.intrinsics.width;
  truth.label_height = frame.image.depth.intrinsics.height;
  truth.labels = frame.image.labels;
  return truth;
}

EncodedFrame EncodeFrame(const Simulation& simulation, int index) {
  const Frame frame = simulation.TakeFrame(index);
  const Header header{frame.utime, index, simulation.scenario().camera};
  EncodedFrame encoded;
  encoded.utime = frame.utime;
  encoded.pose = EncodeMessage(ToMessage(ToStampedPose(frame.utime, frame.told_pose)));
  encoded.truth = EncodeMessage(ToMessage(header, MakeGroundTruth(simulation, index, frame)));
  encoded.depth = EncodeMessage(
      ToMessage(StampedDepthImage{header, frame.image.depth, simulation.told_T_robot_camera()}));
  return encoded;
}

// Frames that are ready, handed out in their order; workers do not run far ahead of the writer.
class FrameQueue {
 public:
  FrameQueue(int frames, int ahead) : frames_(frames), ahead_(ahead) {}

  // Number of the next frame to make, or -1 if there is none any more.
  int Claim() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || next_ >= frames_ || next_ < written_ + ahead_; });
    return error_ || next_ >= frames_ ? -1 : next_++;
  }
  void Put(int index, EncodedFrame frame) {
    const std::lock_guard lock(mutex_);
    ready_.emplace(index, std::move(frame));
    changed_.notify_all();
  }
  void Fail(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    error_ = error;
    changed_.notify_all();
  }
  EncodedFrame Take(int index) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return error_ || ready_.contains(index); });
    if (error_) std::rethrow_exception(error_);
    EncodedFrame frame = std::move(ready_.extract(index).mapped());
    written_ = index + 1;
    changed_.notify_all();
    return frame;
  }

 private:
  const int frames_, ahead_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int next_ = 0, written_ = 0;
  std::map<int, EncodedFrame> ready_;
  std::exception_ptr error_;
};

}  // namespace

void WriteRecording(const Simulation& simulation, const std::filesystem::path& path, int jobs,
                    const std::function<void(int)>& progress) {
  const std::string& camera = simulation.scenario().camera;
  const int frames = simulation.scenario().frames;
  LogWriter log(path);
  FrameQueue queue(frames, 4 * std::max(1, jobs));
  std::vector<std::jthread> workers;
  for (int i = 0; i < std::max(1, jobs); ++i) {
    workers.emplace_back([&] {
      try {
        for (int index = queue.Claim(); index >= 0; index = queue.Claim())
          queue.Put(index, EncodeFrame(simulation, index));
      } catch (...) {
        queue.Fail(std::current_exception());
      }
    });
  }
  try {
    for (int index = 0; index < frames; ++index) {
      const EncodedFrame frame = queue.Take(index);
      log.Write(frame.utime, channels::kRobotPose, frame.pose);
      log.Write(frame.utime, channels::GroundTruth(camera), frame.truth);
      log.Write(frame.utime, channels::Depth(camera), frame.depth);
      if (progress) progress(index + 1);
    }
  } catch (...) {
    queue.Fail(std::current_exception());  // wakes the workers
    throw;
  }
  log.Close();
}

}  // namespace fallen::sim
