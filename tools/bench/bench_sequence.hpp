// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "fallen/detection/frame.hpp"
#include "fallen/geometry/ground_plane.hpp"

namespace fallen {

/// Frames of one size that all benchmarks of that size run on.
///
/// Played forth and back, so that time goes on and the robot never jumps: an accumulating map stays
/// in its steady state however many iterations are run.
class BenchSequence {
 public:
  /// @param frames  At least one, in order of time.
  /// @param source  Where they come from, for the report.
  BenchSequence(std::vector<Frame> frames, std::string source);

  /// "640x480".
  std::string size_name() const;
  const std::string& source() const { return source_; }
  void set_source(std::string source) { source_ = std::move(source); }
  std::size_t size() const { return frames_.size(); }
  const Frame& operator[](std::size_t i) const { return frames_[i]; }

  /// Index of the frame to show at step `step`, and the time to show it at [us].
  std::size_t IndexAt(std::size_t step) const;
  std::int64_t TimeAt(std::size_t step) const;
  /// The frame at `step`, with its time set.
  const Frame& At(std::size_t step);

 private:
  std::vector<Frame> frames_;
  std::string source_;
  std::int64_t period_us_;
};

/// The demo recording of the source tree that this program was built in; empty if it is not there.
std::filesystem::path ShippedRecording();

/// The first `max_frames` depth images of a log or an import directory, with the robot's poses.
/// @throws std::runtime_error if it cannot be read or holds none.
BenchSequence ReadSequence(const std::filesystem::path& log, const std::string& camera,
                           std::size_t max_frames);

/// A robot driving half a metre into a furnished room with somebody on the floor, ray-cast with the
/// noise of a PrimeSense sensor.
BenchSequence RenderSequence(int width, int height, std::size_t frame_count);

/// The same frames as from a camera whose mounting is known, on a robot whose pose is: where a
/// frame says nothing of them, the floor of the first frame is the mounting, and the robot stands
/// still. Frames stay as they are where that has no floor.
BenchSequence WithMounting(const BenchSequence& sequence, const GroundConfig& config);

/// Every second pixel of every second row.
BenchSequence HalfSize(const BenchSequence& sequence);

/// The sequences to measure on: 640x480 and 320x240, from the recording where it has that size or
/// twice that, else rendered; a recording of another size comes as well.
/// @param log  Empty: none.
std::vector<BenchSequence> ChooseSequences(const std::filesystem::path& log,
                                           const std::string& camera, std::size_t max_frames);

}  // namespace fallen
