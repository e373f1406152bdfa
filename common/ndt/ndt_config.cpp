// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "fallen/ndt/ndt_mapper.hpp"
#include "fallen/ndt/voxel_statistics.hpp"

namespace fallen {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::max();

void RequireWithin(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::string expected = "at least " + std::to_string(low);
  if (high < kUnlimited)
    expected = "in [" + std::to_string(low) + ", " + std::to_string(high) + "]";
  throw std::invalid_argument("ndt: " + std::string(name) + " is " + std::to_string(value) +
                              ", must be " + expected);
}

}  // namespace

void NdtConfig::Validate() const {
  RequireWithin("cell_size_m", cell_size_m, 0.005, 1.0);
  RequireWithin("min_points", min_points, 3, 1e6);
  RequireWithin("min_range_m", min_range_m, 0, 100);
  RequireWithin("max_range_m", max_range_m, min_range_m, 100);
  RequireWithin("ground_clearance_m", ground_clearance_m, 0, 10);
  RequireWithin("ground_clearance_per_sq_m", ground_clearance_per_sq_m, 0, 1);
  RequireWithin("max_height_m", max_height_m, ground_clearance_m, 100);
  RequireWithin("extent_m", extent_m, cell_size_m, 1000);
  RequireWithin("max_points_per_cell", max_points_per_cell, min_points, 1e9);
  RequireWithin("min_eigenvalue_ratio", min_eigenvalue_ratio, kLeastEigenvalueRatio, 1);
  RequireWithin("hit_log_odds", hit_log_odds, 0, 100);
  RequireWithin("miss_log_odds", miss_log_odds, 0, 100);
  RequireWithin("unseen_miss_log_odds", unseen_miss_log_odds, 0, 100);
  RequireWithin("max_log_odds", max_log_odds, 0, 1000);
  RequireWithin("max_time_gap_s", max_time_gap_s, 0, kUnlimited);
}

}  // namespace fallen
