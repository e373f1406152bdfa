// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "fallen/messages/conversions.hpp"

namespace fallen {

/// What an .oni file does not say about itself.
struct OniFileOptions {
  /// Time of the recording's first image [us since the epoch]: a recording holds no date. Those of
  /// the others follow from the recorded ones, so that every replay gives the same.
  std::int64_t epoch_us = 0;
  std::string sensor_name = "CAMERA";
  std::optional<Eigen::Isometry3d> T_robot_camera;
};

/// Depth images of an .oni recording, every one, in order, as fast as they are asked for.
///
/// Never mirrored: where the recording is, left and right are swapped back. Not thread-safe.
class OniFile {
 public:
  /// Checks the whole file's structure first.
  /// @throws std::runtime_error "<file>: <place>: got ..., expected ...".
  explicit OniFile(const std::filesystem::path& path, OniFileOptions options = {});
  ~OniFile();
  OniFile(OniFile&&) noexcept;

  /// Next image, `seq` counting from 0; nothing after the last.
  /// @throws std::runtime_error if a frame cannot be decoded.
  std::optional<StampedDepthImage> Next();

  std::size_t frame_count() const;
  /// Frames that Next() has given.
  std::size_t position() const;
  /// From the first frame to the time at which the one after the last would come [us].
  std::int64_t duration_us() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fallen
