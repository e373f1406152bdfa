// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "fallen/simd/lanes.hpp"

namespace fallen {

/// Symmetric 3 x 3 matrices side by side, coefficient by coefficient: xx xy xz yy yz zz.
struct alignas(64) MatrixBatch {
  std::array<std::array<float, kMostLanes>, 6> coefficients;
};

/// What is asked of them.
struct alignas(64) EigenBatch {
  std::array<std::array<float, kMostLanes>, 3> values;  ///< ascending
  std::array<std::array<float, kMostLanes>, 3>
      smallest;                                    ///< unit eigenvector of the smallest: x y z
  std::array<std::int32_t, kMostLanes> converged;  ///< 0: no result
};

/// Decomposes the matrices, which must be finite, as Eigen::SelfAdjointEigenSolver<Matrix3f> does:
/// operation by operation (tridiagonal form, implicit QR steps with Wilkinson's shift), lanes that
/// are done waiting for the others, so that values, vectors and their signs are Eigen's bit for
/// bit.
///
/// [Golub96] Golub, van Loan: Matrix computations, Alg. 8.3.2.
void DecomposeLikeEigen(const MatrixBatch& matrices, EigenBatch& result);

}  // namespace fallen
