// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace fallen {

/// Told what is going on and what share of it is done, [0, 1]. Called from several threads.
using TrainingProgress = std::function<void(const char* step, double share)>;

}  // namespace fallen
