// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/person_placement.hpp"

#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTries = 400;
constexpr double kFreeMargin = 0.08;  // [m], a hand's breadth
constexpr double kPushStep = 0.01;    // [m]
constexpr double kUnderShare = 0.1;   // of the points that must be covered to count as under

// The mesh's surface as points, spread out evenly.
std::vector<Eigen::Vector3d> Sample(const TriangleMesh& mesh) {
  constexpr std::size_t kPoints = 1500;
  const std::size_t step = std::max<std::size_t>(1, mesh.vertices.size() / kPoints);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < mesh.vertices.size(); i += step)
    points.push_back(mesh.vertices[i].cast<double>());
  return points;
}

class Placer {
 public:
  Placer(const TriangleMesh& mesh, const ColumnGrid& grid) : points_(Sample(mesh)), grid_(grid) {}

  // Whether any point is in something, or comes closer than a margin in the horizontal.
  bool Collides(const FloorPose& pose, double margin_m) const {
    const Eigen::Rotation2Dd rotation(pose.yaw);
    for (const Eigen::Vector3d& point : points_) {
      const Eigen::Vector2d p = rotation * point.head<2>() + pose.position;
      const double z = std::max(0.01, point.z());
      if (grid_.Taken({p.x(), p.y(), z})) return true;
      if (margin_m <= 0) continue;
      for (const double dx : {-margin_m, margin_m})
        if (grid_.Taken({p.x() + dx, p.y(), z}) || grid_.Taken({p.x(), p.y() + dx, z})) return true;
    }
    return false;
  }

  const Eigen::Vector3d& AnyPoint(Random& random) const { return random.Pick(points_); }

  double CoveredShare(const FloorPose& pose) const {
    const Eigen::Rotation2Dd rotation(pose.yaw);
    int covered = 0;
    for (const Eigen::Vector3d& point : points_) {
      const Eigen::Vector2d p = rotation * point.head<2>() + pose.position;
      covered += grid_.Covered({p.x(), p.y(), point.z()});
    }
    return covered / static_cast<double>(points_.size());
  }

 private:
  std::vector<Eigen::Vector3d> points_;
  const ColumnGrid& grid_;
};

std::optional<FloorPose> Free(const Placer& placer, const std::optional<double>& yaw,
                              const Scene& scene, Random& random) {
  for (const double margin : {kFreeMargin, kFreeMargin / 3, 0.0}) {
    for (int i = 0; i < kTries; ++i) {
      FloorPose pose;
      const Eigen::Vector2d half = scene.room_size / 2;
      pose.position = {random.Uniform(-half.x(), half.x()), random.Uniform(-half.y(), half.y())};
      pose.yaw = yaw.value_or(random.Uniform(-kPi, kPi));
      if (!placer.Collides(pose, margin)) return pose;
    }
  }
  return std::nullopt;
}

// From a collision-free start within reach of a piece, straight towards it until something is in
// the way.
std::optional<FloorPose> Touching(const Placer& placer, const std::optional<double>& yaw,
                                  const Scene& scene, Random& random) {
  if (scene.objects.empty()) return std::nullopt;
  for (int i = 0; i < kTries; ++i) {
    const OrientedBox& piece = random.Pick(scene.objects).box;
    const double angle = random.Uniform(-kPi, kPi);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const double reach = piece.size.head<2>().norm() / 2 + 1.2;
    FloorPose pose;
    pose.yaw = yaw.value_or(random.Uniform(-kPi, kPi));
    pose.position = piece.center.head<2>() + reach * direction +
                    random.Normal(0, 0.25) * Eigen::Vector2d(-direction.y(), direction.x());
    if (placer.Collides(pose, 0)) continue;
    for (double pushed = 0; pushed < reach; pushed += kPushStep) {
      FloorPose next = pose;
      next.position -= kPushStep * direction;
      if (placer.Collides(next, 0)) {
        pose.reached = Placement::kTouching;
        return pose;
      }
      pose = next;
    }
  }
  return std::nullopt;
}

// Some point of the body below some point of a piece that leaves room below.
std::optional<FloorPose> Under(const Placer& placer, const std::optional<double>& yaw,
                               const Scene& scene, Random& random) {
  constexpr double kLowest = 0.3, kHighest = 1.2;  // [m], of what one gets under
  std::vector<const OrientedBox*> pieces;
  for (const SceneObject& object : scene.objects)
    if (object.box.size.z() > kLowest && object.box.size.z() < kHighest)
      pieces.push_back(&object.box);
  if (pieces.empty()) return std::nullopt;
  for (int i = 0; i < 10 * kTries; ++i) {
    const OrientedBox& piece = *random.Pick(pieces);
    const Eigen::Vector2d within(random.Uniform(-0.5, 0.5) * piece.size.x(),
                                 random.Uniform(-0.5, 0.5) * piece.size.y());
    FloorPose pose;
    pose.yaw = yaw.value_or(random.Uniform(-kPi, kPi));
    pose.position = piece.center.head<2>() + Eigen::Rotation2Dd(piece.yaw) * within -
                    Eigen::Rotation2Dd(pose.yaw) * placer.AnyPoint(random).head<2>();
    if (placer.CoveredShare(pose) < kUnderShare || placer.Collides(pose, 0)) continue;
    pose.reached = Placement::kUnder;
    return pose;
  }
  return std::nullopt;
}

}  // namespace

std::optional<FloorPose> PlaceOnFloor(const TriangleMesh& mesh, Placement placement,
                                      const std::optional<double>& yaw, const ColumnGrid& grid,
                                      const Scene& scene, Random& random) {
  const Placer placer(mesh, grid);
  if (placement == Placement::kUnder)
    if (const auto pose = Under(placer, yaw, scene, random)) return pose;
  if (placement != Placement::kFree)
    if (const auto pose = Touching(placer, yaw, scene, random)) return pose;
  return Free(placer, yaw, scene, random);
}

}  // namespace fallen::sim
