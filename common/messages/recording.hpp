// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"

namespace fallen {

/// What is really there in the frame of `header`.
struct RecordedTruth {
  Header header;
  GroundTruth truth;
};

/// One input of the chain.
using RecordedInput = std::variant<StampedPose, StampedDepthImage, RecordedTruth>;

/// What a recording has given so far, and what it could not.
struct RecordingCounts {
  std::int64_t images = 0;
  std::int64_t poses = 0;
  std::int64_t truths = 0;
  std::int64_t refused = 0;         ///< messages that cannot be decoded, or make no sense
  std::int64_t damaged_places = 0;  ///< places in the log that could not be read
  std::int64_t damaged_bytes = 0;
  std::string newest_problem;  ///< why the last of these; empty without any
};

/// Cameras of which `log` holds depth images, sorted. @throws std::runtime_error if it cannot be
/// opened.
std::vector<std::string> CamerasIn(const std::filesystem::path& log);

/// Reads a log as the chain's inputs: robot poses, and one camera's depth images and ground truth,
/// in the order of the log. What is damaged is left out and counted.
class Recording {
 public:
  /// @param camera  Name as in the channels; empty: the only camera of which there are images.
  /// @throws std::runtime_error if the file cannot be opened, has no images of the camera, or has
  /// several cameras and none was named (the text lists them).
  explicit Recording(const std::filesystem::path& log, const std::string& camera = {});

  /// The next input; nothing at the end. Never throws for what the file holds.
  std::optional<RecordedInput> Next();

  const std::string& camera() const { return camera_; }
  const RecordingCounts& counts() const { return counts_; }
  /// Share of the file that was read, [0, 1].
  double progress() const;

 private:
  std::optional<RecordedInput> Convert(const LogEvent& event);
  void CountDamage();

  std::string camera_;
  std::string depth_channel_;
  std::string truth_channel_;
  LogReader reader_;
  RecordingCounts counts_;
  std::size_t damage_seen_ = 0;
};

}  // namespace fallen
