// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

/// Eigenvalues and eigenvectors of symmetric 3 x 3 matrices, for thousands of cells a frame.
///
/// [Eberly14] Eberly: A robust eigensolver for 3 x 3 symmetric matrices. geometrictools.com, 2014.
namespace fallen {

/// Upper triangle xx xy xz yy yz zz of a symmetric matrix.
using SymmetricMatrix3 = std::array<double, 6>;

/// Invariant: `values` ascending, `vectors[i]` the unit eigenvector of `values[i]`, the three of
/// them orthogonal.
struct SymmetricEigen3 {
  std::array<double, 3> values{};
  std::array<std::array<double, 3>, 3> vectors{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// Decomposes a finite symmetric matrix by [Eberly14]: the eigenvalue that stands apart first, then
/// a 2 x 2 problem in the plane across its eigenvector, so that equal eigenvalues do no harm.
///
/// Differs from the source: the cubic is solved by Newton's method, with the four basic operations
/// and roots only, so that every processor gives the same bits. Absolute error ~1e-15 times the
/// largest eigenvalue.
SymmetricEigen3 DecomposeSymmetric(const SymmetricMatrix3& matrix);

}  // namespace fallen
