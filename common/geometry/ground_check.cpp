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
// Noise of the height of a floor point, in inverse depth three sigma of 1/8 pixel of disparity at a
// base of 0.075 m and f = 575 pixels; times depth and camera height, in metres.
constexpr double kNoiseReach = 3 * 0.0029;
// How far below a floor noise and reflections reach: this many inlier distances, and so much per
// squared metre of range.
constexpr double kBelowInlierDistances = 3;
constexpr double kBelowPerSqM = 0.005;
// Largest share of the points below a floor: none was seen below the floors of the real recordings
// at hand, 1 % and more below slanted cuts through a kitchen. And half of `min_inlier_fraction` at
// most, so that a table is refused wherever the floor under it could itself be accepted.
constexpr double kMaxShareBelow = 0.005;
constexpr double kMinWidth_m = 0.05;  // 1 sigma; a strip narrower than that does not fix a tilt
constexpr int kMaxRefinements = 6;
constexpr double kConverged = 1e-4;  // change of the inverse plane [1/m]
constexpr int kMinLevelPoints = 10;

// Tells how well points support a plane.
class SupportTest {
 public:
  // @param slack  Factor on the distance at which a point no longer counts.
  SupportTest(const Plane& plane, double inlier_distance_m, double slack = 1)
      : normal_(plane.normal.cast<float>()),
        offset_(static_cast<float>(plane.offset)),
        min_reach_(static_cast<float>(slack * inlier_distance_m)),
        reach_per_depth_(static_cast<float>(slack * kNoiseReach * plane.offset)) {}

  // Falls from 1 on the plane to 0 at the reach, and likewise over the last third of the deviation
  // of normals: the feet of walls, where normals turn from the floor's to the wall's, count little.
  float Score(const GroundPoint& point) const {
    const float direction = (normal_.dot(point.normal) - min_cosine_) / (1 - min_cosine_);
    if (direction <= 0) return 0;
    const float reach = std::max(min_reach_, reach_per_depth_ * point.position.z());
    const float distance = (normal_.dot(point.position) + offset_) / reach;
    return std::max(0.F, 1 - distance * distance) * std::min(2 * direction, 1.F);
  }

 private:
  Eigen::Vector3f normal_;
  float offset_;
  float min_reach_;
  float reach_per_depth_;
  float min_cosine_ = static_cast<float>(std::cos(kMaxNormalDeviation));
};

// What the points on a plane look like together.
struct Inliers {
  int count = 0;
  double score = 0;
  double width_m = 0;               // standard deviation across their longest direction
  double normal_deviation_rad = 0;  // of their mean normal from the plane's
};

Inliers DescribeInliers(const GroundScene& scene, const Plane& plane, double inlier_distance_m) {
  const SupportTest support(plane, inlier_distance_m);
  Inliers inliers;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  for (const GroundPoint& point : scene.level) {
    const double score = support.Score(point);
    if (score == 0) continue;
    const Eigen::Vector3d p = point.position.cast<double>();
    ++inliers.count;
    inliers.score += score;
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
  for (int i = 0; i < kMaxRefinements; ++i) {
    const SupportTest support(refined, inlier_distance_m, i == 0 ? kRoughSlack : 1);
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    for (const GroundPoint& point : scene.level) {
      const double score = support.Score(point);
      if (score == 0) continue;
      const double weight = score * score;  // Tukey's biweight
      const Eigen::Vector3d ray = point.ray.cast<double>();
      information += weight * ray * ray.transpose();
      vector += weight * point.inverse_depth * ray;
    }
    const Eigen::Vector3d inverse_plane = information.ldlt().solve(vector);
    const double length = inverse_plane.norm();
    const Plane next{-inverse_plane / length, 1 / length};
    if (!next.normal.allFinite() || !prior.Allows(next)) return refined;
    const double change = (inverse_plane + refined.normal / refined.offset).cwiseAbs().maxCoeff();
    refined = next;
    if (change < kConverged) break;
  }
  return refined;
}

bool HasPointsBelow(const GroundScene& scene, const Plane& plane, const GroundConfig& config,
                    double slack) {
  constexpr std::size_t kPasses = 16;
  const double share = std::min(kMaxShareBelow, config.min_inlier_fraction / 2);
  const int allowed = static_cast<int>(share * static_cast<double>(scene.points.size()));
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  const float margin = static_cast<float>(slack * kBelowInlierDistances * config.inlier_distance_m);
  const float margin_per_sq_m = static_cast<float>(slack * kBelowPerSqM);
  const float offset = static_cast<float>(plane.offset);
  int below = 0;
  // Interleaved, so that each pass covers the image: most planes are refused after a few hundred.
  for (std::size_t pass = 0; pass < kPasses; ++pass) {
    for (std::size_t i = pass; i < scene.points.size(); i += kPasses) {
      const Eigen::Vector3f& p = scene.points[i].position;
      below += normal.dot(p) + offset < -(margin + margin_per_sq_m * p.z() * p.z());
    }
    if (below > allowed) return true;
  }
  return false;
}

int CountInliers(const GroundScene& scene, const Plane& plane, double inlier_distance_m) {
  const SupportTest support(plane, inlier_distance_m);
  return static_cast<int>(
      std::count_if(scene.level.begin(), scene.level.end(),
                    [&](const GroundPoint& point) { return support.Score(point) > 0; }));
}

std::optional<Floor> AcceptFloor(const GroundScene& scene, const Plane& plane,
                                 const GroundPrior& prior, const GroundConfig& config) {
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
