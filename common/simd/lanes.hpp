// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// Vector registers as numbers, in the vector extensions of GCC and Clang: the same source makes
/// the variants of a kernel for all levels. To be used in functions that are inlined into one with
/// a target (`[[gnu::always_inline]]`); vectors are passed by reference, for a function without the
/// target could not take them by value.
namespace fallen {

/// Numbers that a register holds at each level. Compilers make good code of vectors of up to eight
/// numbers; kernels for sixteen are written in intrinsics.
inline constexpr int kPortableLanes = 4;
inline constexpr int kAvx2Lanes = 8;
inline constexpr int kMostLanes = 16;

template <int kLanes>
struct Lanes;

#define FALLEN_LANES(count)                                                 \
  template <>                                                               \
  struct Lanes<count> {                                                     \
    using Floats = float __attribute__((vector_size(4 * (count))));         \
    using Ints = std::int32_t __attribute__((vector_size(4 * (count))));    \
    using Shorts = std::uint16_t __attribute__((vector_size(2 * (count)))); \
  }
FALLEN_LANES(4);
FALLEN_LANES(8);
#undef FALLEN_LANES

/// The same for double precision: half as many in a register.
template <int kLanes>
struct DoubleLanes;

#define FALLEN_DOUBLE_LANES(count)                                        \
  template <>                                                             \
  struct DoubleLanes<count> {                                             \
    using Doubles = double __attribute__((vector_size(8 * (count))));     \
    using Longs = std::int64_t __attribute__((vector_size(8 * (count)))); \
  }
FALLEN_DOUBLE_LANES(2);
FALLEN_DOUBLE_LANES(4);
#undef FALLEN_DOUBLE_LANES

template <class Vector, class Scalar>
[[gnu::always_inline]] inline void Load(Vector& vector, const Scalar* from) {
  std::memcpy(&vector, from, sizeof(vector));
}

template <class Vector, class Scalar>
[[gnu::always_inline]] inline void Store(const Vector& vector, Scalar* to) {
  std::memcpy(to, &vector, sizeof(vector));
}

/// One instruction, given -fno-math-errno.
template <class Vector>
[[gnu::always_inline]] inline void TakeRoots(Vector& values) {
  for (std::size_t lane = 0; lane < sizeof(values) / sizeof(values[0]); ++lane)
    values[lane] = std::sqrt(values[lane]);
}

/// True if any lane of a comparison is.
template <class Ints>
[[gnu::always_inline]] inline bool AnyOf(const Ints& mask) {
#if defined(__SSE2__)
  if constexpr (sizeof(Ints) == 2 * sizeof(__m128i)) {
    __m128i halves[2];
    std::memcpy(halves, &mask, sizeof(mask));
    return _mm_movemask_epi8(_mm_or_si128(halves[0], halves[1])) != 0;
  }
#endif
  std::uint64_t words[sizeof(Ints) / sizeof(std::uint64_t)];
  std::memcpy(words, &mask, sizeof(mask));
  std::uint64_t any = 0;
  for (const std::uint64_t word : words) any |= word;
  return any != 0;
}

}  // namespace fallen
