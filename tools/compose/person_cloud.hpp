// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// A small disc of a surface.
struct Splat {
  Eigen::Vector3d position;  ///< [m]
  Eigen::Vector3d normal;    ///< unit vector, sign arbitrary
  double sigma_m = 0;  ///< standard deviation of its Gaussian weight: as wide as points are apart
};

/// Which way is up in a cloud.
enum class CloudUp : std::int32_t {
  kMinusY = 0,  ///< a camera's optical frame
  kZ = 1,
};
constexpr auto EnumNames(CloudUp) {
  return EnumTable<CloudUp, 2>{{{CloudUp::kMinusY, "-y"}, {CloudUp::kZ, "z"}}};
}

/// The surface of a lying person. Frame "person": on the floor below the middle of the person, z
/// up, x away from where the cloud was taken from (the cloud's origin).
struct PersonCloud {
  std::vector<Splat> splats;
  OrientedBox box;  ///< around the points, from the floor up; its x runs along the person
};

/// Makes a surface of the points of a lying person, with the lowest of them on the floor, or as
/// high above it as whoever took the floor away also took the person's.
/// @param points       At least 50 [m]; nothing but the person.
/// @param floor_cut_m  Up to this height nothing is left, >= 0: the surface goes on straight down
///                     from the points above it.
/// @throws std::invalid_argument for too few points.
/// Deterministic. O(n log n).
PersonCloud MakePersonCloud(const std::vector<Eigen::Vector3d>& points, CloudUp up,
                            double floor_cut_m = 0);

/// The same from a PLY or PCD file. @throws std::runtime_error naming the file.
PersonCloud LoadPersonCloud(const std::filesystem::path& file, CloudUp up, double floor_cut_m);

}  // namespace fallen
