// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/frame_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fallen {
namespace {

Decision TwoClusters() {
  PersonHypothesis person;
  person.centroid = {0.1, 1.0 / 3, -2e-17};
  person.probability = 0.97;
  person.mahalanobis_distance = 1e300;
  person.cell_count = 120;
  person.box = {{1, 2, 0.25}, {0.5, 1.75, 0.5}, -0.5};
  person.is_person = true;
  PersonHypothesis other = person;
  other.probability = 0.5;
  other.is_person = false;
  Decision decision;
  decision.hypotheses = {person, other};
  return decision;
}

TEST(FrameJson, IsOneLineWithTheDocumentedKeysInTheirOrder) {
  Decision decision = TwoClusters();
  decision.hypotheses.resize(1);
  decision.hypotheses[0].centroid = {0.5, 0.25, 1};
  decision.hypotheses[0].mahalanobis_distance = 2.5;
  const StageTimes times{1.5, 2, 0, 3.25, 0.5, 0.125, 7.5};
  EXPECT_EQ(FrameJson(1700000000123456, 12, decision, times, ListedPersons::kAccepted),
            R"({"utime":1700000000123456,"frame":12,"persons":[{"centroid":[0.5,0.25,1.0],)"
            R"("probability":0.97,"distance":2.5,"cells":120,"box":{"center":[1.0,2.0,0.25],)"
            R"("size":[0.5,1.75,0.5],"yaw":-0.5}}],"milliseconds":{"ground":1.5,"ndt":2.0,)"
            R"("background":0.0,"iron":3.25,"cells":0.5,"clusters":0.125,"total":7.5}})");
}

TEST(FrameJson, ListsAcceptedOnesOrAllWithTheDifference) {
  const auto accepted =
      nlohmann::json::parse(FrameJson(0, 0, TwoClusters(), {}, ListedPersons::kAccepted));
  ASSERT_EQ(accepted["persons"].size(), 1u);
  EXPECT_FALSE(accepted["persons"][0].contains("accepted"));

  const auto all = nlohmann::json::parse(FrameJson(0, 0, TwoClusters(), {}, ListedPersons::kAll));
  ASSERT_EQ(all["persons"].size(), 2u);
  EXPECT_EQ(all["persons"][0]["accepted"], true);
  EXPECT_EQ(all["persons"][1]["accepted"], false);

  const auto nobody = nlohmann::json::parse(FrameJson(0, 0, {}, {}, ListedPersons::kAccepted));
  EXPECT_TRUE(nobody["persons"].is_array());
  EXPECT_TRUE(nobody["persons"].empty());
}

TEST(FrameJson, ListsAlarmsWhereTheyWereAskedFor) {
  EXPECT_FALSE(
      nlohmann::json::parse(FrameJson(0, 0, {}, {}, ListedPersons::kAccepted)).contains("alarms"));
  NumberedAlarm numbered;
  numbered.alarm.id = "robot-1";
  numbered.alarm.change = AlarmChange::kRaised;
  numbered.alarm.position = {1, 2, 0.5};
  const auto json = nlohmann::json::parse(
      FrameJson(0, 0, {}, {}, ListedPersons::kAccepted, std::vector<NumberedAlarm>{numbered}));
  ASSERT_EQ(json["alarms"].size(), 1u);
  EXPECT_EQ(json["alarms"][0]["event_id"], "robot-1");
  EXPECT_EQ(json["alarms"][0]["event_type"], "raised");
  EXPECT_EQ(json["alarms"][0]["position"], nlohmann::json({1, 2, 0.5}));
}

TEST(FrameJson, NumbersReadBackAsTheSameDoubles) {
  const Decision decision = TwoClusters();
  const auto json = nlohmann::json::parse(FrameJson(0, 0, decision, {}, ListedPersons::kAccepted));
  const auto& person = json["persons"][0];
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(person["centroid"][axis].get<double>(), decision.hypotheses[0].centroid[axis]);
  EXPECT_EQ(person["distance"].get<double>(), 1e300);
  EXPECT_EQ(person["probability"].get<double>(), 0.97);
}

}  // namespace
}  // namespace fallen
