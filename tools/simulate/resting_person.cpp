// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/resting_person.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/simulate/furniture_catalogue.hpp"
#include "tools/simulate/persons.hpp"

namespace fallen::sim {
namespace {

// Bodies of bystanders are none of the numbered ones that recordings are split by.
constexpr int kFirstSleeper = 2000000;

std::vector<const SceneObject*> Pieces(const Scene& scene,
                                       std::initializer_list<FurnitureRole> roles) {
  std::vector<const SceneObject*> pieces;
  for (const SceneObject& object : scene.objects)
    for (const FurnitureRole role : roles)
      if (object.category == kFurniture && RoleOf(object.name) == role) pieces.push_back(&object);
  return pieces;
}

// Height of the mesh above a point on the floor, or nothing where there is none.
std::optional<double> TopAt(const TriangleMesh& mesh, const Eigen::Vector2f& p) {
  std::optional<double> top;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.vertices[triangle[0]];
    const Eigen::Vector3f ab = mesh.vertices[triangle[1]] - a, ac = mesh.vertices[triangle[2]] - a;
    const Eigen::Vector2f ap = p - a.head<2>();
    const float area = ab.x() * ac.y() - ab.y() * ac.x();
    if (std::abs(area) < 1e-9f) continue;
    const float s = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
    const float t = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
    if (s < 0 || t < 0 || s + t > 1) continue;
    top = std::max<double>(top.value_or(0), a.z() + s * ab.z() + t * ac.z());
  }
  return top;
}

// Height of what one lies or sits on: in the middle of the piece and in front of its back.
double SurfaceHeight(const SceneObject& piece) {
  constexpr double kLowest = 0.2, kHighest = 0.75;  // [m], above that are backs and canopies
  constexpr double kShare = 0.6;  // of the heights below: the surface, not a cushion on it
  std::vector<double> heights;
  for (double x = -0.3; x <= 0.3; x += 0.1) {
    for (double y = -0.35; y <= 0.1; y += 0.09) {
      const Eigen::Vector2d p = piece.box.center.head<2>() +
                                Eigen::Rotation2Dd(piece.box.yaw) *
                                    Eigen::Vector2d(x * piece.box.size.x(), y * piece.box.size.y());
      const auto top = TopAt(piece.mesh, p.cast<float>());
      if (top && *top > kLowest && *top < kHighest) heights.push_back(*top);
    }
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
  const auto pieces = Pieces(scene, {FurnitureRole::kSofa, FurnitureRole::kBed});
  if (pieces.empty()) return std::nullopt;
  const SceneObject& piece = *random.Pick(pieces);
  const bool on_bed = RoleOf(piece.name) == FurnitureRole::kBed;
  constexpr PoseFamily kAsleep[] = {PoseFamily::kSupine,       PoseFamily::kSideLeft,
                                    PoseFamily::kSideRight,    PoseFamily::kProne,
                                    PoseFamily::kCurledLeft,   PoseFamily::kSupineHandOnBelly,
                                    PoseFamily::kSupine,       PoseFamily::kCurledRight,
                                    PoseFamily::kSupineKneeUp, PoseFamily::kSupineArmsUp};
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
      {piece.box.center.x() + place.x(), piece.box.center.y() + place.y(), SurfaceHeight(piece)},
      piece.box.yaw + turn);
  object.box = BoxAround(object.mesh, MainAxisYaw(object.mesh));
  return object;
}

std::optional<SceneObject> MakeSeatedPerson(const HumanModel& humans, const Scene& scene,
                                            Random& random) {
  const auto pieces = Pieces(scene, {FurnitureRole::kSofa, FurnitureRole::kArmchair,
                                     FurnitureRole::kChair, FurnitureRole::kBed});
  if (pieces.empty()) return std::nullopt;
  const SceneObject& piece = *random.Pick(pieces);
  const BodyShape shape = DrawBodyShape(kFirstSleeper + random.Index(1000));
  TriangleMesh mesh = MakeSittingPerson(humans, shape, SurfaceHeight(piece), random);
  const Eigen::Vector3d& size = piece.box.size;
  const double reach = std::max(0.0, size.x() / 2 - 0.4);
  // The middle of a chair; the front of what is deep enough to lie on.
  const double behind_front = std::min(size.y() / 2 + 0.05, 0.45);
  const Eigen::Vector3d place =
      Eigen::AngleAxisd(piece.box.yaw, Eigen::Vector3d::UnitZ()) *
      Eigen::Vector3d(random.Uniform(-reach, reach), behind_front - size.y() / 2, 0);
  return PlaceObject(kSeated, "seated-" + std::to_string(shape.id), std::move(mesh),
                     {piece.box.center.x() + place.x(), piece.box.center.y() + place.y(), 0},
                     piece.box.yaw - std::numbers::pi / 2 + random.Normal(0, 0.15));
}

}  // namespace fallen::sim
