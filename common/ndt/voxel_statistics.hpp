// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
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
  SymmetricMatrix3 Covariance() const {
    SymmetricMatrix3 covariance{};
    if (count < 2) return covariance;
    const double weight = 1 / (count - 1);
    for (int k = 0; k < 6; ++k) covariance[k] = scatter[k] * weight;
    return covariance;
  }
};

/// v v^T.
inline SymmetricMatrix3 OuterProduct(const std::array<double, 3>& v) {
  return {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]};
}

inline Moments MomentsOf(const PointSums<double>& sums) {
  Moments moments;
  if (sums.count <= 0) return moments;
  moments.count = sums.count;
  const double weight = 1 / sums.count;
  for (int k = 0; k < 3; ++k) moments.mean[k] = sums.sum[k] * weight;
  const SymmetricMatrix3 sq_mean = OuterProduct(moments.mean);
  for (int k = 0; k < 6; ++k) moments.scatter[k] = sums.square[k] - sums.count * sq_mean[k];
  return moments;
}

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
///
/// The trace is at least the largest eigenvalue, and the smallest is above what must be if the
/// matrix less that much of the identity is positive definite, which its leading minors tell
/// (Sylvester).
inline bool EigenvaluesSurelyStay(const SymmetricMatrix3& m, double ratio) {
  const double least = std::max(ratio * (m[0] + m[3] + m[5]), kMinVariance);
  const double xx = m[0] - least, yy = m[3] - least, zz = m[5] - least;
  const double minor = xx * yy - m[1] * m[1];
  const double determinant =
      minor * zz - xx * m[4] * m[4] - yy * m[2] * m[2] + 2 * m[1] * m[2] * m[4];
  return xx > 0 && minor > 0 && determinant > 0;
}

/// Raises eigenvalues below `ratio` times the largest to that, and all to at least kMinVariance:
/// the result is positive definite, a single spot too. Untouched, bit for bit, if there are none.
/// [Saarinen13]
SymmetricMatrix3 FloorEigenvalues(const SymmetricMatrix3& covariance, double ratio);

}  // namespace fallen
