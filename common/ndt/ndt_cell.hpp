// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace fallen {

/// One normal distribution of an NDT map: a surface patch inside one voxel.
///
/// Invariant: all values finite, covariance symmetric and positive definite (its eigenvalues are
/// floored, see NdtConfig), `point_count` > 0.
struct NdtCell {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();  ///< map frame [m]
  std::array<float, 6> covariance{};               ///< upper triangle xx xy xz yy yz zz [m^2]
  std::uint32_t point_count = 0;                   ///< points merged, after adaptation
  float occupancy = 0;                             ///< log-odds that the voxel is occupied

  Eigen::Matrix3f CovarianceMatrix() const {
    Eigen::Matrix3f matrix;
    matrix << covariance[0], covariance[1], covariance[2],  //
        covariance[1], covariance[3], covariance[4],        //
        covariance[2], covariance[4], covariance[5];
    return matrix;
  }
  bool operator==(const NdtCell&) const = default;
};

}  // namespace fallen
