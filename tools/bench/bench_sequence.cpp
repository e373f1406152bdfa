// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/bench/bench_sequence.hpp"

#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "fallen/detection/pose_synchronizer.hpp"
#include "fallen/messages/recording.hpp"
#include "fallen/service/channels.hpp"
#include "tools/bench/ray_cast_scene.hpp"
#include "tools/import/import_log.hpp"

namespace fallen {
namespace {

constexpr std::int64_t kDefaultPeriod_us = 100000;
constexpr double kCameraHeight_m = 1.0;
constexpr double kCameraPitch_rad = 0.45;
constexpr double kDrive_m = 0.5;

constexpr char kShippedRecording[] = "recordings/demo.lcm";
// build/<preset>/bin/<executable> is three folders below the source tree.
constexpr int kMaxFoldersUp = 4;

// A log made of an import directory, gone with this object.
class ImportedLog {
 public:
  ImportedLog(const std::filesystem::path& directory, const std::string& camera)
      : path_(std::filesystem::temp_directory_path() /
              ("fallen-bench-" + std::to_string(getpid()) + ".lcm")) {
    ImportDirectory(directory, path_, camera.empty() ? channels::kDefaultCamera : camera);
  }
  ~ImportedLog() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ImportedLog(const ImportedLog&) = delete;
  ImportedLog& operator=(const ImportedLog&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void Append(std::vector<Frame>& frames, std::vector<Frame> more) {
  for (Frame& frame : more) frames.push_back(std::move(frame));
}

bool HasSize(const BenchSequence& sequence, int width, int height) {
  return sequence[0].image.intrinsics.width == width &&
         sequence[0].image.intrinsics.height == height;
}

}  // namespace

BenchSequence::BenchSequence(std::vector<Frame> frames, std::string source)
    : frames_(std::move(frames)), source_(std::move(source)), period_us_(kDefaultPeriod_us) {
  if (frames_.size() < 2) return;
  const std::int64_t span = frames_.back().utime - frames_.front().utime;
  period_us_ = std::max<std::int64_t>(1, span / static_cast<std::int64_t>(frames_.size() - 1));
}

std::string BenchSequence::size_name() const {
  const CameraIntrinsics& camera = frames_[0].image.intrinsics;
  return std::to_string(camera.width) + "x" + std::to_string(camera.height);
}

std::size_t BenchSequence::IndexAt(std::size_t step) const {
  if (frames_.size() == 1) return 0;
  const std::size_t last = frames_.size() - 1;
  const std::size_t phase = step % (2 * last);
  return phase <= last ? phase : 2 * last - phase;
}

std::int64_t BenchSequence::TimeAt(std::size_t step) const {
  return frames_[0].utime + period_us_ * static_cast<std::int64_t>(step);
}

const Frame& BenchSequence::At(std::size_t step) {
  Frame& frame = frames_[IndexAt(step)];
  frame.utime = TimeAt(step);
  return frame;
}

std::filesystem::path ShippedRecording() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error);
  for (int i = 0; i <= kMaxFoldersUp; ++i) {
    folder = folder.parent_path();
    if (std::filesystem::exists(folder / kShippedRecording, error))
      return folder / kShippedRecording;
  }
  return {};
}

BenchSequence ReadSequence(const std::filesystem::path& log, const std::string& camera,
                           std::size_t max_frames) {
  if (std::filesystem::is_directory(log)) {
    const ImportedLog imported(log, camera);
    BenchSequence sequence = ReadSequence(imported.path(), camera, max_frames);
    sequence.set_source(log.filename().string());
    return sequence;
  }
  Recording recording(log, camera);
  PoseSynchronizer synchronizer;
  std::vector<Frame> frames;
  while (frames.size() < max_frames) {
    std::optional<RecordedInput> input = recording.Next();
    if (!input) {
      Append(frames, synchronizer.Flush());
      break;
    }
    if (const auto* pose = std::get_if<StampedPose>(&*input)) {
      Append(frames, synchronizer.AddPose(pose->utime, pose->translation, pose->rotation));
    } else if (auto* depth = std::get_if<StampedDepthImage>(&*input)) {
      Frame frame;
      frame.utime = depth->header.utime;
      frame.image = std::move(depth->image);
      frame.T_robot_camera = depth->T_robot_camera;
      Append(frames, synchronizer.AddFrame(std::move(frame)));
    }
  }
  if (frames.size() > max_frames) frames.resize(max_frames);
  // A recording whose size changes on the way: what is measured is one size.
  if (!frames.empty())
    std::erase_if(frames, [size = frames[0].image.intrinsics](const Frame& frame) {
      return frame.image.intrinsics.width != size.width ||
             frame.image.intrinsics.height != size.height;
    });
  if (frames.empty())
    throw std::runtime_error(log.string() + ": got no depth image that can be read, expected one");
  return {std::move(frames), log.filename().string()};
}

BenchSequence RenderSequence(int width, int height, std::size_t frame_count) {
  RayCastScene room = FurnishedRoom();
  room.ellipsoids = LyingPerson({2.4, 0.2, 0}, 0.6);
  const CameraIntrinsics camera = PrimeSenseIntrinsics(width, height);
  const Eigen::Isometry3d T_robot_camera =
      LookingDown({0, 0, kCameraHeight_m}, 0, kCameraPitch_rad);
  std::mt19937 noise(1);
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < frame_count; ++i) {
    Frame frame;
    frame.utime = kDefaultPeriod_us * static_cast<std::int64_t>(i);
    frame.T_robot_camera = T_robot_camera;
    const double driven = kDrive_m * static_cast<double>(i) / static_cast<double>(frame_count);
    frame.T_world_robot = Eigen::Isometry3d(Eigen::Translation3d(driven, 0, 0));
    frame.image =
        WithSensorNoise(RenderDepth(room, camera, *frame.T_world_robot * T_robot_camera), noise);
    frames.push_back(std::move(frame));
  }
  return {std::move(frames), "ray-cast room"};
}

