// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_plane.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fallen/geometry/ground_check.hpp"
#include "fallen/geometry/ground_points.hpp"
#include "fallen/geometry/ground_ransac.hpp"
#include "fallen/geometry/ground_v_disparity.hpp"

namespace fallen {
namespace {

constexpr double kRotationTolerance = 1e-6;  // a mounting in YAML carries six digits or more

void ValidateMounting(const Eigen::Isometry3d& T_robot_camera) {
  const Eigen::Matrix3d& R = T_robot_camera.linear();
  if (!T_robot_camera.matrix().allFinite() || R.determinant() < 0 ||
      !(R * R.transpose()).isIdentity(kRotationTolerance))
    throw std::invalid_argument("ground: T_robot_camera must be finite, with a rotation matrix");
  if (T_robot_camera.translation().z() <= 0)
    throw std::invalid_argument("ground: T_robot_camera has the camera at height " +
                                std::to_string(T_robot_camera.translation().z()) +
                                " m, must be above the floor, z = 0");
}

// The robot's plane z = 0 seen from the camera.
GroundEstimate GroundFromMounting(const Eigen::Isometry3d& T_robot_camera) {
  GroundEstimate estimate;
  estimate.status = GroundStatus::kOk;
  estimate.method = GroundMethod::kMounting;
  estimate.plane.normal = T_robot_camera.linear().row(2).transpose();
  estimate.plane.offset = T_robot_camera.translation().z();
  return estimate;
}

// Fewer measured points than this, or a smaller share of the thinned image, say nothing.
constexpr int kMinPoints = 50;
constexpr double kMinMeasuredShare = 0.01;

double RadFromDeg(double degrees) { return degrees * 3.14159265358979323846 / 180; }

bool HasEnoughPoints(const std::vector<GroundPoint>& points, const GroundConfig& config) {
  return static_cast<double>(points.size()) >=
         std::max<double>(kMinPoints, kMinMeasuredShare * config.sample_points);
}

// The whole range of floors that the configuration allows.
GroundPrior WidePrior(const std::optional<Eigen::Isometry3d>& T_robot_camera,
                      const GroundConfig& config) {
  GroundPrior prior;
  if (T_robot_camera) prior.up = T_robot_camera->linear().row(2).transpose();
  prior.max_tilt_rad = RadFromDeg(config.max_tilt_deg);
  prior.min_height_m = config.min_camera_height_m;
  prior.max_height_m = config.max_camera_height_m;
  return prior;
}

// What the mounting leaves open.
GroundPrior NarrowPrior(const Plane& mounting, const GroundConfig& config) {
  GroundPrior prior;
  prior.up = mounting.normal;
  prior.max_tilt_rad = RadFromDeg(config.max_mounting_error_deg);
  prior.min_height_m = std::max(mounting.offset - config.max_mounting_error_m, 0.0);
  prior.max_height_m = mounting.offset + config.max_mounting_error_m;
  return prior;
}

GroundEstimate MakeEstimate(const std::optional<Floor>& floor, GroundMethod method,
                            const GroundScene& scene) {
  GroundEstimate estimate;
  estimate.status = floor ? GroundStatus::kOk : GroundStatus::kNoFloorInView;
  estimate.method = method;
  estimate.point_count = static_cast<std::int32_t>(scene.points.size());
  if (!floor) return estimate;
  estimate.plane = floor->plane;
  estimate.inlier_count = floor->inliers;
  return estimate;
}

GroundEstimate CorrectMounting(const Plane& mounting, std::vector<GroundPoint> points,
                               const GroundConfig& config) {
  const bool enough = HasEnoughPoints(points, config);
  const GroundPrior prior = NarrowPrior(mounting, config);
  const GroundScene scene = MakeGroundScene(std::move(points), prior);
  const std::optional<Floor> floor =
      enough ? FindFloorByRansac(scene, prior, config) : std::nullopt;
  if (floor) return MakeEstimate(floor, GroundMethod::kRansac, scene);
  const int inliers = CountInliers(scene, mounting, config.inlier_distance_m);
  return MakeEstimate(Floor{mounting, inliers, 0}, GroundMethod::kMounting, scene);
}

GroundEstimate EstimateFromImage(std::vector<GroundPoint> points,
                                 const std::optional<Eigen::Isometry3d>& T_robot_camera,
                                 const GroundConfig& config) {
  const GroundPrior prior = WidePrior(T_robot_camera, config);
  const GroundScene scene = MakeGroundScene(std::move(points), prior);
  if (config.method != GroundMethod::kVDisparity) {
    const std::optional<Floor> floor = FindFloorByRansac(scene, prior, config);
    if (floor || config.method == GroundMethod::kRansac)
      return MakeEstimate(floor, GroundMethod::kRansac, scene);
  }
  return MakeEstimate(FindFloorByVDisparity(scene, prior, T_robot_camera.has_value(), config),
                      GroundMethod::kVDisparity, scene);
}

}  // namespace

GroundEstimate EstimateGround(const DepthImage& image,
                              const std::optional<Eigen::Isometry3d>& T_robot_camera,
                              const GroundConfig& config) {
  image.Validate();
  config.Validate();
  if (T_robot_camera) ValidateMounting(*T_robot_camera);
  if (config.method == GroundMethod::kMounting) {
    if (T_robot_camera) return GroundFromMounting(*T_robot_camera);
    GroundEstimate none;
    none.status = GroundStatus::kNoMounting;
    return none;
  }

  std::vector<GroundPoint> points = SampleGroundPoints(image, config.sample_points);
  if (config.method == GroundMethod::kAuto && T_robot_camera)
    return CorrectMounting(GroundFromMounting(*T_robot_camera).plane, std::move(points), config);
  if (HasEnoughPoints(points, config))
    return EstimateFromImage(std::move(points), T_robot_camera, config);
  GroundEstimate blind;
  blind.status = GroundStatus::kTooFewPoints;
  blind.method = config.method == GroundMethod::kVDisparity ? GroundMethod::kVDisparity
                                                            : GroundMethod::kRansac;
  blind.point_count = static_cast<std::int32_t>(points.size());
  return blind;
}

}  // namespace fallen
