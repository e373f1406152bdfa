// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "fallen/geometry/ground_plane.hpp"
#include "fallen/geometry/ground_points.hpp"

namespace fallen {

/// Where a floor may lie: what is known before the image is looked at.
struct GroundPrior {
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();  ///< expected normal, camera frame
  double max_tilt_rad = 0;                         ///< largest angle between normal and `up`
  double min_height_m = 0;                         ///< of the camera above the floor
  double max_height_m = 0;

  bool Allows(const Plane& plane) const;
};

/// The thinned image, sorted by what can be floor.
struct GroundScene {
  std::vector<GroundPoint> points;  ///< all
  std::vector<GroundPoint> level;   ///< those on surfaces that could be a floor by their direction
};
GroundScene MakeGroundScene(std::vector<GroundPoint> points, const GroundPrior& prior);

/// Fits the plane anew to the points that support it; gives back `plane` itself where that fails or
/// leaves the prior.
///
/// Robust least squares of inverse depth, whose noise is the same at all ranges, so that far points
/// count as much as they are worth.
Plane RefineFloor(const GroundScene& scene, const Plane& plane, const GroundPrior& prior,
                  double inlier_distance_m);

/// Slack for a plane through three points, which is off by an inlier distance or so.
inline constexpr double kRoughSlack = 2;

/// Says if so many points lie clearly below `plane` that it cannot be the floor: a floor has
/// (almost) none, but under a table top, a bed or a slanted cut through the furniture there is
/// something.
/// @param slack  Factor on the depth that counts as clearly below: 1, or more for a rough plane.
bool HasPointsBelow(const GroundScene& scene, const Plane& plane, const GroundConfig& config,
                    double slack = 1);

/// Points that lie on `plane`, within the inlier distance or three sigma of the sensor's noise, on
/// a surface of its direction.
int CountInliers(const GroundScene& scene, const Plane& plane, double inlier_distance_m);

/// A plane that passed every check.
struct Floor {
  Plane plane;
  int inliers = 0;
  double score = 0;  ///< inliers, weighted by how well they agree, as in [Torr00]
};

/// `plane` refined; nothing if it cannot be the floor of this scene.
///
/// [Torr00]  Torr, Zisserman: MLESAC. Computer Vision and Image Understanding 78, 2000.
std::optional<Floor> AcceptFloor(const GroundScene& scene, const Plane& plane,
                                 const GroundPrior& prior, const GroundConfig& config);

/// Least number of points of a floor that `config` accepts.
int MinInliers(const GroundScene& scene, const GroundConfig& config);

}  // namespace fallen
