// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/timing_window.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(TimingWindow, EmptyWindowSaysZero) {
  const TimingWindow window;
  EXPECT_EQ(window.Quantile(0.5), 0);
  EXPECT_EQ(window.RateHz(TimingWindow::Clock::now()), 0);
}

TEST(TimingWindow, QuantilesAreOfTheLast256) {
  TimingWindow window;
  const TimingWindow::Clock::time_point now{seconds(100)};
  for (int i = 0; i < 500; ++i) window.Add(1e6, now);  // must be forgotten
  for (int i = 1; i <= 256; ++i) window.Add(i, now);
  EXPECT_EQ(window.Quantile(0.5), 128);   // nearest rank: ceil(0.5 * 256)
  EXPECT_EQ(window.Quantile(0.99), 254);  // ceil(0.99 * 256)
  EXPECT_EQ(window.Quantile(1.0), 256);
}

TEST(TimingWindow, RateIsOfTheLastSecondsAndFallsToZero) {
  TimingWindow window;
  const TimingWindow::Clock::time_point start{seconds(100)};
  for (int i = 0; i < 600; ++i) window.Add(1, start + i * milliseconds(100));  // a minute at 10 Hz
  EXPECT_NEAR(window.RateHz(start + seconds(60)), 10, 0.3);
  EXPECT_EQ(window.RateHz(start + seconds(70)), 0);
}

}  // namespace
}  // namespace fallen
