// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// Where somebody could lie, seen from the camera.
struct Place {
  double distance_m = 0;   ///< from the point below the camera to the person's middle
  double bearing_rad = 0;  ///< from the viewing direction, to the left
  double turn_rad = 0;     ///< how the person is turned from the aspect that the cloud shows

  /// `T_level_person`; level as in LevelFrameFromGround, person as in PersonCloud.
  Eigen::Isometry3d Pose() const;
};

struct PlaceSearch {
  double min_distance_m = 1.5;
  double max_distance_m = 3.5;
  std::vector<double> turns_rad = {0};  ///< those that may be used
};

/// `box` of frame "person" at `place`, in frame "level".
OrientedBox BoxAt(const Place& place, const OrientedBox& box);

/// Finds the places at which the box lies on free floor: most of its footprint is seen to be floor,
/// and nothing stands on it.
/// @param T_level_camera  See LevelFrameFromGround.
/// @param box   Of the person, frame "person".
/// @return  Ring by ring with growing distance; inside a ring from right to left.
std::vector<Place> FindFreePlaces(const DepthImage& image, const Eigen::Isometry3d& T_level_camera,
                                  const OrientedBox& box, const PlaceSearch& search);

/// The places in the order in which to try them: at random, but such that those of a start of the
/// list are as different in distance as they can be.
/// @param seed  Same seed, same order.
std::vector<Place> OrderPlaces(std::vector<Place> places, std::uint64_t seed);

}  // namespace fallen
