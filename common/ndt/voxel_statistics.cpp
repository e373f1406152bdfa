// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/voxel_statistics.hpp"

#include <algorithm>

namespace fallen {

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
