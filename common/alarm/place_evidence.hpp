// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fallen/alarm/alarm_config.hpp"

namespace fallen {

/// What all frames together say about one place: log-odds that a fallen person lies there.
///
/// Log-odds of independent observations add up. Frames from one viewpoint are not independent: a
/// dog that looks like a person from here does so in every frame. So each viewpoint counts once, as
/// the running mean of what its frames say (time constant settle_s, from nothing), and the
/// viewpoints add up. What other viewpoints said fades while the place is seen (memory_s): somebody
/// may have got up since. While nobody looks, nothing changes.
class PlaceEvidence {
 public:
  /// Takes what one frame says.
  /// @param log_odds       For (> 0) or against a fallen person.
  /// @param camera_offset  Camera less place [m], frame of the place.
  /// @param seconds        Time for which the frame speaks: since the camera's frame before it.
  void Add(double log_odds, const Eigen::Vector3d& camera_offset, double seconds,
           const AlarmConfig& config);

  double log_odds() const;
  /// Viewpoints that spoke for a fallen person.
  int supporting_views() const;

 private:
  struct Viewpoint {
    Eigen::Vector3d direction;  ///< from the place, unit
    double distance_m;
    double value = 0;  ///< its share of the log-odds
    bool has_supported = false;
  };
  Viewpoint& FindOrAdd(const Eigen::Vector3d& camera_offset, const AlarmConfig& config);

  std::vector<Viewpoint> viewpoints_;
};

}  // namespace fallen
