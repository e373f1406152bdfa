// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// A cell like a disc of 1.5 cm across its normal and 2 mm along it (standard deviations).
inline NdtCell FlatCell(const Eigen::Vector3f& mean,
                        const Eigen::Vector3f& normal = Eigen::Vector3f::UnitZ()) {
  constexpr float kAcross = 0.015F * 0.015F;
  constexpr float kAlong = 0.002F * 0.002F;
  const Eigen::Matrix3f covariance =
      kAcross * Eigen::Matrix3f::Identity() +
      (kAlong - kAcross) * normal.normalized() * normal.normalized().transpose();
  NdtCell cell;
  cell.mean = mean;
  cell.covariance = {covariance(0, 0), covariance(0, 1), covariance(0, 2),
                     covariance(1, 1), covariance(1, 2), covariance(2, 2)};
  cell.point_count = 10;
  return cell;
}

}  // namespace fallen
