// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/alarm_fusion.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "fallen/alarm/place_visibility.hpp"
#include "tests/support/seen_place.hpp"

namespace fallen {
namespace {

using seen_place::AddCluster;
using seen_place::Empty;
using seen_place::LookAt;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::int64_t kStart = 1'700'000'000'000'000;
constexpr std::int64_t kFrame_us = 100'000;  // 10 Hz
const Eigen::Vector3d kPerson{2, 0, 0.15};

/// Camera 2 m from the person, so many degrees round it, 1 m high, that looks at it.
Eigen::Isometry3d Around(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return LookAt({2 - 2 * std::cos(angle), 2 * std::sin(angle), 1}, kPerson);
}

Decision With(const Eigen::Isometry3d& T_world_camera, double probability,
              const Eigen::Vector3d& centroid = kPerson) {
  Decision decision = Empty(T_world_camera);
  AddCluster(decision, centroid, probability);
  return decision;
}

class AlarmFusionTest : public testing::Test {
 protected:
  /// Shows frames at 10 Hz for so long; returns the changes.
  std::vector<FallAlarm> Show(double seconds, const std::function<Decision(double)>& frame_at,
                              const std::string& camera = "FRONT") {
    std::vector<FallAlarm> changes;
    const int frames = static_cast<int>(std::lround(seconds * 10));
    for (int i = 0; i < frames; ++i, utime_ += kFrame_us)
      for (FallAlarm& change : fusion_.Add(utime_, camera, frame_at(0.1 * i)))
        changes.push_back(std::move(change));
    return changes;
  }
  std::vector<FallAlarm> Show(double seconds, const Decision& decision,
                              const std::string& camera = "FRONT") {
    return Show(
        seconds, [&](double) { return decision; }, camera);
  }
  void Raise() { ASSERT_THAT(Show(5, With(Around(0), 0.99)), SizeIs(1)); }

  static std::vector<AlarmChange> Kinds(const std::vector<FallAlarm>& changes) {
    std::vector<AlarmChange> kinds;
    for (const FallAlarm& change : changes) kinds.push_back(change.change);
    return kinds;
  }

  AlarmConfig config_;
  AlarmFusion fusion_{config_, {}};
  std::int64_t utime_ = kStart;
};

TEST_F(AlarmFusionTest, RaisesOnceForAPersonInClearView) {
  const auto changes = Show(5, With(Around(0), 0.99));
  ASSERT_THAT(changes, SizeIs(1));
  const FallAlarm& alarm = changes[0];
  EXPECT_EQ(alarm.change, AlarmChange::kRaised);
  EXPECT_EQ(alarm.id, "robot-20231114T221320Z-0");
  EXPECT_EQ(alarm.revision, 0);
  EXPECT_EQ(alarm.camera, "FRONT");
  EXPECT_EQ(alarm.first_utime, kStart);
  EXPECT_EQ(alarm.change_utime, alarm.raised_utime);
  EXPECT_LE(alarm.raised_utime, kStart + 2'000'000);
  EXPECT_TRUE(alarm.position.isApprox(kPerson, 1e-9));
  EXPECT_EQ(alarm.best_probability, 0.99);
  EXPECT_GT(alarm.probability, 0.95);
  EXPECT_EQ(alarm.views, 1);
  EXPECT_EQ(alarm.frames, (alarm.raised_utime - kStart) / kFrame_us + 1);
  ASSERT_THAT(fusion_.Active(), SizeIs(1));
  EXPECT_EQ(fusion_.Active()[0].id, alarm.id);
}

TEST_F(AlarmFusionTest, AFewFramesRaiseNothing) {
  EXPECT_THAT(Show(0.3, With(Around(0), 0.999)), IsEmpty());
  EXPECT_THAT(Show(10, Empty(Around(0))), IsEmpty());
}

TEST_F(AlarmFusionTest, DoubtfulFromOneSideIsNoAlarmHoweverLong) {
  EXPECT_THAT(Show(120, With(Around(0), 0.8)), IsEmpty());
}

TEST_F(AlarmFusionTest, DoubtfulFromSeveralSidesIs) {
  const auto changes = Show(6, [](double t) { return With(Around(20 * t), 0.85); });
  ASSERT_FALSE(changes.empty());
  EXPECT_EQ(changes[0].change, AlarmChange::kRaised);
  EXPECT_GE(changes[0].views, 2);
}

TEST_F(AlarmFusionTest, WhatIsLikelyNoPersonSpeaksAgainstIt) {
  EXPECT_THAT(
      Show(10,
           [](double t) { return With(Around(20 * t), std::lround(10 * t) % 2 == 0 ? 0.9 : 0.1); }),
      IsEmpty());
}

TEST_F(AlarmFusionTest, UpdatesWhenSeenFromAnotherSide) {
  Raise();
  const auto changes = Show(3, With(Around(60), 0.995));
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kUpdated));
  EXPECT_EQ(changes[0].revision, 1);
  EXPECT_EQ(changes[0].views, 2);
  EXPECT_EQ(changes[0].best_probability, 0.995);
}

