// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/zone.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fallen {
namespace {

Zone Polygon(std::vector<Eigen::Vector2d> corners, ZoneKind kind = ZoneKind::kNever) {
  return {"test", kind, std::move(corners)};
}

std::string Complaint(const Zone& zone) {
  try {
    zone.Validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Zone, HoldsWhatLiesInIt) {
  // An L: the notch at the upper right is outside.
  const Zone zone = Polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  EXPECT_EQ(Complaint(zone), "");
  EXPECT_TRUE(zone.Excludes({1, 1, 0.1}));
  EXPECT_TRUE(zone.Excludes({3.5, 1.5, 2}));
  EXPECT_TRUE(zone.Excludes({0.5, 3.5, 0}));
  EXPECT_FALSE(zone.Excludes({3, 3, 0.1}));
  EXPECT_FALSE(zone.Excludes({-0.1, 1, 0.1}));
  EXPECT_FALSE(zone.Excludes({1, 4.1, 0.1}));
}

TEST(Zone, TheOtherWayRoundIsTheSame) {
  std::vector<Eigen::Vector2d> corners = {{0, 0}, {3, 0}, {3, 1}, {0, 1}};
  const Zone one = Polygon(corners);
  std::reverse(corners.begin(), corners.end());
  const Zone other = Polygon(corners);
  EXPECT_EQ(Complaint(other), "");
  for (double x = -0.55; x < 4; x += 0.1)
    for (double y = -0.55; y < 2; y += 0.1)
      EXPECT_EQ(one.Excludes({x, y, 0}), other.Excludes({x, y, 0}));
}

TEST(Zone, WhoHasFallenOutOfBedCounts) {
  const Zone bed = Polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, ZoneKind::kBed);
  EXPECT_TRUE(bed.Excludes({1, 0.5, 0.6}));
  EXPECT_FALSE(bed.Excludes({1, 0.5, 0.15}));
  EXPECT_FALSE(bed.Excludes({1, 1.5, 0.6}));
}

TEST(Zone, RefusesPolygonsThatCrossThemselves) {
  EXPECT_EQ(Complaint(Polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})),
            "zone 'test': the edges after corners 1 and 3 cross, expected a simple polygon");
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {4, 0}, {4, 4}, {2, -1}, {0, 4}})),
              testing::HasSubstr("cross"));
  // Touching from inside, a corner on an edge.
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})),
              testing::HasSubstr("cross"));
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {4, 0}, {2, 0}, {1, 3}})), testing::HasSubstr("folds"));
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {0, 0}, {1, 1}})), testing::HasSubstr("folds"));
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {1, 1}, {2, 2}})), testing::HasSubstr("folds"));
}

TEST(Zone, RefusesWhatIsNoPolygon) {
  EXPECT_EQ(Complaint(Polygon({{0, 0}, {1, 0}})), "zone 'test': got 2 corners, expected 3 or more");
  EXPECT_THAT(Complaint(Polygon({{0, 0}, {1, 0}, {NAN, 1}})), testing::HasSubstr("not finite"));
  Zone bed = Polygon({{0, 0}, {2, 0}, {2, 1}}, ZoneKind::kBed);
  bed.bed_height_m = -1;
  EXPECT_THAT(Complaint(bed), testing::HasSubstr("bed_height_m"));
}

}  // namespace
}  // namespace fallen
