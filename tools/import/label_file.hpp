// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "fallen/messages/conversions.hpp"

namespace fallen {

/// What a person says is to be seen in a stretch of a recording.
struct LabelledStretch {
  int line = 0;  ///< in the file, from 1
  /// Both ends belong to it. Seconds count from the first depth image.
  std::optional<std::pair<std::int64_t, std::int64_t>> frames;
  std::optional<std::pair<double, double>> seconds;
  GroundTruth truth;

  bool Holds(std::int64_t frame, double seconds_since_first) const;
};

/// A `labels.yaml`: either `person:`, for the whole recording, or `stretches:`, a list of maps with
/// `frames: [first, last]` or `seconds: [from, to]` and a `person:` each. A person is `present` or
/// not, has a `box:` (`center`, `size`, `yaw`, world frame) if so, and may have a `name`; `room:`
/// beside them names the place. Recordings are split by both names. Further keys are ignored.
struct LabelFile {
  std::filesystem::path path;
  std::vector<LabelledStretch> stretches;

  /// Truth of a frame by the first stretch that holds it; nothing: nobody said.
  std::optional<GroundTruth> At(std::int64_t frame, double seconds_since_first) const;
};

/// @throws InputError naming file, line, got and expected.
LabelFile ReadLabelFile(const std::filesystem::path& path);

}  // namespace fallen
