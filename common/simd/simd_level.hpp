// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// How kernels are made for several widths of vector registers in one program.
///
/// A kernel is compiled once a level, as plain functions of the same type over plain pointers, and
/// chosen at each call by ChooseSimd. All variants of a kernel do the same operations on each
/// number in the same order (nothing is compiled with -march or -ffast-math, and nothing is
/// contracted to fused operations), so that results are the same bits on every processor.
namespace fallen {

enum class SimdLevel : std::int32_t {
  kPortable = 0,  ///< what every processor of the architecture has: SSE2, NEON
  kAvx2 = 1,
  kAvx512 = 2,  ///< F, BW, DQ and VL: every AVX-512 processor since 2017 but for Xeon Phi
};

/// The widest level that this processor has. Thread-safe.
SimdLevel MachineSimdLevel();

/// The level that kernels run at: the machine's, unless limited.
SimdLevel ActiveSimdLevel();

/// Limits the level of this process, so that tests can compare the variants of all kernels.
void LimitSimdLevel(SimdLevel widest);

/// The variant of a kernel that is to run. One may stand for two levels.
template <class Function>
Function* ChooseSimd(Function* portable, Function* avx2, Function* avx512) {
  switch (ActiveSimdLevel()) {
    case SimdLevel::kAvx512:
      return avx512;
    case SimdLevel::kAvx2:
      return avx2;
    case SimdLevel::kPortable:
      break;
  }
  return portable;
}

}  // namespace fallen

#if defined(__x86_64__)
/// Before a function: it may use the instructions of the level. Only ChooseSimd may lead to it.
#define FALLEN_TARGET_AVX2 [[gnu::target("avx2")]]
#define FALLEN_TARGET_AVX512 [[gnu::target("avx512f,avx512bw,avx512dq,avx512vl")]]
#else
#define FALLEN_TARGET_AVX2
#define FALLEN_TARGET_AVX512
#endif