TEST_F(AlarmFusionTest, UpdatesAreNoFasterThanAsked) {
  Raise();
  std::int64_t last = 0;
  for (const FallAlarm& change : Show(10, [](double t) { return With(Around(36 * t), 0.99); })) {
    EXPECT_EQ(change.change, AlarmChange::kUpdated);
    EXPECT_GE(change.change_utime - last, 1'000'000);
    last = change.change_utime;
  }
  EXPECT_GT(last, 0);
}

TEST_F(AlarmFusionTest, ClearsOnceThePlaceIsSeenWithoutAnybody) {
  Raise();
  const auto changes = Show(20, Empty(Around(0)));
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kCleared));
  EXPECT_EQ(changes[0].revision, 1);
  EXPECT_FALSE(changes[0].is_active());
  EXPECT_EQ(changes[0].cleared_by, "");
  EXPECT_GE(changes[0].cleared_utime, kStart + 5'000'000 + 1'000'000);
  EXPECT_LE(changes[0].cleared_utime, kStart + 5'000'000 + 5'000'000);
  EXPECT_THAT(fusion_.Active(), IsEmpty());
}

TEST_F(AlarmFusionTest, AClusterThatIsNoPersonAnyMoreClearsToo) {
  Raise();
  EXPECT_THAT(Kinds(Show(10, With(Around(0), 0.02))), ElementsAre(AlarmChange::kCleared));
}

TEST_F(AlarmFusionTest, StaysWhileNobodyLooks) {
  Raise();
  EXPECT_THAT(Show(600, Empty(LookAt({0, 0, 1}, {-2, 0, 0}))), IsEmpty());
  EXPECT_THAT(fusion_.Active(), SizeIs(1));
}

TEST_F(AlarmFusionTest, StaysWhileSomethingHidesThePlace) {
  Raise();
  EXPECT_THAT(Show(600, Empty(Around(0), 0.8)), IsEmpty());
}

TEST_F(AlarmFusionTest, StaysWhenTheSourceDoesNotTellWhatItSaw) {
  Raise();
  Decision blind = Empty(Around(0));
  blind.view = {};
  EXPECT_THAT(Show(600, blind), IsEmpty());
  AddCluster(blind, kPerson, 0.01);
  EXPECT_THAT(Kinds(Show(10, blind)), ElementsAre(AlarmChange::kCleared)) << "but it is believed";
}

TEST_F(AlarmFusionTest, AFewMissesDoNotClear) {
  Raise();
  for (int i = 0; i < 20; ++i) {
    EXPECT_THAT(Show(0.5, Empty(Around(0))), IsEmpty());
    EXPECT_THAT(Show(1.5, With(Around(0), 0.99)), IsEmpty());
  }
}

TEST_F(AlarmFusionTest, WhatTheMapRemembersIsNoNewEvidence) {
  // The cluster stays in the local map while the camera looks elsewhere.
  EXPECT_THAT(Show(0.3, With(Around(0), 0.99)), IsEmpty());
  EXPECT_THAT(Show(20, With(LookAt({0, 0, 1}, {-2, 0, 0}), 0.99)), IsEmpty());
}

