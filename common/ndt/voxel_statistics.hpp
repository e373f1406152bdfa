// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fallen/ndt/symmetric_eigen.hpp"

/// Mean and scatter of the points in one voxel, gathered in one pass.
///
/// Everything is relative to the voxel's centre: offsets of at most half a cell keep their digits,
/// however far from the origin of the map the voxel lies.
namespace fallen {

/// Sums over points, offsets from the voxel centre.
template <class Scalar>
struct PointSums {
  Scalar count = 0;
  std::array<Scalar, 3> sum{};     ///< [m]
  std::array<Scalar, 6> square{};  ///< xx xy xz yy yz zz [m^2]

  void Add(Scalar x, Scalar y, Scalar z) {
    count += 1;
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
    square[0] += x * x;
    square[1] += x * y;
    square[2] += x * z;
    square[3] += y * y;
    square[4] += y * z;
    square[5] += z * z;
  }

  template <class Other>
  void Add(const PointSums<Other>& other) {
    count += other.count;
    for (int k = 0; k < 3; ++k) sum[k] += other.sum[k];
    for (int k = 0; k < 6; ++k) square[k] += other.square[k];
  }
};

/// Count, mean and scatter: what is kept of the points.
struct Moments {
  double count = 0;
  std::array<double, 3> mean{};  ///< offset from the voxel centre [m]
  SymmetricMatrix3 scatter{};    ///< sum of (p - mean)(p - mean)^T [m^2]

  /// Scatter / (count - 1); zero for less than two points.
  SymmetricMatrix3 Covariance() const;
};

Moments MomentsOf(const PointSums<double>& sums);

/// Moments of the union of two sets of points. [Einhorn15]: S = S1 + S2 + n1 n2 / (n1 + n2) d d^T,
/// where d is the difference of the means.
Moments Merge(const Moments& a, const Moments& b);

/// Scales down to `max_count` points of the same mean and covariance, if there are more: points to
/// come keep their weight, so that the map forgets. [Einhorn15]
void LimitCount(Moments& moments, double max_count);

/// Least ratio of a cell's eigenvalues at which its covariance stays positive definite when it is
/// stored in single precision: some 16 steps of a float.
inline constexpr double kLeastEigenvalueRatio = 1e-6;

/// (30 um)^2 [m^2]: far below any depth sensor's noise, far above what float keeps of a covariance.
inline constexpr double kMinVariance = 1e-9;

/// A quick test, true for many cells: FloorEigenvalues leaves such a matrix as it is.
bool EigenvaluesSurelyStay(const SymmetricMatrix3& covariance, double ratio);

/// Raises eigenvalues below `ratio` times the largest to that, and all to at least kMinVariance:
/// the result is positive definite, a single spot too. Untouched, bit for bit, if there are none.
/// [Saarinen13]
SymmetricMatrix3 FloorEigenvalues(const SymmetricMatrix3& covariance, double ratio);

}  // namespace fallen
