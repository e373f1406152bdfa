// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/body_capsules.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fallen::sim {
namespace {

enum Part : int {
  kHead,
  kTrunkLeft,
  kTrunkRight,
  kLimbs,  // first of the left limbs; the right ones follow in the same order
};
constexpr int kPartsPerSide = 6;
enum LimbPart : int { kUpperArm, kForearm, kHand, kThigh, kShank, kFoot };

int Index(LimbPart part, Side side) { return kLimbs + side * kPartsPerSide + part; }

bool StartsWith(const std::string& text, const char* prefix) { return text.rfind(prefix, 0) == 0; }

std::optional<LimbPart> LimbPartOf(const std::string& bone) {
  if (StartsWith(bone, "upperarm")) return kUpperArm;
  if (StartsWith(bone, "lowerarm")) return kForearm;
  for (const char* name : {"wrist", "metacarpal", "finger"})
    if (StartsWith(bone, name)) return kHand;
  if (StartsWith(bone, "upperleg")) return kThigh;
  if (StartsWith(bone, "lowerleg")) return kShank;
  for (const char* name : {"foot", "toe"})
    if (StartsWith(bone, name)) return kFoot;
  return std::nullopt;
}

int PartOf(const std::string& bone) {
  if (const auto limb = LimbPartOf(bone))
    return Index(*limb, bone.ends_with(".L") ? kLeft : kRight);
  for (const char* name : {"root", "spine", "pelvis", "breast", "clavicle", "shoulder"})
    if (StartsWith(bone, name)) return kTrunkLeft;
  return kHead;
}

double SegmentPointDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                            const Eigen::Vector3d& p) {
  const Eigen::Vector3d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
  return (a + t * ab - p).norm();
}

// Median distance of a part's skin from its axis.
void MeasureRadii(const HumanModel& model, const RestBody& body, BodyCapsules& result) {
  std::vector<std::vector<double>> distances(result.capsules.size());
  for (const int v : body.body_vertices) {
    const auto bone = static_cast<std::size_t>(model.skin_bones[static_cast<std::size_t>(v)][0]);
    const Eigen::Vector3d p = body.skin.col(v).cast<double>();
    int part = result.capsule_of_bone[bone];
    if (part == kTrunkLeft && p.x() < 0) part = kTrunkRight;
    const BodyCapsule& capsule = result.capsules[static_cast<std::size_t>(part)];
    distances[static_cast<std::size_t>(part)].push_back(
        SegmentPointDistance(capsule.end_a, capsule.end_b, p));
  }
  for (std::size_t i = 0; i < distances.size(); ++i) {
    auto& values = distances[i];
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    result.capsules[i].radius = *middle;
  }
}

void ListCollisions(BodyCapsules& result) {
  const auto add = [&](int a, int b) { result.colliding.push_back({a, b}); };
  for (const Side side : {kLeft, kRight}) {
    const Side other = side == kLeft ? kRight : kLeft;
    for (const LimbPart arm : {kUpperArm, kForearm, kHand}) {
      for (const int trunk : {kTrunkLeft, kTrunkRight}) add(Index(arm, side), trunk);
      if (arm != kUpperArm) add(Index(arm, side), kHead);
      for (const Side leg_side : {side, other})
        for (const LimbPart leg : {kThigh, kShank}) add(Index(arm, side), Index(leg, leg_side));
    }
    for (const LimbPart leg : {kShank, kFoot})
      for (const int trunk : {kTrunkLeft, kTrunkRight}) add(Index(leg, side), trunk);
    add(Index(kShank, side), Index(kThigh, other));
    add(Index(kFoot, side), Index(kShank, other));
    add(Index(kFoot, side), Index(kThigh, other));
    add(Index(kHand, side), Index(kForearm, other));
    add(Index(kForearm, side), Index(kUpperArm, other));
  }
  for (const LimbPart part : {kForearm, kHand, kThigh, kShank, kFoot})
    add(Index(part, kLeft), Index(part, kRight));
}

}  // namespace

bool BodyCapsules::IsTrunk(int part) const { return part == kTrunkLeft || part == kTrunkRight; }

