// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fallen/detection/frame.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// What could not be used of a recording: counted, never fatal.
struct Damage {
  std::int64_t count = 0;
  std::string example;  ///< what was wrong with one of them; empty without any

  void Add(const std::string& what) {
    ++count;
    example = what;
  }
};

/// Frames of a recording in order, joined with the robot's poses as a live service joins them.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Next frame; nothing at the end. Never throws for what the recording holds.
  virtual std::optional<Frame> Next() = 0;

  /// What is really there at the time of `frame`, if the recording says so and it can be decoded.
  virtual std::optional<GroundTruth> Truth(const Frame& frame) = 0;

  /// Name of the camera whose frames these are.
  virtual const std::string& camera() const = 0;

  /// How much has been read, [0, 1].
  virtual double share_done() const = 0;

  /// Everything unusable so far.
  virtual Damage damage() const = 0;
};

/// Opens an LCM log, an `.oni` file or a directory as fallen-import reads it.
///
/// @param camera  Which camera of a log; nothing: its only one. Names the frames of other inputs.
/// @param T_robot_camera  Mounting for an `.oni` file, which holds none; nothing: not known. The
/// others
///                        hold their own.
/// @throws std::runtime_error if the input cannot be opened, holds no depth image, or holds several
/// cameras and none is chosen.
std::unique_ptr<FrameSource> OpenFrameSource(
    const std::filesystem::path& input, const std::optional<std::string>& camera = {},
    const std::optional<Eigen::Isometry3d>& T_robot_camera = {});

}  // namespace fallen
