// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/frames/log_source.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/service/channels.hpp"
#include "tools/frames/frame_from_message.hpp"

namespace fallen {

LogSource::LogSource(const std::filesystem::path& log, const std::optional<std::string>& camera)
    : log_(log), recording_(log, camera.value_or("")) {}

std::optional<Frame> LogSource::Next() {
  while (ready_.empty() && !is_at_end_) {
    if (std::optional<RecordedInput> input = recording_.Next()) {
      Take(std::move(*input));
      continue;
    }
    is_at_end_ = true;
    for (Frame& frame : synchronizer_.Flush()) ready_.push_back(std::move(frame));
  }
  if (ready_.empty()) return std::nullopt;
  Frame frame = std::move(ready_.front());
  ready_.pop_front();
  return frame;
}

void LogSource::Take(RecordedInput input) {
  std::vector<Frame> settled;
  if (const auto* pose = std::get_if<StampedPose>(&input))
    settled = synchronizer_.AddPose(pose->utime, pose->translation, pose->rotation);
  if (auto* depth = std::get_if<StampedDepthImage>(&input))
    settled = synchronizer_.AddFrame(ToFrame(std::move(*depth)));
  for (Frame& frame : settled) ready_.push_back(std::move(frame));
}

void LogSource::ReadTruths() {
  truths_.emplace();
  const std::string channel = channels::GroundTruth(camera());
  LogReader reader(log_);
  while (const std::optional<LogEvent> event = reader.Next()) {
    if (event->channel != channel) continue;
    // Damaged ones are counted by the recording.
    if (Decoded<ground_truth_t> truth = DecodeMessage<ground_truth_t>(event->data))
      (*truths_)[truth.message->header.utime] = std::move(*truth.message);
  }
}

std::optional<GroundTruth> LogSource::Truth(const Frame& frame) {
  if (!truths_) ReadTruths();
  const auto found = truths_->find(frame.utime);
  if (found == truths_->end()) return std::nullopt;
  try {
    return FromMessage(found->second);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Damage LogSource::damage() const {
  const RecordingCounts& counts = recording_.counts();
  Damage damage{counts.refused + counts.damaged_places, counts.newest_problem};
  if (synchronizer_.refused_poses() > 0 && damage.count == 0)
    damage.example = std::string(channels::kRobotPose) + ": no finite pose with a unit quaternion";
  damage.count += synchronizer_.refused_poses();
  return damage;
}

}  // namespace fallen