TEST_F(AlarmFusionTest, WhatTheMapRemembersBesideAnEmptyPlaceDoesNotKeepTheAlarm) {
  Raise();
  // The picture ends between the place and what is left of the person.
  const auto aside = LookAt({0, 0, 1}, {2, -1, 0.15});
  const auto changes = Show(20, With(aside, 0.99, kPerson + Eigen::Vector3d(0, 0.75, 0)));
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kCleared));
  EXPECT_TRUE(changes[0].position.isApprox(kPerson, 0.01));
}

TEST_F(AlarmFusionTest, APersonMostlyOutsideThePictureCountsStill) {
  const Decision decision = With(LookAt({0, 0, 1}, {2, 1.4, 0.15}), 0.99);
  const std::optional<double> share =
      VisibleShare(decision.view, decision.T_map_camera, decision.hypotheses[0].box, 0);
  ASSERT_TRUE(share);
  ASSERT_NEAR(*share, 0.27, 0.01);
  EXPECT_THAT(Kinds(Show(5, decision)), ElementsAre(AlarmChange::kRaised));
}

TEST_F(AlarmFusionTest, SeveralPersonsAreSeveralAlarms) {
  const Eigen::Vector3d other = kPerson + Eigen::Vector3d(0, 1.0, 0);
  Decision both = With(Around(0), 0.99);
  AddCluster(both, other, 0.98);
  const auto changes = Show(5, both);
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kRaised, AlarmChange::kRaised));
  EXPECT_NE(changes[0].id, changes[1].id);
  // One gets up, the other stays.
  const auto after = Show(20, With(Around(0), 0.98, other));
  ASSERT_THAT(Kinds(after), ElementsAre(AlarmChange::kCleared));
  EXPECT_TRUE(after[0].position.isApprox(kPerson, 0.01));
  EXPECT_THAT(fusion_.Active(), SizeIs(1));
}

TEST_F(AlarmFusionTest, PiecesOfOnePersonAreOneAlarm) {
  Decision pieces = With(Around(0), 0.99);
  AddCluster(pieces, kPerson + Eigen::Vector3d(0.5, 0.3, 0), 0.97);
  AddCluster(pieces, kPerson - Eigen::Vector3d(0.5, 0.3, 0), 0.9);
  EXPECT_THAT(Show(10, pieces), SizeIs(1));
}

TEST_F(AlarmFusionTest, CamerasHelpEachOther) {
  // Neither would do alone: see DoubtfulFromOneSideIsNoAlarmHoweverLong.
  std::vector<FallAlarm> changes;
  for (int i = 0; i < 50; ++i) {
    for (auto& change : Show(0.1, With(Around(0), 0.85), "FRONT")) changes.push_back(change);
    for (auto& change : Show(0.1, With(Around(90), 0.85), "REAR")) changes.push_back(change);
  }
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kRaised));
  EXPECT_EQ(changes[0].views, 2);
}

TEST_F(AlarmFusionTest, AcknowledgedOnceByItsId) {
  Raise();
  const std::string id = fusion_.Active()[0].id;
  EXPECT_THAT(fusion_.Acknowledge("another", "nurse", utime_), IsEmpty());
  const auto changes = fusion_.Acknowledge(id, "nurse", utime_);
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kAcknowledged));
  EXPECT_EQ(changes[0].acknowledged_by, "nurse");
  EXPECT_EQ(changes[0].acknowledged_utime, utime_);
  EXPECT_TRUE(changes[0].is_active());
  EXPECT_THAT(fusion_.Acknowledge("", "doctor", utime_), IsEmpty()) << "all are already";
  EXPECT_THAT(Kinds(Show(10, Empty(Around(0)))), ElementsAre(AlarmChange::kCleared));
}

TEST_F(AlarmFusionTest, ClosedBySomebody) {
  Raise();
  const auto changes = fusion_.Close("", "nurse", utime_);
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kCleared));
  EXPECT_EQ(changes[0].cleared_by, "nurse");
  EXPECT_THAT(fusion_.Active(), IsEmpty());
  EXPECT_THAT(Kinds(Show(5, With(Around(0), 0.99))), ElementsAre(AlarmChange::kRaised))
      << "who still lies there is a new alarm";
}

