// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/moved_furniture.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "tools/simulate/column_grid.hpp"
#include "tools/simulate/person_placement.hpp"

namespace fallen::sim {
namespace {

constexpr double kLeastMoveM = 0.5;
constexpr int kTries = 8;

/// The pieces to move: a partial shuffle by hand, for std::shuffle differs between libraries.
std::vector<std::size_t> Choose(std::vector<std::size_t> pieces, double share, Random& random) {
  const auto count =
      static_cast<std::size_t>(std::llround(share * static_cast<double>(pieces.size())));
  for (std::size_t i = 0; i < count; ++i)
    std::swap(pieces[i], pieces[i + random.Index(pieces.size() - i)]);
  pieces.resize(count);
  return pieces;
}

/// The mesh of a piece around its own origin on the floor.
TriangleMesh AroundOrigin(const SceneObject& piece) {
  TriangleMesh mesh = piece.mesh;
  const Eigen::Vector3d offset(piece.box.center.x(), piece.box.center.y(), 0);
  mesh.Transform(Eigen::AngleAxisf(static_cast<float>(-piece.box.yaw), Eigen::Vector3f::UnitZ()) *
                 Eigen::Translation3f(-offset.cast<float>()));
  return mesh;
}

std::optional<FloorPose> FindOtherPlace(const SceneObject& piece, const TriangleMesh& mesh,
                                        const ColumnGrid& grid, const Scene& scene,
                                        Random& random) {
  for (int i = 0; i < kTries; ++i) {
    const double yaw = piece.box.yaw + random.Index(4) * std::numbers::pi / 2;
    const auto place = PlaceOnFloor(mesh, Placement::kFree, yaw, grid, scene, random);
    if (place && (place->position - piece.box.center.head<2>()).norm() >= kLeastMoveM) return place;
  }
  return std::nullopt;
}

}  // namespace

int MoveFurniture(Scene& scene, double share, Random& random) {
  std::vector<std::size_t> pieces(scene.objects.size());
  std::iota(pieces.begin(), pieces.end(), std::size_t{0});
  std::erase_if(pieces, [&](std::size_t i) { return scene.objects[i].category != kFurniture; });
  int moved = 0;
  for (const std::size_t index : Choose(std::move(pieces), share, random)) {
    SceneObject& piece = scene.objects[index];
    ColumnGrid others(scene.room_size);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
      if (i != index) others.Add(scene.objects[i].mesh);
    TriangleMesh mesh = AroundOrigin(piece);
    const auto place = FindOtherPlace(piece, mesh, others, scene, random);
    if (!place) continue;
    piece = PlaceObject(piece.category, piece.name, std::move(mesh),
                        {place->position.x(), place->position.y(), 0}, place->yaw);
    ++moved;
  }
  return moved;
}

}  // namespace fallen::sim
