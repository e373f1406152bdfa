// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/persons.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "tools/simulate/lying_props.hpp"

namespace fallen::sim {
namespace {

// The dressed body in a pose; what would be below the floor lies flat on it.
TriangleMesh PosedMesh(const HumanModel& model, const RestBody& body, const BodyRig& rig,
                       const BodyPose& pose) {
  BodyRig::BoneTransforms transforms;
  rig.Transform(pose, transforms);
  const Eigen::Matrix3Xf skinned = Skin(model, transforms, body.dressed);
  const BodySurface surface = MakeBodySurface(model, body.shape);
  TriangleMesh mesh;
  std::map<std::uint32_t, std::uint32_t> index;  // only vertices that are drawn
  for (const auto& triangle : surface.triangles) {
    std::array<std::uint32_t, 3> renumbered{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [entry, added] =
          index.try_emplace(triangle[k], static_cast<std::uint32_t>(mesh.vertices.size()));
      if (added) {
        Eigen::Vector3f vertex = skinned.col(triangle[k]);
        vertex.z() = std::max(0.0f, vertex.z());
        mesh.vertices.push_back(vertex);
      }
      renumbered[k] = entry->second;
    }
    mesh.triangles.push_back(renumbered);
  }
  mesh.albedo = surface.albedo;
  return mesh;
}

// R_world_rest of somebody upright who faces +x.
Eigen::Quaterniond UprightOrientation() {
  Eigen::Matrix3d R_world_rest;
  R_world_rest << 0, 0, 1,  //
      1, 0, 0,              //
      0, 1, 0;
  return Eigen::Quaterniond(R_world_rest);
}

double LowestSkin(const HumanModel& model, const RestBody& body, const BodyRig& rig,
                  const BodyPose& pose) {
  BodyRig::BoneTransforms transforms;
  rig.Transform(pose, transforms);
  const Eigen::Matrix3Xf skinned = Skin(model, transforms, body.skin);
  double lowest = 1e9;
  for (const int v : body.body_vertices) lowest = std::min<double>(lowest, skinned(2, v));
  return lowest;
}

void DrawArms(const BodyRig& rig, BodyPose& pose, double forward, Random& random) {
  for (const Side side : {kLeft, kRight}) {
    const double out = random.Uniform(0.1, 0.35);
    pose.arms[side].root = rig.LimbRotation(
        Limb::kArm, side, {side == kLeft ? out : -out, -1, forward + random.Uniform(-0.15, 0.3)},
        random.Uniform(-0.5, 0.5));
    pose.arms[side].hinge = random.Uniform(0.1, 1.2);
  }
}

void SetLeg(const BodyRig& rig, BodyPose& pose, Side side, double hip, double knee, double out) {
  LimbPose& leg = pose.legs[side];
  leg.root = rig.LimbRotation(Limb::kLeg, side,
                              {side == kLeft ? out : -out, -std::cos(hip), std::sin(hip)}, 0);
  leg.hinge = knee;
  leg.tip = knee - hip;  // the sole stays level
}

// Slumped on the floor, legs ahead, back and head towards +x.
BodyPose DrawHalfSitting(const BodyRig& rig, Random& random) {
  BodyPose pose;
  const double lean_back = random.Uniform(0.3, 1.0);
  pose.orientation = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(-lean_back, Eigen::Vector3d::UnitY()) * UprightOrientation();
  for (const Side side : {kLeft, kRight}) {
    const double knee = random.Chance(0.3) ? random.Uniform(0.5, 1.4) : random.Uniform(0, 0.3);
    SetLeg(rig, pose, side, std::numbers::pi / 2 - lean_back + knee / 2 - 0.05, knee,
           random.Uniform(0.05, 0.4));
    pose.legs[side].tip = random.Uniform(0.1, 0.5);
  }
  DrawArms(rig, pose, random.Uniform(0.1, 0.5), random);
  pose.spine = {random.Uniform(0.05, 0.5), random.Normal(0, 0.1), random.Normal(0, 0.15)};
  pose.neck = {random.Uniform(0, 0.6), random.Normal(0, 0.3), random.Normal(0, 0.2)};
  return pose;
}

// On the back and on the face a chest gives way; a shoulder or a raised knee does less so.
double Flatness(const BodyShape& shape, PoseFamily family) {
  const std::string_view name = EnumName(family);
  if (name.starts_with("supine") || name.starts_with("prone")) return shape.flatness;
  return family == PoseFamily::kHalfSitting ? 1 : 0.6 + 0.4 * shape.flatness;
}

}  // namespace

PersonMesh MakeLyingPerson(const HumanModel& model, const BodyShape& shape, PoseFamily family,
                           Random& random) {
  const RestBody body = MakeRestBody(model, shape);
  const BodyRig rig(model, body);
  PersonMesh person;
  if (family == PoseFamily::kHalfSitting) {
    person.settled.pose = DrawHalfSitting(rig, random);
    person.settled.pose.position.z() -= LowestSkin(model, body, rig, person.settled.pose);
  } else {
    person.settled = DrawSettledPose(rig, family, random);
  }
  person.mesh = PosedMesh(model, body, rig, person.settled.pose);
  for (Eigen::Vector3f& vertex : person.mesh.vertices)
    vertex.z() *= static_cast<float>(Flatness(shape, family));
  if (family == PoseFamily::kHalfSitting)
    person.props.push_back({"backrest", MakeBackrest(person.mesh, random)});
  if (family == PoseFamily::kLegsOnChair)
    person.props.push_back({"seat", MakeSeatBelowLegs(person.mesh, random)});
  if (family == PoseFamily::kFallenOver)
    person.props.push_back({"obstacle", MakeObstacle(person.mesh, random)});
  return person;
}

TriangleMesh MakeStandingPerson(const HumanModel& model, const BodyShape& shape, Random& random) {
  const RestBody body = MakeRestBody(model, shape);
  const BodyRig rig(model, body);
  BodyPose pose;
  pose.orientation = UprightOrientation();
  DrawArms(rig, pose, 0.05, random);
  const double stride = random.Uniform(-0.25, 0.25);
  SetLeg(rig, pose, kLeft, stride, std::abs(stride) * 0.6, 0.06);
  SetLeg(rig, pose, kRight, -stride, std::abs(stride) * 0.6, 0.06);
  pose.spine = {random.Uniform(0, 0.35), random.Normal(0, 0.1), 0};
  pose.neck = {random.Uniform(-0.1, 0.4), random.Normal(0, 0.3), 0};
  pose.position.z() -= LowestSkin(model, body, rig, pose);
  return PosedMesh(model, body, rig, pose);
}

TriangleMesh MakeStoopingPerson(const HumanModel& model, const BodyShape& shape, Stoop stoop,
                                Random& random) {
  const RestBody body = MakeRestBody(model, shape);
  const BodyRig rig(model, body);
  BodyPose pose;
  double lean = 0;  // of the pelvis, forward
  switch (stoop) {
    case Stoop::kKneeling:
      lean = random.Uniform(0, 0.5);
      for (const Side side : {kLeft, kRight}) {
        SetLeg(rig, pose, side, lean + random.Uniform(-0.1, 0.5), random.Uniform(1.5, 1.9), 0.1);
        pose.legs[side].tip = random.Uniform(0.5, 0.9);
      }
      break;
    case Stoop::kBending:
      lean = random.Uniform(0.6, 1.2);
      for (const Side side : {kLeft, kRight}) {
        const double knee = random.Uniform(0.1, 0.5);
        SetLeg(rig, pose, side, lean + knee / 2 + random.Normal(0, 0.08), knee, 0.08);
        pose.legs[side].tip += lean;
      }
      break;
    case Stoop::kCrouching:
      lean = random.Uniform(0.3, 0.7);
      for (const Side side : {kLeft, kRight}) {
        SetLeg(rig, pose, side, lean + random.Uniform(1.5, 1.8), random.Uniform(2.0, 2.3), 0.2);
        pose.legs[side].tip += lean;
      }
      break;
  }
  pose.orientation = Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitY()) * UprightOrientation();
  pose.spine = {random.Uniform(0.2, 0.8), random.Normal(0, 0.1), random.Normal(0, 0.1)};
  pose.neck = {random.Uniform(-0.3, 0.4), random.Normal(0, 0.3), 0};
  // Arms hang down from a trunk that leans.
  const double hang = lean + pose.spine.x();
  for (const Side side : {kLeft, kRight}) {
    const double out = random.Uniform(0, 0.25), front = hang + random.Uniform(-0.2, 0.3);
    pose.arms[side].root = rig.LimbRotation(
        Limb::kArm, side, {side == kLeft ? out : -out, -std::cos(front), std::sin(front)},
        random.Uniform(-0.4, 0.4));
    pose.arms[side].hinge = random.Uniform(0.05, 0.9);
  }
  pose.position.z() -= LowestSkin(model, body, rig, pose);
  return PosedMesh(model, body, rig, pose);
}

TriangleMesh MakeSittingPerson(const HumanModel& model, const BodyShape& shape,
                               double seat_height_m, Random& random) {
  const RestBody body = MakeRestBody(model, shape);
  const BodyRig rig(model, body);
  BodyPose pose;
  const double lean_back = random.Uniform(-0.1, 0.35);
  pose.orientation = Eigen::AngleAxisd(-lean_back, Eigen::Vector3d::UnitY()) * UprightOrientation();
  DrawArms(rig, pose, 0.45, random);
  for (const Side side : {kLeft, kRight})
    SetLeg(rig, pose, side, std::numbers::pi / 2 - lean_back, random.Uniform(1.2, 1.7),
           random.Uniform(0.05, 0.25));
  pose.spine.x() = random.Uniform(0, 0.4) * (lean_back > 0.1 ? 0.5 : 1);
  pose.neck = {random.Uniform(-0.1, 0.4), random.Normal(0, 0.3), 0};
  // The underside of the thighs is a hand's breadth below the root bone.
  constexpr double kSeatBelowRoot = 0.11;
  pose.position.z() = seat_height_m + kSeatBelowRoot;
  return PosedMesh(model, body, rig, pose);
}

}  // namespace fallen::sim
