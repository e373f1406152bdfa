// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/baseline_config.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

void Require(bool holds, const char* name, double got, const std::string& expected) {
  if (!holds || !std::isfinite(got))
    throw std::invalid_argument("baseline: " + std::string(name) + " is " + std::to_string(got) +
                                ", must be " + expected);
}

}  // namespace

void BaselineConfig::Validate() const {
  Require(max_range_m > 0, "max_range_m", max_range_m, "> 0");
  Require(ground_clearance_m >= 0, "ground_clearance_m", ground_clearance_m, ">= 0");
  Require(ground_clearance_per_sq_m >= 0, "ground_clearance_per_sq_m", ground_clearance_per_sq_m,
          ">= 0");
  Require(max_height_m > 0, "max_height_m", max_height_m, "> 0");
  Require(leaf_m > 0, "leaf_m", leaf_m, "> 0");
  Require(normal_radius_m >= leaf_m, "normal_radius_m", normal_radius_m, ">= leaf_m");
  Require(cluster_tolerance_m >= leaf_m, "cluster_tolerance_m", cluster_tolerance_m, ">= leaf_m");
  Require(min_cluster_points >= 3, "min_cluster_points", min_cluster_points, ">= 3");
  Require(layers >= 1 && layers <= 100, "layers", layers, "in [1, 100]");
  Require(layer_height_m > 0, "layer_height_m", layer_height_m, "> 0");
  Require(normal_bins >= 1 && normal_bins <= 100, "normal_bins", normal_bins, "in [1, 100]");
}

}  // namespace fallen
