// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "tools/simulate/random.hpp"

namespace fallen::sim {

/// Smooth random field over space: value noise on the integer lattice, trilinear with eased
/// weights.
class SmoothNoise {
 public:
  explicit SmoothNoise(std::uint64_t seed) : seed_(seed) {}

  /// In [-1, 1]; changes over a distance of about 1.
  double At(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d cell = p.array().floor();
    const Eigen::Vector3d t = p - cell;
    const Eigen::Vector3d w = t.array().square() * (3 - 2 * t.array());
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      std::uint64_t hash = seed_;
      for (int axis = 0; axis < 3; ++axis) {
        const int up = (corner >> axis) & 1;
        weight *= up ? w[axis] : 1 - w[axis];
        hash =
            MixBits(hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]) + up));
      }
      sum += weight * (static_cast<double>(hash >> 11) * 0x1p-52 - 1);
    }
    return sum;
  }

 private:
  std::uint64_t seed_;
};

}  // namespace fallen::sim
