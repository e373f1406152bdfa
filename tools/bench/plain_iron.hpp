// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "fallen/iron/iron_descriptor.hpp"

namespace fallen {

/// Normals and descriptors of all cells in the plain way: one eigenvalue problem after the other,
/// FLANN's k-d tree searched within the radius around each cell, one arccosine an angle.
IronDescriptors DescribePlainly(std::span<const NdtCell> cells, const IronConfig& config = {});

}  // namespace fallen