TEST_F(AlarmFusionTest, GoesOnAfterARestart) {
  Raise();
  const FallAlarm before = fusion_.Active()[0];
  AlarmScope scope;
  scope.first_number = 1;
  fusion_ = AlarmFusion(config_, scope);
  fusion_.Resume(before);
  EXPECT_THAT(fusion_.Active(), ElementsAre(before));
  EXPECT_THAT(Show(5, With(Around(0), 0.99)), IsEmpty()) << "the same person, the same alarm";
  const auto changes = Show(10, Empty(Around(0)));
  ASSERT_THAT(Kinds(changes), ElementsAre(AlarmChange::kCleared));
  EXPECT_EQ(changes[0].id, before.id);
  EXPECT_EQ(changes[0].revision, 1);
}

TEST_F(AlarmFusionTest, IdsNeverComeTwice) {
  std::set<std::string> ids;
  for (int i = 0; i < 5; ++i) {
    utime_ = kStart;  // the same recording again
    Raise();
    ids.insert(fusion_.Active()[0].id);
    fusion_.Close("", "test", utime_);
  }
  EXPECT_THAT(ids, SizeIs(5));
}

TEST_F(AlarmFusionTest, ZonesKeepQuiet) {
  AlarmScope scope;
  scope.zones = {{"basket", ZoneKind::kNever, {{1.5, -0.5}, {2.5, -0.5}, {2.5, 0.5}, {1.5, 0.5}}}};
  fusion_ = AlarmFusion(config_, scope);
  EXPECT_THAT(Show(10, With(Around(0), 0.999)), IsEmpty());
  scope.zones[0].kind = ZoneKind::kBed;
  fusion_ = AlarmFusion(config_, scope);
  EXPECT_THAT(Show(10, With(Around(0), 0.999, {2, 0, 0.6})), IsEmpty());
  EXPECT_THAT(Kinds(Show(10, With(Around(0), 0.999))), ElementsAre(AlarmChange::kRaised))
      << "fallen out of bed";
  scope.zones[0].corners.resize(2);
  EXPECT_THROW(AlarmFusion(config_, scope), std::invalid_argument);
}

TEST_F(AlarmFusionTest, WithoutAPoseOnlyFixedCamerasTell) {
  Decision decision = With(Around(0), 0.99);
  decision.frame = MapFrame::kLevel;
  EXPECT_THAT(Show(5, decision), IsEmpty());
  EXPECT_EQ(fusion_.frames_without_pose(), 50);

  AlarmScope scope;
  scope.has_fixed_cameras = true;
  fusion_ = AlarmFusion(config_, scope);
  EXPECT_THAT(Kinds(Show(5, decision, "HALL")), ElementsAre(AlarmChange::kRaised));
  EXPECT_THAT(Kinds(Show(5, decision, "ROOM")), ElementsAre(AlarmChange::kRaised))
      << "the same coordinates are another place";
  EXPECT_THAT(Kinds(Show(10, Empty(Around(0)), "HALL")), IsEmpty()) << "the world is a third";
}

TEST_F(AlarmFusionTest, AClockThatJumpsHarmsNothing) {
  Raise();
  utime_ -= 3'600'000'000;
  EXPECT_THAT(Show(5, With(Around(0), 0.99)), IsEmpty());
  utime_ += 7'200'000'000;
  EXPECT_THAT(Show(0.3, Empty(Around(0))), IsEmpty()) << "a gap is no time of looking";
  EXPECT_THAT(fusion_.Active(), SizeIs(1));
}

TEST_F(AlarmFusionTest, PlacesWithoutAnAlarmAreForgotten) {
  Show(0.3, With(Around(0), 0.99));
  Show(config_.forget_s + 1, Empty(LookAt({0, 0, 1}, {-2, 0, 0})));
  // Had it not been forgotten, this would do.
  EXPECT_THAT(Show(0.4, With(Around(0), 0.99)), IsEmpty());
}

}  // namespace
}  // namespace fallen
