// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "tools/simulate/body_capsules.hpp"

namespace fallen::sim {
namespace {

constexpr int kLimbAngles = 5;  // three of the root, hinge, tip
constexpr int kFirstLimb = 9;   // after height, pitch, roll, three of the spine, three of the neck
constexpr int kAngles = kFirstLimb + 4 * kLimbAngles;
using Angles = std::array<double, kAngles>;

// Weights of the energy. The body's whole weight, kGravity, rests on some 30 skin samples when it
// lies on one side; with kFloor they sink in by half a centimetre, as flesh does.
constexpr double kGravity = 20;
constexpr double kFloor = 60;
constexpr double kHardFloor = 3000;   // below kSoftDepth
constexpr double kSoftDepth = 0.008;  // [m]
constexpr double kOverlap = 400;
constexpr double kLimit = 50;
constexpr double kSampleSpacing = 0.04;  // [m] between skin samples

// Anatomical ranges [rad].
constexpr double kMaxElbow = 2.5, kMaxKnee = 2.3, kMinAnkle = -0.4, kMaxAnkle = 1.0,
                 kMaxWrist = 0.9;

double SquareBeyond(double value, double low, double high) {
  const double excess = std::max({0.0, low - value, value - high});
  return excess * excess;
}

Eigen::Quaterniond Turn(double x, double y, double z) {
  const Eigen::Vector3d vector(x, y, z);
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

BodyPose Apply(const BodyPose& drawn, const Angles& angles) {
  BodyPose pose = drawn;
  pose.position.z() += angles[0];
  pose.orientation = Turn(angles[2], angles[1], 0) * drawn.orientation;
  pose.spine += Eigen::Vector3d(angles[3], angles[4], angles[5]);
  pose.neck += Eigen::Vector3d(angles[6], angles[7], angles[8]);
  for (int limb = 0; limb < 4; ++limb) {
    const double* a = angles.data() + kFirstLimb + limb * kLimbAngles;
    LimbPose& target = limb < 2 ? pose.arms[limb] : pose.legs[limb - 2];
    target.root = Turn(a[0], a[1], a[2]) * target.root;
    target.hinge += a[3];
    target.tip += a[4];
  }
  return pose;
}

class Energy {
 public:
  Energy(const BodyRig& rig, const DrawnPose& drawn)
      : rig_(rig), drawn_(drawn), capsules_(MeasureCapsules(rig.model(), rig.body())) {
    // One skin sample a cube, so that each stands for about the same area.
    std::map<std::tuple<int, int, int>, int> sample_of_cube;
    for (const int v : rig.body().body_vertices) {
      const Eigen::Vector3f cube = (rig.body().skin.col(v) / kSampleSpacing).array().floor();
      sample_of_cube.try_emplace(
          {static_cast<int>(cube.x()), static_cast<int>(cube.y()), static_cast<int>(cube.z())}, v);
    }
    for (const auto& [cube, v] : sample_of_cube) samples_.push_back(v);
    const PoseStiffness& stiffness = drawn.stiffness;
    sigma_ = {0, 0, stiffness.roll};  // height and pitch are gravity's alone
    for (int i = 3; i < 6; ++i) sigma_[i] = stiffness.spine;
    for (int i = 6; i < 9; ++i) sigma_[i] = stiffness.neck;
    for (int limb = 0; limb < 4; ++limb)
      for (int i = 0; i < kLimbAngles; ++i)
        sigma_[kFirstLimb + limb * kLimbAngles + i] =
            limb < 2 ? stiffness.arms[limb] : stiffness.legs[limb - 2];
  }

  double operator()(const Angles& angles) {
    const BodyPose pose = Apply(drawn_.pose, angles);
    rig_.Transform(pose, transforms_);
    return Weight() + Floor() + Overlaps() + Limits(pose) + Departure(angles);
  }

  void Judge(const BodyPose& pose, SettledPose& settled);

 private:
  struct SkinPoint {
    Eigen::Vector3d p;
    int part;
  };
  double Gap(int part, const std::vector<SkinPoint>& skin) const;

  double SkinHeight(int v) const {
    const HumanModel& model = rig_.model();
    const Eigen::Vector3d p = rig_.body().skin.col(v).cast<double>();
    double height = 0;
    for (std::size_t k = 0; k < kInfluencesPerVertex; ++k) {
      const double weight = model.skin_weights[static_cast<std::size_t>(v)][k];
      if (weight == 0) continue;
      const auto bone = static_cast<std::size_t>(model.skin_bones[static_cast<std::size_t>(v)][k]);
      height +=
          weight * (transforms_.rotations[bone].row(2).dot(p) + transforms_.translations[bone].z());
    }
    return height;
  }

  std::pair<Eigen::Vector3d, Eigen::Vector3d> Ends(const BodyCapsule& capsule) const {
    const auto a = static_cast<std::size_t>(capsule.bone_a),
               b = static_cast<std::size_t>(capsule.bone_b);
    return {transforms_.rotations[a] * capsule.end_a + transforms_.translations[a],
            transforms_.rotations[b] * capsule.end_b + transforms_.translations[b]};
  }

  bool HeldOtherwise(int part) const {
    return (capsules_.capsules[static_cast<std::size_t>(part)].leg && drawn_.legs_held) ||
           (capsules_.IsTrunk(part) && drawn_.trunk_held);
  }

  double Weight() {
    ends_.clear();
    double sum = 0;
    for (const BodyCapsule& capsule : capsules_.capsules) {
      ends_.push_back(Ends(capsule));
      if (capsule.leg && drawn_.legs_held) continue;
      sum += capsule.mass * (ends_.back().first.z() + ends_.back().second.z()) / 2;
    }
    return kGravity * sum;
  }

  double Floor() const {
    double sum = 0;
    for (const int v : samples_) {
      const double depth = -SkinHeight(v);
      if (depth <= 0) continue;
      sum += kFloor * depth * depth;
      if (depth > kSoftDepth) sum += kHardFloor * (depth - kSoftDepth) * (depth - kSoftDepth);
    }
    return sum;
  }

  double CapsuleGap(int a, int b) const {
    const auto& [a0, a1] = ends_[static_cast<std::size_t>(a)];
    const auto& [b0, b1] = ends_[static_cast<std::size_t>(b)];
    return SegmentDistance(a0, a1, b0, b1) -
           capsules_.capsules[static_cast<std::size_t>(a)].radius -
           capsules_.capsules[static_cast<std::size_t>(b)].radius;
  }

  double Overlaps() const {
    double sum = 0;
    for (const auto& [a, b] : capsules_.colliding) {
      const double overlap = -CapsuleGap(a, b);
      if (overlap > 0) sum += kOverlap * overlap * overlap;
    }
    return sum;
  }

  static double Limits(const BodyPose& pose) {
    double sum = SquareBeyond(pose.neck.norm(), 0, 1.4) + SquareBeyond(pose.spine.norm(), 0, 1.0);
    for (const LimbPose& arm : pose.arms)
      sum += SquareBeyond(arm.hinge, 0, kMaxElbow) + SquareBeyond(arm.tip, -kMaxWrist, kMaxWrist);
    for (const LimbPose& leg : pose.legs)
      sum += SquareBeyond(leg.hinge, 0, kMaxKnee) + SquareBeyond(leg.tip, kMinAnkle, kMaxAnkle);
    return kLimit * sum;
  }

  double Departure(const Angles& angles) const {
    double sum = 0;
    for (int i = 0; i < kAngles; ++i)
      if (sigma_[i] > 0) sum += angles[i] * angles[i] / (sigma_[i] * sigma_[i]);
    return sum;
  }

  const BodyRig& rig_;
  const DrawnPose& drawn_;
  const BodyCapsules capsules_;
  std::vector<int> samples_;
  Angles sigma_{};
  BodyRig::BoneTransforms transforms_;
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> ends_;
};

// Air between a part and the floor or, but for the trunk, whatever else of the body holds it up.
// Measured on the skin, for the capsules are thinner than, say, a belly.
double Energy::Gap(int part, const std::vector<SkinPoint>& skin) const {
  constexpr int kStride = 7;  // of the part's skin points: a centimetre or two apart
  double gap = 10;
  for (const SkinPoint& point : skin)
    if (point.part == part) gap = std::min(gap, point.p.z());
  if (gap <= kMaxFloat || capsules_.IsTrunk(part)) return gap;
  const std::set<int> supports = capsules_.MayRestOn(part);
  int count = 0;
  for (const SkinPoint& point : skin) {
    if (point.part != part || ++count % kStride != 0) continue;
    for (const SkinPoint& other : skin)
      if (supports.contains(other.part)) gap = std::min(gap, (point.p - other.p).norm());
  }
  return gap;
}

void Energy::Judge(const BodyPose& pose, SettledPose& settled) {
  rig_.Transform(pose, transforms_);
  const Eigen::Matrix3Xf skinned = Skin(rig_.model(), transforms_, rig_.body().skin);
  std::vector<SkinPoint> skin;
  for (const int v : rig_.body().body_vertices) {
    const auto bone =
        static_cast<std::size_t>(rig_.model().skin_bones[static_cast<std::size_t>(v)][0]);
    skin.push_back({skinned.col(v).cast<double>(), capsules_.capsule_of_bone[bone]});
  }
  settled.sink_m = 0;
  settled.float_m = 0;
  for (const SkinPoint& point : skin) settled.sink_m = std::max(settled.sink_m, -point.p.z());
  for (std::size_t i = 0; i < capsules_.capsules.size(); ++i)
    if (capsules_.capsules[i].must_rest && !HeldOtherwise(static_cast<int>(i)))
      settled.float_m = std::max(settled.float_m, Gap(static_cast<int>(i), skin));
}

}  // namespace

SettledPose SettleOnFloor(const BodyRig& rig, const DrawnPose& drawn) {
  constexpr int kMaxSweeps = 80;
  constexpr double kFirstStep = 0.08, kLastStep = 0.0008;  // [rad] and [m]
  constexpr double kGrow = 1.6, kShrink = 0.5;
  DrawnPose start = drawn;
  start.pose.position = {0, 0, 0.15};  // about half a trunk's thickness
  Energy energy(rig, start);
  Angles angles{}, steps;
  steps.fill(kFirstStep);
  SettledPose settled;
  double best = energy(angles);
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    for (int i = 0; i < kAngles; ++i) {
      bool improved = false;
      for (const double sign : {1.0, -1.0}) {
        Angles trial = angles;
        trial[i] += sign * steps[i];
        const double value = energy(trial);
        ++settled.evaluations;
        if (value >= best) continue;
        best = value;
        angles = trial;
        steps[i] *= sign;  // go on this way first
        improved = true;
        break;
      }
      steps[i] *= improved ? kGrow : kShrink;
      if (std::abs(steps[i]) < kLastStep) steps[i] = kLastStep;
    }
    const double largest = std::abs(*std::max_element(
        steps.begin(), steps.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
    if (largest <= kLastStep) break;
  }
  settled.pose = Apply(start.pose, angles);
  energy.Judge(settled.pose, settled);
  return settled;
}

SettledPose DrawSettledPose(const BodyRig& rig, PoseFamily family, Random& random) {
  constexpr int kTries = 24;  // one in four is good in the hardest families, curled up on a side
  SettledPose best;
  double best_badness = 1e9;
  for (int i = 0; i < kTries; ++i) {
    const SettledPose settled = SettleOnFloor(rig, DrawLyingPose(rig, family, random));
    const double badness = std::max(settled.sink_m / kMaxSink, settled.float_m / kMaxFloat);
    if (badness < best_badness) {
      best_badness = badness;
      best = settled;
    }
    if (badness <= 1) break;
  }
  // Where no try was good, the flesh gives way no more for it: the body is lifted instead.
  if (const double lift = best.sink_m - kMaxSink; lift > 0) {
    best.pose.position.z() += lift;
    best.sink_m = kMaxSink;
    best.float_m += lift;
  }
  return best;
}

}  // namespace fallen::sim
