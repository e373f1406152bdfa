// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "fallen/service/capture_config.hpp"

namespace fallen {

/// What the command line of fallen-depth-capture says beyond the common flags.
struct CaptureFlags {
  std::string file;
  std::optional<std::string> device;
  std::optional<int> width;
  std::optional<int> height;
  std::optional<int> rate_hz;
  std::string unit;
  std::string record;
  std::string epoch;
  bool loop = false;
  bool as_fast_as_possible = false;
};

/// Adds the flags to `cli`, which writes into `flags`: both must live until it has parsed.
/// `--list` prints the cameras while parsing and ends it.
void AddCaptureFlags(CLI::App& cli, CaptureFlags& flags);

/// What to capture: a camera, or a recording.
struct CapturePlan {
  CaptureConfig config;  ///< with the flags applied
  std::optional<std::filesystem::path> record;
  /// Every so many attempts to open a lost camera OpenNI2 is started anew, which finds cameras that
  /// nobody announces (no udev, a driver without hot plug); 0: never. Not at every one: a camera
  /// that is announced just while OpenNI2 shuts down makes it hang.
  int rescan_every = 4;

  std::optional<std::filesystem::path> file;  ///< a recording in place of a camera
  bool loop = false;
  bool as_fast_as_possible = false;
  /// Time of the recording's first image [us since the epoch].
  std::int64_t epoch_us = 0;
};

/// @param now_us  What `--epoch now` means.
/// @throws std::invalid_argument for flags that are out of range or do not go together.
CapturePlan MakeCapturePlan(const CaptureFlags& flags, const CaptureConfig& config,
                            std::int64_t now_us);

}  // namespace fallen
