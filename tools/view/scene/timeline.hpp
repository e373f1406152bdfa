// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/view/scene/scene.hpp"

namespace fallen {

/// What the plot over time and the camera's path show of a frame.
struct TimelineEntry {
  std::int64_t utime = 0;
  std::optional<double> probability;  ///< of the best cluster, 0 without any; nothing: undecided
  int persons = 0;
  std::optional<Eigen::Vector3d> camera;  ///< world frame [m]; nothing: its pose is not known
};

TimelineEntry ToTimelineEntry(const Scene& scene);

/// [utime, probability or null, persons, x, y, z] or, without a pose, [utime, probability,
/// persons].
nlohmann::json ToJson(const TimelineEntry& entry);

}  // namespace fallen
