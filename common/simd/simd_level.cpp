// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/simd/simd_level.hpp"

#include <algorithm>
#include <atomic>

namespace fallen {
namespace {

SimdLevel DetectLevel() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return SimdLevel::kAvx512;
  if (__builtin_cpu_supports("avx2")) return SimdLevel::kAvx2;
#endif
  return SimdLevel::kPortable;
}

std::atomic<SimdLevel> widest_level{SimdLevel::kAvx512};

}  // namespace

SimdLevel MachineSimdLevel() {
  static const SimdLevel level = DetectLevel();
  return level;
}

SimdLevel ActiveSimdLevel() {
  return std::min(MachineSimdLevel(), widest_level.load(std::memory_order_relaxed));
}

void LimitSimdLevel(SimdLevel widest) { widest_level = widest; }

}  // namespace fallen
