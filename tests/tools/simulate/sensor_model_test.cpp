// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/sensor_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace fallen::sim {
namespace {

TEST(SensorModel, WithoutVariationItIsTheNominalOne) {
  for (const SensorKind kind : {SensorKind::kStructuredLight, SensorKind::kTimeOfFlight}) {
    const Sensor sensor = DrawSensor(kind, 640, 0, 3);
    const SensorConfig nominal = NominalSensor(kind);
    EXPECT_EQ(sensor.intrinsics, SensorIntrinsics(640, kind));
    EXPECT_DOUBLE_EQ(sensor.config.axial_noise_scale, nominal.axial_noise_scale);
    EXPECT_DOUBLE_EQ(sensor.config.weak_signal, nominal.weak_signal);
    EXPECT_DOUBLE_EQ(sensor.config.max_range_m, nominal.max_range_m);
    EXPECT_EQ(sensor.config.blob_loss, 0);
    EXPECT_EQ(sensor.config.border_px[0], 0);
  }
}

TEST(SensorModel, CopiesSpreadOverTheWholeRangeOfRealOnes) {
  double least_focal = 1e9, most_focal = 0;
  int mirrored = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Sensor sensor = DrawSensor(SensorKind::kStructuredLight, 640, 1, seed);
    least_focal = std::min(least_focal, sensor.intrinsics.fx);
    most_focal = std::max(most_focal, sensor.intrinsics.fx);
    mirrored += sensor.config.baseline_m < 0;
    EXPECT_NEAR(sensor.intrinsics.fy / sensor.intrinsics.fx, 1, 0.01);
    EXPECT_NEAR(sensor.intrinsics.cx, 319.5, 16);
  }
  EXPECT_GE(least_focal, 500);
  EXPECT_LT(least_focal, 510);
  EXPECT_GT(most_focal, 610);
  EXPECT_LE(most_focal, 620);
  EXPECT_GT(mirrored, 25);
  EXPECT_LT(mirrored, 75);
}

TEST(SensorModel, ACopyIsTheSameAtBothSizes) {
  const Sensor large = DrawSensor(SensorKind::kTimeOfFlight, 640, 1, 5);
  const Sensor small = DrawSensor(SensorKind::kTimeOfFlight, 320, 1, 5);
  EXPECT_DOUBLE_EQ(small.intrinsics.fx, large.intrinsics.fx / 2);
  EXPECT_EQ(small.config.multipath, large.config.multipath);
}

}  // namespace
}  // namespace fallen::sim
