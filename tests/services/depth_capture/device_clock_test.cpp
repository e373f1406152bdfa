// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/device_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fallen {
namespace {

constexpr std::int64_t kPeriodUs = 33333;
constexpr std::int64_t kToEpochUs = 1'700'000'000'000'000;

TEST(DeviceClockTest, TakesTheFirstArrivalAsItIs) {
  DeviceClock clock;
  EXPECT_EQ(clock.HostTime(5'000'000, 1000, kToEpochUs), kToEpochUs + 1000);
}

TEST(DeviceClockTest, RemovesTheJitterOfArrivals) {
  DeviceClock clock;
  std::mt19937 random(1);
  // A delay of 2 ms, and up to 30 ms on top: as of a busy machine.
  std::exponential_distribution<double> jitter_ms(1 / 5.0);
  double sq_sum = 0;
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t taken_us = i * kPeriodUs;
    const auto jitter_us = static_cast<std::int64_t>(1000 * std::min(jitter_ms(random), 30.0));
    const std::int64_t result_us =
        clock.HostTime(taken_us + 777, taken_us + 2000 + jitter_us, kToEpochUs) - kToEpochUs;
    EXPECT_GE(result_us, taken_us + 2000);  // never earlier than the least delay allows
    if (i < 100) continue;                  // while it finds a small delay
    sq_sum += std::pow(static_cast<double>(result_us - taken_us - 2000), 2);
    ++count;
  }
  // The jitter itself has 7 ms root mean square; what is left is how far the least delay wanders.
  EXPECT_LT(std::sqrt(sq_sum / count), 500);
}

TEST(DeviceClockTest, FollowsADriftOf50Ppm) {
  DeviceClock clock;
  std::int64_t worst_us = 0;
  for (int i = 0; i < 30 * 3600; ++i) {  // an hour
    const std::int64_t host_us = i * kPeriodUs;
    const auto device_us =
        static_cast<std::int64_t>(std::llround(static_cast<double>(host_us) * (1 - 50e-6)));
    const std::int64_t delay_us = i % 10 == 0 ? 1000 : 9000;
    const std::int64_t result_us = clock.HostTime(device_us + 1, host_us + delay_us, 0);
    worst_us = std::max(worst_us, std::abs(result_us - host_us - 1000));
  }
  EXPECT_LT(worst_us, 100);  // 50 ppm of the 0.3 s between two quick arrivals, and rounding
}

TEST(DeviceClockTest, NeverRunsBackwards) {
  DeviceClock clock;
  std::mt19937 random(2);
  std::uniform_int_distribution<std::int64_t> delay_us(0, 200'000);
  std::int64_t last_us = -1;
  for (int i = 0; i < 5000; ++i) {
    const std::int64_t result_us =
        clock.HostTime(1 + i * kPeriodUs, i * kPeriodUs + delay_us(random), kToEpochUs);
    EXPECT_GT(result_us, last_us);
    last_us = result_us;
  }
}

TEST(DeviceClockTest, StartsAnewWhenTheDeviceClockDoes) {
  DeviceClock clock;
  clock.HostTime(10'000'000, 1'000'000, 0);
  EXPECT_EQ(clock.HostTime(5'000'000, 1'033'000, 0), 1'033'000);   // restarted
  EXPECT_EQ(clock.HostTime(15'000'000, 1'066'000, 0), 1'066'000);  // jumped ahead by 10 s
  EXPECT_EQ(clock.HostTime(15'033'333, 1'099'333, 0), 1'099'333);
}

TEST(DeviceClockTest, FollowsAHostClockThatIsSet) {
  DeviceClock clock;
  clock.HostTime(1'000'000, 2'000'000, kToEpochUs);
  EXPECT_EQ(clock.HostTime(1'033'333, 2'033'333, kToEpochUs + 60'000'000), kToEpochUs + 62'033'333);
  EXPECT_EQ(clock.HostTime(1'066'666, 2'066'666, kToEpochUs), kToEpochUs + 2'066'666);
  // Set back by less than a second: held, so that frames keep their order.
  EXPECT_EQ(clock.HostTime(1'100'000, 2'100'000, kToEpochUs - 500'000), kToEpochUs + 2'066'667);
}

}  // namespace
}  // namespace fallen
