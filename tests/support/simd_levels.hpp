// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/simd/simd_level.hpp"

namespace fallen::test {

/// Calls `run(level)` at every level that this machine has, narrowest first.
template <class Run>
void AtEverySimdLevel(const Run& run) {
  for (const SimdLevel level : {SimdLevel::kPortable, SimdLevel::kAvx2, SimdLevel::kAvx512}) {
    if (level > MachineSimdLevel()) break;
    LimitSimdLevel(level);
    run(level);
  }
  LimitSimdLevel(SimdLevel::kAvx512);
}

}  // namespace fallen::test
