// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/voxel_statistics.hpp"

#include <algorithm>

namespace fallen {
namespace {

SymmetricMatrix3 OuterProduct(const std::array<double, 3>& v) {
  return {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]};
}

}  // namespace

SymmetricMatrix3 Moments::Covariance() const {
  SymmetricMatrix3 covariance{};
  if (count < 2) return covariance;
  for (int k = 0; k < 6; ++k) covariance[k] = scatter[k] / (count - 1);
  return covariance;
}

Moments MomentsOf(const PointSums<double>& sums) {
  Moments moments;
  if (sums.count <= 0) return moments;
  moments.count = sums.count;
  for (int k = 0; k < 3; ++k) moments.mean[k] = sums.sum[k] / sums.count;
  const SymmetricMatrix3 sq_mean = OuterProduct(moments.mean);
  for (int k = 0; k < 6; ++k) moments.scatter[k] = sums.square[k] - sums.count * sq_mean[k];
  return moments;
}

Moments Merge(const Moments& a, const Moments& b) {
  if (a.count <= 0) return b;
  if (b.count <= 0) return a;
  Moments merged;
  merged.count = a.count + b.count;
  std::array<double, 3> difference;
  for (int k = 0; k < 3; ++k) {
    difference[k] = b.mean[k] - a.mean[k];
    merged.mean[k] = a.mean[k] + difference[k] * (b.count / merged.count);
  }
  const SymmetricMatrix3 between = OuterProduct(difference);
  const double weight = a.count * b.count / merged.count;
  for (int k = 0; k < 6; ++k) merged.scatter[k] = a.scatter[k] + b.scatter[k] + weight * between[k];
  return merged;
}

void LimitCount(Moments& moments, double max_count) {
  if (moments.count <= max_count) return;
  const double scale = (max_count - 1) / (moments.count - 1);
  for (double& value : moments.scatter) value *= scale;
  moments.count = max_count;
}

// The trace is at least the largest eigenvalue, and the smallest is above what must be if the
// matrix less that much of the identity is positive definite, which its leading minors tell
// (Sylvester).
bool EigenvaluesSurelyStay(const SymmetricMatrix3& m, double ratio) {
  const double least = std::max(ratio * (m[0] + m[3] + m[5]), kMinVariance);
  const double xx = m[0] - least, yy = m[3] - least, zz = m[5] - least;
  const double minor = xx * yy - m[1] * m[1];
  const double determinant =
      minor * zz - xx * m[4] * m[4] - yy * m[2] * m[2] + 2 * m[1] * m[2] * m[4];
  return xx > 0 && minor > 0 && determinant > 0;
}

SymmetricMatrix3 FloorEigenvalues(const SymmetricMatrix3& covariance, double ratio) {
  if (EigenvaluesSurelyStay(covariance, ratio)) return covariance;
  const SymmetricEigen3 eigen = DecomposeSymmetric(covariance);
  const double least = std::max(ratio * eigen.values[2], kMinVariance);
  if (eigen.values[0] >= least) return covariance;
  // Raised by what is missing along each short axis, so that the long ones keep their digits.
  SymmetricMatrix3 floored = covariance;
  for (int i = 0; i < 3; ++i) {
    const double missing = least - eigen.values[i];
    if (missing <= 0) continue;
    const SymmetricMatrix3 along = OuterProduct(eigen.vectors[i]);
    for (int k = 0; k < 6; ++k) floored[k] += missing * along[k];
  }
  return floored;
}

}  // namespace fallen
