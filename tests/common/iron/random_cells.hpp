// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fallen/ndt/ndt_cell.hpp"

namespace fallen {

/// A cell of ten points.
NdtCell MakeCell(const Eigen::Vector3f& mean, const Eigen::Matrix3f& covariance);

/// Flat cells of random orientation, with some balls and needles, in a box of `size_m` about
/// `center`.
std::vector<NdtCell> RandomCells(int count, float size_m, const Eigen::Vector3f& center, int seed);

}  // namespace fallen
