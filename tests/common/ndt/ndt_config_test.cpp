// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fallen/ndt/ndt_mapper.hpp"

namespace fallen {
namespace {

TEST(NdtConfig, RefusesValuesOutOfRange) {
  EXPECT_NO_THROW(NdtConfig().Validate());
  const auto expect_refused = [](auto change) {
    NdtConfig config;
    change(config);
    EXPECT_THROW(config.Validate(), std::invalid_argument);
    EXPECT_THROW(NdtMapper{config}, std::invalid_argument);
  };
  expect_refused([](NdtConfig& c) { c.cell_size_m = 0; });
  expect_refused([](NdtConfig& c) { c.cell_size_m = std::nan(""); });
  expect_refused([](NdtConfig& c) { c.min_points = 2; });
  expect_refused([](NdtConfig& c) { c.max_range_m = c.min_range_m / 2; });
  expect_refused([](NdtConfig& c) { c.extent_m = 0; });
  expect_refused([](NdtConfig& c) { c.max_points_per_cell = c.min_points - 1; });
  expect_refused([](NdtConfig& c) { c.min_eigenvalue_ratio = 2; });
  expect_refused([](NdtConfig& c) { c.min_eigenvalue_ratio = 0; });
  expect_refused([](NdtConfig& c) { c.miss_log_odds = -1; });
  expect_refused([](NdtConfig& c) { c.max_time_gap_s = -1; });
}

}  // namespace
}  // namespace fallen
