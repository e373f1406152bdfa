// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <string>

#include "fallen/iron/iron_descriptor.hpp"

namespace fallen {
namespace {

// More bins than this along one axis leave hardly a neighbour per bin.
constexpr int kMaxBins = 32;

void Require(bool holds, const char* name, double value, const char* expected) {
  if (holds) return;
  throw std::invalid_argument("iron: " + std::string(name) + " is " + std::to_string(value) +
                              ", must be " + expected);
}

}  // namespace

void IronConfig::Validate() const {
  Require(std::isfinite(radius_m) && radius_m > 0 && radius_m <= 100, "radius_m", radius_m,
          "in (0, 100]");
  Require(distance_bins >= 1 && distance_bins <= kMaxBins, "distance_bins", distance_bins,
          "in [1, 32]");
  Require(angle_bins >= 1 && angle_bins <= kMaxBins, "angle_bins", angle_bins, "in [1, 32]");
  Require(max_ball_ratio >= 0 && max_ball_ratio <= 1, "max_ball_ratio", max_ball_ratio,
          "in [0, 1]");
  Require(min_needle_ratio >= 0 && min_needle_ratio <= 1, "min_needle_ratio", min_needle_ratio,
          "in [0, 1]");
  Require(min_neighbors >= 1, "min_neighbors", min_neighbors, "at least 1");
}

}  // namespace fallen
