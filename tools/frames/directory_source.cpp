// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/frames/directory_source.hpp"

#include <stdexcept>
#include <utility>

#include "tools/frames/frame_from_message.hpp"

namespace fallen {

DirectorySource::DirectorySource(const std::filesystem::path& directory, std::string camera)
    : directory_(ReadTumDirectory(directory)), camera_(std::move(camera)) {}

std::optional<Frame> DirectorySource::Next() {
  while (ready_.empty() && next_ < directory_.frames.size()) {
    try {
      Take(LoadTumFrame(directory_, next_++, camera_));
    } catch (const std::exception& error) {
      damage_.Add(error.what());
    }
  }
  if (ready_.empty())
    for (Frame& frame : synchronizer_.Flush()) ready_.push_back(std::move(frame));
  if (ready_.empty()) return std::nullopt;
  Frame frame = std::move(ready_.front());
  ready_.pop_front();
  return frame;
}

void DirectorySource::Take(const TumMessages& messages) {
  // Through the messages and back: rotations travel as quaternions, which costs the last bits.
  if (messages.pose) {
    const StampedPose pose = FromMessage(ToMessage(*messages.pose));
    for (Frame& frame : synchronizer_.AddPose(pose.utime, pose.translation, pose.rotation))
      ready_.push_back(std::move(frame));
  }
  for (Frame& frame : synchronizer_.AddFrame(ToFrame(FromMessage(ToMessage(messages.depth)))))
    ready_.push_back(std::move(frame));
}

double DirectorySource::share_done() const {
  return static_cast<double>(next_) / static_cast<double>(directory_.frames.size());
}

}  // namespace fallen