BenchSequence WithMounting(const BenchSequence& sequence, const GroundConfig& config) {
  const GroundEstimate ground =
      EstimateGround(sequence[0].image, sequence[0].T_robot_camera, config);
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    Frame frame = sequence[i];
    if (!frame.T_robot_camera && ground.ok())
      frame.T_robot_camera = LevelFrameFromGround(ground.plane);
    if (!frame.T_world_robot && frame.T_robot_camera)
      frame.T_world_robot = Eigen::Isometry3d::Identity();
    frames.push_back(std::move(frame));
  }
  return {std::move(frames), sequence.source()};
}

BenchSequence HalfSize(const BenchSequence& sequence) {
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const DepthImage& full = sequence[i].image;
    Frame frame = sequence[i];
    CameraIntrinsics& camera = frame.image.intrinsics;
    camera = {full.intrinsics.width / 2, full.intrinsics.height / 2, full.intrinsics.fx / 2,
              full.intrinsics.fy / 2,    full.intrinsics.cx / 2,     full.intrinsics.cy / 2};
    frame.image.depth.clear();
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u)
        frame.image.depth.push_back(
            full.depth[static_cast<std::size_t>(2 * v) * full.intrinsics.width + 2 * u]);
    frames.push_back(std::move(frame));
  }
  return {std::move(frames), sequence.source() + ", every second pixel"};
}

std::vector<BenchSequence> ChooseSequences(const std::filesystem::path& log,
                                           const std::string& camera, std::size_t max_frames) {
  constexpr std::size_t kRenderedFrames = 12;
  std::vector<BenchSequence> sequences;
  if (!log.empty()) sequences.push_back(ReadSequence(log, camera, max_frames));
  const bool has_vga = !sequences.empty() && HasSize(sequences[0], 640, 480);
  const bool has_qvga = !sequences.empty() && HasSize(sequences[0], 320, 240);
  if (!has_vga)
    sequences.insert(sequences.begin(),
                     RenderSequence(640, 480, std::min(max_frames, kRenderedFrames)));
  if (!has_qvga) sequences.push_back(HalfSize(sequences[0]));
  return sequences;
}

}  // namespace fallen
