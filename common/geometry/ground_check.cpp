// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_check.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace fallen {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180;
// A point's own normal may differ from its plane's by this much: three sigma of the normals of a
// floor 1.5 m below (ground_points.cpp).
constexpr double kMaxNormalDeviation = 30 * kRadPerDeg;
// The mean of those normals is much better than each: within 3 degrees on the floors of the real
// recordings, 22 degrees off on a plane that cut through a cluttered kitchen.
constexpr double kMaxMeanNormalDeviation = 8 * kRadPerDeg;
// How far below a floor noise and reflections reach: this many inlier distances, and so much per
// squared metre of range.
constexpr double kBelowInlierDistances = 3;
constexpr double kBelowPerSqM = 0.005;
// Largest share of the points below a floor: none was seen below the floors of the real recordings
// at hand, 1 % and more below slanted cuts through a kitchen. And half of `min_inlier_fraction` at
// most, so that a table is refused wherever the floor under it could itself be accepted.
constexpr double kMaxShareBelow = 0.005;
constexpr double kMinWidth_m = 0.05;  // 1 sigma; a strip narrower than that does not fix a tilt
constexpr int kRefinements = 3;
constexpr int kMinLevelPoints = 10;

// Tells which points support a plane.
class SupportTest {
 public:
  SupportTest(const Plane& plane, double inlier_distance_m)
      : normal_(plane.normal.cast<float>()),
        offset_(static_cast<float>(plane.offset)),
        inlier_distance_(static_cast<float>(inlier_distance_m)) {}

  bool operator()(const GroundPoint& point) const {
    static const float kMinCosine = static_cast<float>(std::cos(kMaxNormalDeviation));
    return std::abs(normal_.dot(point.position) + offset_) <= inlier_distance_ &&
           normal_.dot(point.normal) >= kMinCosine;
  }

 private:
  Eigen::Vector3f normal_;
  float offset_;
  float inlier_distance_;
};

// What the points on a plane look like together.
struct Inliers {
  int count = 0;
  double score = 0;
  double width_m = 0;               // standard deviation across their longest direction
  double normal_deviation_rad = 0;  // of their mean normal from the plane's
};

Inliers DescribeInliers(const GroundScene& scene, const Plane& plane, double inlier_distance_m) {
  const SupportTest supports(plane, inlier_distance_m);
  Inliers inliers;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  for (const GroundPoint& point : scene.level) {
    if (!supports(point)) continue;
    const Eigen::Vector3d p = point.position.cast<double>();
    const double distance = plane.SignedHeight(p) / inlier_distance_m;
    ++inliers.count;
    inliers.score += std::max(0.0, 1 - distance * distance);
    sum += p;
    squares += p * p.transpose();
    normal_sum += point.normal.cast<double>();
  }
  if (inliers.count < 3) return inliers;
  const Eigen::Vector3d mean = sum / inliers.count;
  const Eigen::Matrix3d covariance = squares / inliers.count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  inliers.width_m = std::sqrt(std::max(0.0, solver.eigenvalues()(1)));
  inliers.normal_deviation_rad =
      std::acos(std::clamp(normal_sum.normalized().dot(plane.normal), -1.0, 1.0));
  return inliers;
}

}  // namespace

bool GroundPrior::Allows(const Plane& plane) const {
  return plane.offset >= min_height_m && plane.offset <= max_height_m &&
         plane.normal.dot(up) >= std::cos(max_tilt_rad);
}

GroundScene MakeGroundScene(std::vector<GroundPoint> points, const GroundPrior& prior) {
  const float min_cosine = static_cast<float>(
      std::cos(std::min(prior.max_tilt_rad + kMaxNormalDeviation, 90 * kRadPerDeg)));
  const Eigen::Vector3f up = prior.up.cast<float>();
  GroundScene scene;
  scene.points = std::move(points);
  scene.level.reserve(scene.points.size());
  for (const GroundPoint& point : scene.points)
    if (point.normal.dot(up) > min_cosine) scene.level.push_back(point);
  return scene;
}

Plane RefineFloor(const GroundScene& scene, const Plane& plane, const GroundPrior& prior,
                  double inlier_distance_m) {
  Plane refined = plane;
  for (int i = 0; i < kRefinements; ++i) {
    const SupportTest supports(refined, inlier_distance_m);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    for (const GroundPoint& point : scene.level) {
      if (!supports(point)) continue;
      const Eigen::Vector3d ray = point.ray.cast<double>();
      information += ray * ray.transpose();
      vector += point.inverse_depth * ray;
    }
    const Eigen::Vector3d inverse_plane = information.ldlt().solve(vector);
    const double length = inverse_plane.norm();
    const Plane next{-inverse_plane / length, 1 / length};
    if (!next.normal.allFinite() || !prior.Allows(next)) return refined;
    refined = next;
  }
  return refined;
}

bool HasPointsBelow(const GroundScene& scene, const Plane& plane, const GroundConfig& config,
                    double slack) {
  const double share = std::min(kMaxShareBelow, config.min_inlier_fraction / 2);
  const int allowed = static_cast<int>(share * static_cast<double>(scene.points.size()));
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  const float margin = static_cast<float>(slack * kBelowInlierDistances * config.inlier_distance_m);
  const float margin_per_sq_m = static_cast<float>(slack * kBelowPerSqM);
  const float offset = static_cast<float>(plane.offset);
  int below = 0;
  for (const GroundPoint& point : scene.points) {
    const float z = point.position.z();
    below += normal.dot(point.position) + offset < -(margin + margin_per_sq_m * z * z);
    if (below > allowed) return true;
  }
  return false;
}

int CountInliers(const GroundScene& scene, const Plane& plane, double inlier_distance_m) {
  return static_cast<int>(
      std::count_if(scene.level.begin(), scene.level.end(), SupportTest(plane, inlier_distance_m)));
}

std::optional<Floor> AcceptFloor(const GroundScene& scene, const Plane& plane,
                                 const GroundPrior& prior, const GroundConfig& config) {
  constexpr double kRough = 2;  // a plane through three points is off by about its inlier distance
  if (HasPointsBelow(scene, plane, config, kRough)) return std::nullopt;
  const Plane refined = RefineFloor(scene, plane, prior, config.inlier_distance_m);
  const Inliers inliers = DescribeInliers(scene, refined, config.inlier_distance_m);
  if (inliers.count < MinInliers(scene, config) || inliers.width_m < kMinWidth_m ||
      inliers.normal_deviation_rad > kMaxMeanNormalDeviation ||
      HasPointsBelow(scene, refined, config))
    return std::nullopt;
  return Floor{refined, inliers.count, inliers.score};
}

int MinInliers(const GroundScene& scene, const GroundConfig& config) {
  const double share = config.min_inlier_fraction * static_cast<double>(scene.points.size());
  return std::max(kMinLevelPoints, static_cast<int>(std::ceil(share)));
}

}  // namespace fallen
