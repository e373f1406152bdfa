// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/geometry/ground_ransac.hpp"

#include <pcl/point_types.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace fallen {
namespace {

using FloorModel = pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ>;

// Triples drawn per plane tried: many are refused by their own points' normals, at a small part of
// the cost of a trial.
constexpr int kDrawsPerIteration = 20;
// Cosine of the largest angle between a triple's plane and its points' normals: 30 degrees.
constexpr float kMinNormalCosine = 0.866F;
// The second and the third point are looked for on the surface of the first: so many tries, and the
// sine of the largest angle between its tangent plane and the line to them, 15 degrees.
constexpr int kTriesPerPoint = 10;
constexpr float kMaxTangentSine = 0.26F;

constexpr double kMissProbability = 1e-4;
// A plane through three points is refined if it has this part of the points that a floor needs, and
// of those that the best one had before it was refined: it may still gain as many.
constexpr double kPartOfNeeded = 0.5;
constexpr double kPartOfBest = 0.8;

pcl::PointCloud<pcl::PointXYZ>::Ptr MakeCloud(const std::vector<GroundPoint>& points) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(points.size());
  for (const GroundPoint& point : points)
    cloud->push_back({point.position.x(), point.position.y(), point.position.z()});
  return cloud;
}

// Draws points, first anywhere and then on the surface of another.
class PointDrawer {
 public:
  // PCL's own generator cannot be seeded from outside, so the draws are ours.
  PointDrawer(const std::vector<GroundPoint>& points, std::int64_t seed)
      : points_(points), random_(static_cast<std::uint64_t>(seed)) {}

  const GroundPoint& Draw() { return points_[random_() % points_.size()]; }

  // The last point that was tried if none of them lies on the surface of `first`.
  const GroundPoint& DrawNear(const GroundPoint& first) {
    const GroundPoint* point = &first;
    for (int i = 0; i < kTriesPerPoint; ++i) {
      point = &Draw();
      const Eigen::Vector3f line = point->position - first.position;
      const float height = first.normal.dot(line);
      if (height * height <= kMaxTangentSine * kMaxTangentSine * line.squaredNorm()) break;
    }
    return *point;
  }

 private:
  const std::vector<GroundPoint>& points_;
  std::mt19937_64 random_;
};

// Plane through three points with its normal up: the camera, at the origin, is above the floor.
// Nothing if its normal is not that of the surfaces that the points lie on, as for collinear
// points.
std::optional<Plane> PlaneOfSurface(const GroundPoint& a, const GroundPoint& b,
                                    const GroundPoint& c) {
  Eigen::Vector3f normal = (b.position - a.position).cross(c.position - a.position);
  const float offset = -normal.dot(a.position);
  const float scale = (offset < 0 ? -1 : 1) / normal.norm();
  normal *= scale;
  for (const GroundPoint* point : {&a, &b, &c})
    if (!(normal.dot(point->normal) >= kMinNormalCosine)) return std::nullopt;
  return Plane{normal.cast<double>().normalized(), static_cast<double>(offset * scale)};
}

Eigen::VectorXf Coefficients(const Plane& plane) {
  Eigen::VectorXf coefficients(4);
  coefficients << plane.normal.cast<float>(), static_cast<float>(plane.offset);
  return coefficients;
}

// Draws after which a triple on a plane with so many of the points has come up as good as surely,
// [Fischler81] Sec. II-B: as if two of the three were drawn independently, which is cautious, as
// the second and the third are looked for on the surface of the first.
int DrawsForInliers(int inliers, std::size_t points) {
  const double share = static_cast<double>(inliers) / static_cast<double>(points);
  const double hit = std::clamp(share * share, 1e-9, 0.999);
  return static_cast<int>(std::ceil(std::log(kMissProbability) / std::log(1 - hit)));
}

}  // namespace

std::optional<Floor> FindFloorByRansac(const GroundScene& scene, const GroundPrior& prior,
                                       const GroundConfig& config) {
  const int min_inliers = MinInliers(scene, config);
  if (static_cast<int>(scene.level.size()) < min_inliers) return std::nullopt;
  FloorModel model(MakeCloud(scene.level));
  model.setAxis(prior.up.cast<float>());
  model.setEpsAngle(prior.max_tilt_rad);

  PointDrawer drawer(scene.level, config.ransac_seed);
  std::optional<Floor> best;
  int best_near = 0;
  int trials = 0;
  int draws_wanted = kDrawsPerIteration * config.ransac_iterations;
  for (int draws = 0; draws < draws_wanted && trials < config.ransac_iterations; ++draws) {
    const GroundPoint& a = drawer.Draw();
    const GroundPoint& b = drawer.DrawNear(a);
    const GroundPoint& c = drawer.DrawNear(a);
    const std::optional<Plane> candidate = PlaneOfSurface(a, b, c);
    if (!candidate || !prior.Allows(*candidate)) continue;
    ++trials;
    if (HasPointsBelow(scene, *candidate, config, kRoughSlack)) continue;  // cheaper than to count
    const int near = static_cast<int>(
        model.countWithinDistance(Coefficients(*candidate), config.inlier_distance_m));
    if (near < kPartOfNeeded * min_inliers || near < kPartOfBest * best_near) continue;
    const std::optional<Floor> floor = AcceptFloor(scene, *candidate, prior, config);
    if (!floor || (best && floor->score <= best->score)) continue;
    best = floor;
    best_near = near;
    draws_wanted = std::min(draws_wanted, DrawsForInliers(best->inliers, scene.level.size()));
  }
  return best;
}

}  // namespace fallen
