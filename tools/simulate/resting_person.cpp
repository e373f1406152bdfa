// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/resting_person.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "tools/simulate/furniture_catalogue.hpp"
#include "tools/simulate/persons.hpp"

namespace fallen::sim {
namespace {

// Bodies of bystanders are none of the numbered ones that recordings are split by.
constexpr int kFirstSleeper = 2000000;

std::vector<const SceneObject*> Beds(const Scene& scene, FurnitureRole role) {
  std::vector<const SceneObject*> beds;
  for (const SceneObject& object : scene.objects)
    if (object.category == kFurniture && RoleOf(object.name) == role) beds.push_back(&object);
  return beds;
}

// Point of the scene in the piece's own frame: x along its width, y towards its back.
Eigen::Vector3d ToPiece(const OrientedBox& box, const Eigen::Vector3d& p) {
  const Eigen::Vector3d offset(p.x() - box.center.x(), p.y() - box.center.y(), p.z());
  return Eigen::AngleAxisd(-box.yaw, Eigen::Vector3d::UnitZ()) * offset;
}

// Height of what one lies on: the upper vertices in the middle, in front of the back.
double LyingHeight(const SceneObject& piece) {
  constexpr double kHighest = 0.75;  // [m], above that are backs and canopies
  constexpr double kShare = 0.85;    // of the heights below: the surface, not a cushion on it
  std::vector<double> heights;
  for (const Eigen::Vector3f& vertex : piece.mesh.vertices) {
    const Eigen::Vector3d p = ToPiece(piece.box, vertex.cast<double>());
    if (std::abs(p.x()) < 0.35 * piece.box.size.x() && p.y() < 0.1 * piece.box.size.y() &&
        p.y() > -0.4 * piece.box.size.y() && p.z() < kHighest && p.z() > 0.2)
      heights.push_back(p.z());
  }
  constexpr double kUsual = 0.45;
  if (heights.empty()) return kUsual;
  const auto place = heights.begin() +
                     static_cast<std::ptrdiff_t>(kShare * static_cast<double>(heights.size() - 1));
  std::nth_element(heights.begin(), place, heights.end());
  return *place;
}

}  // namespace

std::optional<SceneObject> MakeRestingPerson(const HumanModel& humans, const Scene& scene,
                                             Random& random) {
  std::vector<const SceneObject*> pieces = Beds(scene, FurnitureRole::kSofa);
  const bool on_bed = pieces.empty();
  if (on_bed) pieces = Beds(scene, FurnitureRole::kBed);
  if (pieces.empty()) return std::nullopt;
  const SceneObject& piece = *random.Pick(pieces);
  constexpr PoseFamily kAsleep[] = {PoseFamily::kSupine, PoseFamily::kSideLeft,
                                    PoseFamily::kSideRight, PoseFamily::kSupineHandOnBelly};
  const BodyShape shape = DrawBodyShape(kFirstSleeper + random.Index(1000));
  PersonMesh person =
      MakeLyingPerson(humans, shape, kAsleep[random.Index(std::size(kAsleep))], random);
  // Heads lie at the back of beds and at either end of sofas; the mesh has its pelvis at the
  // origin.
  const double turn = on_bed ? std::numbers::pi / 2 : (random.Chance(0.5) ? std::numbers::pi : 0);
  const Eigen::Vector3f middle = person.mesh.Bounds().center();
  person.mesh.Transform(Eigen::Affine3f(Eigen::Translation3f(-middle.x(), -middle.y(), 0)));
  const double forward = on_bed ? 0 : -0.08 * piece.box.size.y();  // away from the sofa's back
  const Eigen::Vector3d place =
      Eigen::AngleAxisd(piece.box.yaw, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0, forward, 0);
  SceneObject object = PlaceObject(
      kResting, "sleeper-" + std::to_string(shape.id), std::move(person.mesh),
      {piece.box.center.x() + place.x(), piece.box.center.y() + place.y(), LyingHeight(piece)},
      piece.box.yaw + turn);
  object.box = BoxAround(object.mesh, MainAxisYaw(object.mesh));
  return object;
}

}  // namespace fallen::sim
