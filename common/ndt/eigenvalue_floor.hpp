// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "fallen/ndt/symmetric_eigen.hpp"

namespace fallen {

/// Covariances side by side, coefficient by coefficient: xx xy xz yy yz zz, one a lane.
struct alignas(64) CovarianceLanes {
  static constexpr int kCount = 8;
  std::array<std::array<double, kCount>, 6> coefficients{};
};

/// FloorEigenvalues for all lanes at once.
///
/// Decomposed as in DecomposeSymmetric, and as exact; a few last bits may differ from it, since
/// nothing is sorted. The same bits at every SimdLevel.
void FloorEigenvalueLanes(CovarianceLanes& lanes, double ratio);

}  // namespace fallen
