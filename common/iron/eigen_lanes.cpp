// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/eigen_lanes.hpp"

#include <limits>

#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

constexpr float kLeast = std::numeric_limits<float>::min();
constexpr float kInverseEpsilon = 1 / std::numeric_limits<float>::epsilon();
constexpr int kMaxSteps = 90;  // Eigen's limit for three rows

template <int kLanes>
struct Solver {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;

  Floats diagonal[3], below[2];  // of the tridiagonal matrix
  Floats columns[3][3];          // of the eigenvectors: [column][row]

  [[gnu::always_inline]] static void Abs(const Floats& value, Floats& result) {
    constexpr std::int32_t kAllButSign = 0x7fffffff;
    result = reinterpret_cast<Floats>(reinterpret_cast<Ints>(value) & kAllButSign);
  }

  [[gnu::always_inline]] void Tridiagonalize(const Floats& xx, const Floats& xy, const Floats& xz,
                                             const Floats& yy, const Floats& yz, const Floats& zz) {
    const Floats zero = {}, one = zero + 1.0f;
    const Floats sq_xz = xz * xz;
    const Ints is_done = sq_xz <= kLeast;
    Floats beta = is_done ? one : xy * xy + sq_xz;
    TakeRoots(beta);
    const Floats inverse = 1.0f / beta;
    const Floats m01 = xy * inverse, m02 = xz * inverse;
    const Floats q = 2.0f * m01 * yz + m02 * (zz - yy);
    diagonal[0] = xx;
    diagonal[1] = is_done ? yy : yy + m02 * q;
    diagonal[2] = is_done ? zz : zz - m02 * q;
    below[0] = is_done ? xy : beta;
    below[1] = is_done ? yz : yz - m01 * q;
    for (auto& column : columns)
      for (Floats& value : column) value = zero;
    columns[0][0] = one;
    columns[1][1] = is_done ? one : m01;
    columns[1][2] = is_done ? zero : m02;
    columns[2][1] = is_done ? zero : m02;
    columns[2][2] = is_done ? one : -m01;
  }

  [[gnu::always_inline]] void DropNegligible(int i) {
    Floats size, before, after;
    Abs(below[i], size);
    Abs(diagonal[i], before);
    Abs(diagonal[i + 1], after);
    const Floats scaled = kInverseEpsilon * below[i];
    const Ints negligible = (size < kLeast) | (scaled * scaled <= before + after);
    below[i] = negligible ? Floats{} : below[i];
  }

  // Wilkinson's shift for the block that ends with row `last`.
  [[gnu::always_inline]] static void Shift(const Floats& before_last, const Floats& last,
                                           const Floats& e, Floats& mu) {
    const Floats one = Floats{} + 1.0f;
    const Floats td = (before_last - last) * 0.5f;
    Floats size_td, size_e;
    Abs(td, size_td);
    Abs(e, size_e);
    // The hypotenuse, as Eigen has it: nothing overflows.
    const Floats larger = size_td < size_e ? size_e : size_td;
    const Floats smaller = size_e < size_td ? size_e : size_td;
    const Floats ratio = smaller / (larger > 0 ? larger : one);
    Floats root = 1.0f + ratio * ratio;
    TakeRoots(root);
    const Floats h = larger * root;
    const Floats sum = td + (td > 0 ? h : -h);
    const Floats sq_e = e * e;
    const Ints underflows = sq_e == 0;
    const Floats numerator = underflows ? e : sq_e;
    Floats denominator = underflows ? sum / e : sum;
    denominator = td == 0 ? one : denominator;
    mu = last - (td == 0 ? size_e : numerator / denominator);
  }

  // Givens rotation that turns (p, q) to (r, 0), q not 0.
  [[gnu::always_inline]] static void Givens(const Floats& p, const Floats& q, Floats& c,
                                            Floats& s) {
    Floats size_p, size_q;
    Abs(p, size_p);
    Abs(q, size_q);
    const Ints p_larger = size_p > size_q;
    const Floats larger = p_larger ? p : q;
    const Floats t = (p_larger ? q : p) / (larger == 0 ? Floats{} + 1.0f : larger);
    Floats u = 1.0f + t * t;
    TakeRoots(u);
    u = larger < 0 ? -u : u;
    const Floats of_larger = (p_larger ? Floats{} + 1.0f : Floats{} - 1.0f) / u;
    const Floats of_smaller = -t * of_larger;
    c = p_larger ? of_larger : of_smaller;
    s = p_larger ? of_smaller : of_larger;
    c = p == 0 ? Floats{} : c;
  }

  // Turns rows and columns k and k + 1, where `turns`; elsewhere by no angle, which changes
  // nothing.
  [[gnu::always_inline]] void Rotate(int k, const Ints& turns, Floats& c, Floats& s) {
    c = turns ? c : Floats{} + 1.0f;
    s = turns ? s : Floats{};
    const Floats d0 = diagonal[k], d1 = diagonal[k + 1], b = below[k];
    const Floats sdk = s * d0 + c * b;
    const Floats dkp1 = s * b + c * d1;
    diagonal[k] = c * (c * d0 - s * b) - s * (c * b - s * d1);
    diagonal[k + 1] = s * sdk + c * dkp1;
    below[k] = c * sdk - s * dkp1;
    for (int row = 0; row < 3; ++row) {
      const Floats x = columns[k][row], y = columns[k + 1][row];
      columns[k][row] = c * x - s * y;
      columns[k + 1][row] = s * x + c * y;
    }
  }

