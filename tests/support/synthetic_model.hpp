// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/detection/model.hpp"

namespace fallen::testing_support {

/// A model that needs no training: it takes what is higher than low for person, so that the
/// synthetic scene has clusters, and judges them with numbers in which every bit of their
/// descriptors shows.
Model SyntheticModel(double cell_size_m = 0.05);

}  // namespace fallen::testing_support
