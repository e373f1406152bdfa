// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "fallen/messages/conversions.hpp"

namespace fallen {
namespace {

GroundTruth Sample() {
  GroundTruth truth;
  truth.person_box = OrientedBox{{1, 2, 0.2}, {1.7, 0.5, 0.3}, 0.7};
  truth.person = "body-3";
  truth.room = "room-1";
  truth.objects.push_back({"furniture", "sofa", 3, {{0, 0, 0.4}, {2, 1, 0.8}, -1}});
  truth.objects.push_back({"fallen_person", "body-3", 7, *truth.person_box});
  truth.label_width = 4;
  truth.label_height = 3;
  truth.labels = {0, 0, 3, 3, 0, 7, 7, 3, 0, 7, 7, 0};
  return truth;
}

void ExpectEqual(const GroundTruth& a, const GroundTruth& b) {
  EXPECT_EQ(a.person_box, b.person_box);
  EXPECT_EQ(a.person, b.person);
  EXPECT_EQ(a.room, b.room);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].category, b.objects[i].category);
    EXPECT_EQ(a.objects[i].name, b.objects[i].name);
    EXPECT_EQ(a.objects[i].label, b.objects[i].label);
    EXPECT_EQ(a.objects[i].box, b.objects[i].box);
  }
  EXPECT_EQ(a.label_width, b.label_width);
  EXPECT_EQ(a.label_height, b.label_height);
  EXPECT_EQ(a.labels, b.labels);
}

TEST(GroundTruthConversion, RoundTripIsExact) {
  ExpectEqual(FromMessage(ToMessage(Header{5, 6, "CAMERA"}, Sample())), Sample());
  ExpectEqual(FromMessage(ToMessage(Header{}, GroundTruth{})), GroundTruth{});
}

TEST(GroundTruthConversion, KnowsTheLabelOfTheFallenPerson) {
  EXPECT_EQ(Sample().person_label(), 7);
  EXPECT_EQ(GroundTruth{}.person_label(), 0);
}

TEST(GroundTruthConversion, RefusesEachBadField) {
  const std::pair<const char*, std::function<void(ground_truth_t&)>> cases[] = {
      {"header_t.utime", [](auto& m) { m.header.utime = -1; }},
      {"ground_truth_t.person_present", [](auto& m) { m.person_present = 3; }},
      {"ground_truth_t.person_box.size", [](auto& m) { m.person_box.size[0] = -1; }},
      {"ground_truth_t.person_box.yaw",
       [](auto& m) { m.person_box.yaw = std::numeric_limits<double>::infinity(); }},
      {"ground_truth_t.person", [](auto& m) { m.person = std::string(1, '\0'); }},
      {"ground_truth_t.room", [](auto& m) { m.room = std::string(70000, 'x'); }},
      {"ground_truth_t.object_count", [](auto& m) { m.object_count = 3; }},
      {"ground_truth_t.object_count", [](auto& m) { m.object_count = -2; }},
      {"ground_truth_t.objects.label", [](auto& m) { m.objects[0].label = 256; }},
      {"ground_truth_t.objects.label", [](auto& m) { m.objects[0].label = -1; }},
      {"ground_truth_t.objects.box.center", [](auto& m) { m.objects[1].box.center[1] = 1e7; }},
      {"ground_truth_t.width", [](auto& m) { m.width = 0; }},
      {"ground_truth_t.width", [](auto& m) { m.width = 10000; }},
      {"ground_truth_t.width x height", [](auto& m) { m.width = m.height = 8192; }},
      {"ground_truth_t.height", [](auto& m) { m.height = -3; }},
      {"ground_truth_t.labels", [](auto& m) { m.height = 4; }},
      {"ground_truth_t.size", [](auto& m) { m.size = 1; }},
      {"ground_truth_t.size", [](auto& m) { m.width = m.height = 0; }},
      {"ground_truth_t.labels", [](auto& m) { m.labels.pop_back(), --m.size; }},
      {"ground_truth_t.labels", [](auto& m) { m.labels.push_back(0), ++m.size; }},
      {"ground_truth_t.labels", [](auto& m) { m.objects[0].label = 4; }},
  };
  for (const auto& [field, spoil] : cases) {
    ground_truth_t message = ToMessage(Header{}, Sample());
    spoil(message);
    try {
      FromMessage(message);
      ADD_FAILURE() << field << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(field));
    }
  }
}

}  // namespace
}  // namespace fallen