  // One QR step in every lane that is not done; false if there is none.
  [[gnu::always_inline]] bool Step() {
    DropNegligible(0);
    DropNegligible(1);
    // The block that is left: all three rows, the last two, or the first two.
    const Ints has_first = below[0] != 0, has_last = below[1] != 0;
    const bool goes_on_anywhere = AnyOf(has_first | has_last);
    const Ints whole = has_first & has_last;

    Floats mu;
    Shift(has_last ? diagonal[1] : diagonal[0], has_last ? diagonal[2] : diagonal[1],
          has_last ? below[1] : below[0], mu);
    Floats c, s;
    Givens(diagonal[0] - mu, has_first ? below[0] : Floats{} + 1.0f, c, s);
    const Floats below_last = below[1];
    Rotate(0, has_first, c, s);
    const Floats bulge = -s * below_last;
    below[1] = whole ? c * below_last : below[1];

    const Ints goes_on = has_last & ~(whole & (bulge == 0));
    const Floats x = whole ? below[0] : diagonal[1] - mu;
    const Floats z = whole ? bulge : below[1];
    Givens(x, goes_on ? z : Floats{} + 1.0f, c, s);
    Rotate(1, goes_on, c, s);
    below[0] = (whole & goes_on) ? c * below[0] - s * z : below[0];
    return goes_on_anywhere;
  }

  [[gnu::always_inline]] static void Sort(Floats& low, Floats& high) {
    const Floats larger = low > high ? low : high;
    low = low > high ? high : low;
    high = larger;
  }
};

// The matrices of kLanes lanes on their way.
template <int kLanes>
struct Decomposition {
  typename Lanes<kLanes>::Floats scale;
  Solver<kLanes> solver;
};

template <int kLanes>
[[gnu::always_inline]] inline void Start(const MatrixBatch& matrices, int lane,
                                         Decomposition<kLanes>& part) {
  using Floats = typename Lanes<kLanes>::Floats;
  Floats m[6], scale = {};
  for (int k = 0; k < 6; ++k) {
    Load(m[k], matrices.coefficients[k].data() + lane);
    Floats size;
    Solver<kLanes>::Abs(m[k], size);
    scale = size > scale ? size : scale;
  }
  part.scale = scale == 0 ? Floats{} + 1.0f : scale;
  for (Floats& value : m) value /= part.scale;
  part.solver.Tridiagonalize(m[0], m[1], m[2], m[3], m[4], m[5]);
}

template <int kLanes>
[[gnu::always_inline]] inline void Finish(Decomposition<kLanes>& part, int lane,
                                          EigenBatch& result) {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;
  Solver<kLanes>& solver = part.solver;
  solver.DropNegligible(0);
  solver.DropNegligible(1);
  const Ints converged = (solver.below[0] == 0) & (solver.below[1] == 0);
  Store(converged, result.converged.data() + lane);

  Floats* const d = solver.diagonal;
  Floats least = d[0];
  Floats vector[3] = {solver.columns[0][0], solver.columns[0][1], solver.columns[0][2]};
  for (int column = 1; column < 3; ++column) {
    const Ints is_less = d[column] < least;
    least = is_less ? d[column] : least;
    for (int row = 0; row < 3; ++row)
      vector[row] = is_less ? solver.columns[column][row] : vector[row];
  }
  for (int row = 0; row < 3; ++row) Store(vector[row], result.smallest[row].data() + lane);
  solver.Sort(d[0], d[1]);
  solver.Sort(d[1], d[2]);
  solver.Sort(d[0], d[1]);
  for (int k = 0; k < 3; ++k) {
    const Floats value = d[k] * part.scale;
    Store(value, result.values[k].data() + lane);
  }
}

// Two registers' worth in turn: a step is a chain of roots and divisions, and the processor works
// on one while it waits for the other.
template <int kLanes>
[[gnu::always_inline]] inline void DecomposeBatch(const MatrixBatch& matrices, EigenBatch& result) {
  for (int lane = 0; lane < kMostLanes; lane += 2 * kLanes) {
    Decomposition<kLanes> first, second;
    Start(matrices, lane, first);
    Start(matrices, lane + kLanes, second);
    for (int step = 0; step < kMaxSteps; ++step) {
      const bool first_goes_on = first.solver.Step();
      const bool second_goes_on = second.solver.Step();
      if (!first_goes_on && !second_goes_on) break;
    }
    Finish(first, lane, result);
    Finish(second, lane + kLanes, result);
  }
}

void DecomposePortable(const MatrixBatch& matrices, EigenBatch& result) {
  DecomposeBatch<kPortableLanes>(matrices, result);
}
FALLEN_TARGET_AVX2 void DecomposeAvx2(const MatrixBatch& matrices, EigenBatch& result) {
  DecomposeBatch<kAvx2Lanes>(matrices, result);
}
// With masks in registers of their own.
FALLEN_TARGET_AVX512 void DecomposeAvx512(const MatrixBatch& matrices, EigenBatch& result) {
  DecomposeBatch<kAvx2Lanes>(matrices, result);
}

}  // namespace

void DecomposeLikeEigen(const MatrixBatch& matrices, EigenBatch& result) {
  ChooseSimd(DecomposePortable, DecomposeAvx2, DecomposeAvx512)(matrices, result);
}

}  // namespace fallen
