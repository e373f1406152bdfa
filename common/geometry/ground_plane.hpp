// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/geometry/enum_names.hpp"
#include "fallen/geometry/plane.hpp"

/// Ground plane estimation (the paper, Sec. III-A): by mounting, by RANSAC, by v-disparity.
///
/// [Fischler81]  Fischler, Bolles: Random sample consensus. CACM 24(6), 1981.
/// [Labayrade02] Labayrade, Aubert, Tarel: Real time obstacle detection in stereovision on non flat
///               road geometry through "v-disparity" representation. IV 2002.
namespace fallen {

/// How the floor is found.
enum class GroundMethod : std::int32_t {
  /// `kMounting`, corrected by what the image shows, where the image carries a mounting;
  /// `kRansac`, else `kVDisparity`, where it does not.
  kAuto = 0,
  kMounting = 1,
  kRansac = 2,
  kVDisparity = 3,
};
constexpr auto EnumNames(GroundMethod) {
  return EnumTable<GroundMethod, 4>{{{GroundMethod::kAuto, "auto"},
                                     {GroundMethod::kMounting, "mounting"},
                                     {GroundMethod::kRansac, "ransac"},
                                     {GroundMethod::kVDisparity, "v_disparity"}}};
}

/// What came of it. Only with `kOk` does the plane mean anything.
enum class GroundStatus : std::int32_t {
  kOk = 0,
  kNoFloorInView = 1,  ///< an expected outcome: walls, a close object, the ceiling
  kTooFewPoints = 2,   ///< hardly any depth in the image
  kNoMounting = 3,     ///< asked for the mounting, but the image carries none
};
constexpr auto EnumNames(GroundStatus) {
  return EnumTable<GroundStatus, 4>{{{GroundStatus::kOk, "ok"},
                                     {GroundStatus::kNoFloorInView, "no_floor_in_view"},
                                     {GroundStatus::kTooFewPoints, "too_few_points"},
                                     {GroundStatus::kNoMounting, "no_mounting"}}};
}

struct GroundConfig {
  GroundMethod method = GroundMethod::kAuto;
  /// A point this close to the plane supports it [m], in (0, 1). Far points may be as far away as
  /// the noise of PrimeSense sensors takes them, three sigma.
  double inlier_distance_m = 0.03;
  /// Largest angle between the plane's normal and the expected up direction [deg], (0, 90): the
  /// cone. Expected is the mounting's up, or the image's up direction where no mounting is known.
  /// Tuned on 7-Scenes kitchen, a camera in the hand that looks down by up to 37 degrees.
  double max_tilt_deg = 40;
  /// With `kAuto` and a known mounting, how far the image may correct it: angle [deg], (0, 90), and
  /// height [m], > 0.
  double max_mounting_error_deg = 4;
  double max_mounting_error_m = 0.10;
  /// Camera heights that are possible on this robot [m], > 0. A table that fills the whole view is
  /// told from a floor by nothing else, unless a mounting is known.
  double min_camera_height_m = 0.2;
  double max_camera_height_m = 2.2;
  /// Least share of the measured points that must lie on the floor, (0, 1).
  double min_inlier_fraction = 0.03;
  /// Planes tried at most, [1, 1000000], and the seed of the generator that draws them.
  int ransac_iterations = 200;
  std::int64_t ransac_seed = 1;
  /// Points used by the estimators, [100, 10000000]: the image is thinned to about so many.
  int sample_points = 4000;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("method", method);
    visit("inlier_distance_m", inlier_distance_m);
    visit("max_tilt_deg", max_tilt_deg);
    visit("max_mounting_error_deg", max_mounting_error_deg);
    visit("max_mounting_error_m", max_mounting_error_m);
    visit("min_camera_height_m", min_camera_height_m);
    visit("max_camera_height_m", max_camera_height_m);
    visit("min_inlier_fraction", min_inlier_fraction);
    visit("ransac_iterations", ransac_iterations);
    visit("ransac_seed", ransac_seed);
    visit("sample_points", sample_points);
  }
};

/// A floor, and what a sceptic asks about it.
struct GroundEstimate {
  GroundStatus status = GroundStatus::kNoFloorInView;
  GroundMethod method = GroundMethod::kMounting;  ///< the one that gave the plane; never `kAuto`
  Plane plane;                    ///< normal up; camera frame, unless said otherwise
  std::int32_t inlier_count = 0;  ///< of the sampled points
  std::int32_t point_count = 0;   ///< sampled points

  bool ok() const { return status == GroundStatus::kOk; }
  bool operator==(const GroundEstimate&) const = default;
};

/// Finds the floor in `image` by the configured method.
///
/// With `kAuto`, a mounting, and no floor in view, the mounting's plane is the answer. `kMounting`
/// does not look at the pixels; on a VGA image RANSAC takes about 0.5 ms and v-disparity 1.4 ms.
/// @param T_robot_camera  Mounting, if known: robot frame with z up and its origin on the floor.
/// @return The plane in the camera frame, normal up, with a status.
/// @throws std::invalid_argument if `image`, `config` or the mounting (not rigid, or the camera not
///         above the floor) is malformed.
/// Deterministic for equal arguments. Thread-safe.
GroundEstimate EstimateGround(const DepthImage& image,
                              const std::optional<Eigen::Isometry3d>& T_robot_camera,
                              const GroundConfig& config = {});

/// Height of the camera above a plane, and how it is tilted over it.
struct CameraAttitude {
  double height_m = 0;
  double pitch_rad = 0;  ///< positive looks down
  double roll_rad = 0;   ///< about the view direction; positive if image right points down
};
CameraAttitude AttitudeOverGround(const Plane& ground_camera);

/// `T_level_camera` of the frame `level`: origin on the floor below the camera, z up, x along the
/// camera's view direction (for a camera that looks straight down: along its image's up).
Eigen::Isometry3d LevelFrameFromGround(const Plane& ground_camera);

}  // namespace fallen
