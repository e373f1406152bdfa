// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/place_visibility.hpp"

#include <gtest/gtest.h>

#include "tests/support/seen_place.hpp"

namespace fallen {
namespace {

using seen_place::FlatView;
using seen_place::LookAt;

constexpr double kMargin_m = 0.3;
const OrientedBox kPlace{{2, 0, 0.15}, {1.6, 0.5, 0.3}, 0.4};
const Eigen::Isometry3d kAhead = LookAt({0, 0, 1}, kPlace.center);

TEST(PlaceVisibility, APlaceAheadIsSeenWhole) {
  EXPECT_EQ(VisibleShare(FlatView(6), kAhead, kPlace, kMargin_m), 1.0);
}

TEST(PlaceVisibility, APlaceBehindOrBesideTheCameraIsNot) {
  EXPECT_EQ(VisibleShare(FlatView(6), LookAt({0, 0, 1}, {-2, 0, 0}), kPlace, kMargin_m), 0.0);
  EXPECT_EQ(VisibleShare(FlatView(6), LookAt({0, 0, 1}, {0, 5, 0}), kPlace, kMargin_m), 0.0);
}

TEST(PlaceVisibility, WhatStandsInFrontHidesIt) {
  EXPECT_EQ(VisibleShare(FlatView(1), kAhead, kPlace, kMargin_m), 0.0);
  // Its far end is 2.8 m away: the person on it ends the rays a little earlier.
  EXPECT_EQ(VisibleShare(FlatView(2.6), kAhead, kPlace, kMargin_m).value(), 1.0);
}

TEST(PlaceVisibility, HalfHiddenIsHalf) {
  CameraView view = FlatView(6);
  for (int row = 0; row < 24; ++row)
    for (int column = 0; column < 16; ++column) view.depth_mm[row * 32 + column] = 1000;
  const double share = VisibleShare(view, kAhead, kPlace, kMargin_m).value();
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.7);
}

TEST(PlaceVisibility, RaysThatWereNotMeasuredSeeNothing) {
  EXPECT_EQ(VisibleShare(FlatView(0), kAhead, kPlace, kMargin_m), 0.0);
}

TEST(PlaceVisibility, WithoutAViewItIsNotKnown) {
  EXPECT_FALSE(VisibleShare(CameraView{}, kAhead, kPlace, kMargin_m));
}

}  // namespace
}  // namespace fallen