std::set<int> BodyCapsules::MayRestOn(int part) const {
  std::set<int> parts;
  for (const auto& [a, b] : colliding) {
    if (a == part) parts.insert(b);
    if (b == part) parts.insert(a);
  }
  return parts;
}

BodyCapsules MeasureCapsules(const HumanModel& model, const RestBody& body) {
  BodyCapsules result;
  const auto head = [&](const std::string& bone) {
    return body.bone_heads[static_cast<std::size_t>(model.bone(bone))];
  };
  const auto tail = [&](const std::string& bone) {
    return body.bone_tails[static_cast<std::size_t>(model.bone(bone))];
  };
  const auto add = [&](const char* name, const std::string& bone_a, const Eigen::Vector3d& a,
                       const std::string& bone_b, const Eigen::Vector3d& b, double mass,
                       bool must_rest) {
    result.capsules.push_back(
        {name, model.bone(bone_a), model.bone(bone_b), a, b, 0, mass, must_rest, false});
  };
  const auto between = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b, double share) {
    return Eigen::Vector3d(a + share * (b - a));
  };
  // Within the skull, from the jaw to below the crown.
  add("head", "head", between(head("head"), tail("head"), 0.3), "head",
      between(head("head"), tail("head"), 0.6), 0.081, true);
  const std::string kLeftSuffix = ".L";
  for (const std::string suffix : {".L", ".R"}) {
    const Eigen::Vector3d hip = between(head("spine05"), head("upperleg01" + suffix), 0.7);
    const Eigen::Vector3d shoulder = between(head("spine01"), head("upperarm01" + suffix), 0.5);
    add("trunk", "root", hip, "spine01", shoulder, 0.497 / 2, suffix == kLeftSuffix);
  }
  for (const char* suffix : {".L", ".R"}) {
    const auto bone = [&](const char* name) { return std::string(name) + suffix; };
    // The upper ends of upper arm and thigh lie inside the trunk: their capsules begin lower down.
    add("upper arm", bone("upperarm01"),
        between(head(bone("upperarm01")), head(bone("lowerarm01")), 0.4), bone("upperarm01"),
        head(bone("lowerarm01")), 0.028, false);
    add("forearm", bone("lowerarm01"), head(bone("lowerarm01")), bone("lowerarm01"),
        head(bone("wrist")), 0.016, false);
    add("hand", bone("wrist"), head(bone("wrist")), bone("wrist"), tail(bone("finger3-1")), 0.006,
        true);
    add("thigh", bone("upperleg01"),
        between(head(bone("upperleg01")), head(bone("lowerleg01")), 0.35), bone("upperleg01"),
        head(bone("lowerleg01")), 0.100, false);
    add("shank", bone("lowerleg01"), head(bone("lowerleg01")), bone("lowerleg01"),
        head(bone("foot")), 0.0465, false);
    add("foot", bone("foot"), head(bone("foot")), bone("foot"), head(bone("toe1-1")), 0.0145, true);
  }
  for (const Side side : {kLeft, kRight})
    for (const LimbPart part : {kThigh, kShank, kFoot})
      result.capsules[static_cast<std::size_t>(Index(part, side))].leg = true;
  for (const Bone& bone : model.bones) result.capsule_of_bone.push_back(PartOf(bone.name));
  MeasureRadii(model, body, result);
  ListCollisions(result);
  return result;
}

double SegmentDistance(const Eigen::Vector3d& a0, const Eigen::Vector3d& a1,
                       const Eigen::Vector3d& b0, const Eigen::Vector3d& b1) {
  // Closest points of two segments, clamped one after the other (Ericson: Real-time collision
  // detection, Sec. 5.1.9).
  const Eigen::Vector3d u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = std::max(u.squaredNorm(), 1e-12), vv = std::max(v.squaredNorm(), 1e-12);
  const double uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double denominator = uu * vv - uv * uv;
  double s = denominator > 1e-12 ? std::clamp((uv * vw - uw * vv) / denominator, 0.0, 1.0) : 0;
  const double t = std::clamp((uv * s + vw) / vv, 0.0, 1.0);
  s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
  return (a0 + s * u - b0 - t * v).norm();
}

}  // namespace fallen::sim
