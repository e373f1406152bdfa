// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/eigenvalue_floor.hpp"

#include "fallen/ndt/voxel_statistics.hpp"
#include "fallen/simd/lanes.hpp"
#include "fallen/simd/simd_level.hpp"

// DecomposeSymmetric without branches: what it decides by `if`, masks decide here lane by lane. See
// there for the reasons.
namespace fallen {
namespace {

template <int kLanes>
struct Floor {
  using Doubles = typename DoubleLanes<kLanes>::Doubles;
  using Longs = typename DoubleLanes<kLanes>::Longs;
  struct Vector {
    Doubles x, y, z;
  };
  struct Matrix {
    Doubles xx, xy, xz, yy, yz, zz;
  };

  [[gnu::always_inline]] static void Larger(const Doubles& a, const Doubles& b, Doubles& result) {
    result = a > b ? a : b;
  }

  [[gnu::always_inline]] static void Dot(const Vector& a, const Vector& b, Doubles& result) {
    result = a.x * b.x + a.y * b.y + a.z * b.z;
  }

  [[gnu::always_inline]] static void Cross(const Vector& a, const Vector& b, Vector& result) {
    result = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }

  [[gnu::always_inline]] static void Multiply(const Matrix& m, const Vector& v, Vector& result) {
    result = {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
              m.xz * v.x + m.yz * v.y + m.zz * v.z};
  }

  [[gnu::always_inline]] static void Scale(const Doubles& factor, Vector& v) {
    v = {v.x * factor, v.y * factor, v.z * factor};
  }

  // cos(acos(h) / 3) for h in [0, 1].
  [[gnu::always_inline]] static void CosOfThirdAngle(const Doubles& h, Doubles& c) {
    constexpr double kCos30 = 0.86602540378443865;
    c = kCos30 + (1 - kCos30) * h;
    for (int step = 0; step < 3; ++step) c -= ((4 * c * c - 3) * c - h) / (12 * c * c - 3);
  }

  [[gnu::always_inline]] static void TakeIfLonger(const Vector& candidate, Vector& best,
                                                  Doubles& sq_best) {
    Doubles sq_norm;
    Dot(candidate, candidate, sq_norm);
    const Longs longer = sq_norm > sq_best;
    best = {longer ? candidate.x : best.x, longer ? candidate.y : best.y,
            longer ? candidate.z : best.z};
    sq_best = longer ? sq_norm : sq_best;
  }

  [[gnu::always_inline]] static void EigenvectorOfIsolated(const Matrix& m, const Doubles& value,
                                                           Vector& axis) {
    const Vector row0 = {m.xx - value, m.xy, m.xz};
    const Vector row1 = {m.xy, m.yy - value, m.yz};
    const Vector row2 = {m.xz, m.yz, m.zz - value};
    Doubles sq_best;
    Cross(row0, row1, axis);
    Dot(axis, axis, sq_best);
    Vector candidate;
    Cross(row0, row2, candidate);
    TakeIfLonger(candidate, axis, sq_best);
    Cross(row1, row2, candidate);
    TakeIfLonger(candidate, axis, sq_best);
    Doubles norm = sq_best > 0 ? sq_best : Doubles{} + 1;
    TakeRoots(norm);
    Scale(1 / norm, axis);
  }

  [[gnu::always_inline]] static void UnitAcross(const Vector& w, Vector& u) {
    const Longs x_longer = w.x * w.x > w.y * w.y;
    const Doubles longer = x_longer ? w.x : w.y;
    Doubles norm = longer * longer + w.z * w.z;
    norm = norm > 0 ? norm : Doubles{} + 1;
    TakeRoots(norm);
    const Doubles scale = 1 / norm, zero = {};
    u = {x_longer ? -w.z * scale : zero, x_longer ? zero : w.z * scale,
         x_longer ? w.x * scale : -w.y * scale};
  }

  [[gnu::always_inline]] static void Pick(const Longs& where, const Doubles& other_value,
                                          const Vector& other_axis, Doubles& value, Vector& axis) {
    value = where ? other_value : value;
    axis = {where ? other_axis.x : axis.x, where ? other_axis.y : axis.y,
            where ? other_axis.z : axis.z};
  }

  // Adds what is missing along the unit vector `v` whose eigenvalue is `value`.
  [[gnu::always_inline]] static void Raise(const Doubles& value, const Doubles& least,
                                           const Vector& v, Matrix& m) {
    const Doubles zero = {};
    const Doubles missing = value < least ? least - value : zero;
    m.xx += missing * (v.x * v.x);
    m.xy += missing * (v.x * v.y);
    m.xz += missing * (v.x * v.z);
    m.yy += missing * (v.y * v.y);
    m.yz += missing * (v.y * v.z);
    m.zz += missing * (v.z * v.z);
  }

  [[gnu::always_inline]] static void Apply(double ratio, Matrix& matrix) {
    const Doubles one = Doubles{} + 1, zero = {};
    Doubles scale = zero;
    for (const Doubles* value :
         {&matrix.xx, &matrix.xy, &matrix.xz, &matrix.yy, &matrix.yz, &matrix.zz})
      Larger(*value < 0 ? -*value : *value, scale, scale);
    const Doubles inverse_scale = 1 / (scale > 0 ? scale : one);
    Matrix m = matrix;
    for (Doubles* value : {&m.xx, &m.xy, &m.xz, &m.yy, &m.yz, &m.zz}) *value *= inverse_scale;
    const Doubles mean = (m.xx + m.yy + m.zz) / 3;
    for (Doubles* value : {&m.xx, &m.yy, &m.zz}) *value -= mean;
    const Doubles sq_off_diagonal = m.xy * m.xy + m.xz * m.xz + m.yz * m.yz;
    Doubles spread = (m.xx * m.xx + m.yy * m.yy + m.zz * m.zz + 2 * sq_off_diagonal) / 6;
    TakeRoots(spread);
    const Longs is_diagonal = (sq_off_diagonal == 0) | (spread == 0);
    const Doubles inverse_spread = 1 / (is_diagonal ? one : spread);
    for (Doubles* value : {&m.xx, &m.xy, &m.xz, &m.yy, &m.yz, &m.zz}) *value *= inverse_spread;
    const Doubles determinant = m.xx * (m.yy * m.zz - m.yz * m.yz) -
                                m.xy * (m.xy * m.zz - m.yz * m.xz) +
                                m.xz * (m.xy * m.yz - m.yy * m.xz);
    const Longs largest_apart = determinant >= 0;
    Doubles cosine = (largest_apart ? determinant : -determinant) / 2;
    cosine = cosine > 1 ? one : cosine;
    Doubles apart;
    CosOfThirdAngle(cosine, apart);
    apart = largest_apart ? 2 * apart : -2 * apart;

    // The plane across the eigenvector of the value that stands apart.
    Vector w, u, v, mu, mv;
    EigenvectorOfIsolated(m, apart, w);
    UnitAcross(w, u);
    Cross(w, u, v);
    Multiply(m, u, mu);
    Multiply(m, v, mv);
    Doubles uu, uv, vv;
    Dot(u, mu, uu);
    Dot(v, mu, uv);
    Dot(v, mv, vv);
    const Doubles middle = (uu + vv) / 2, half_difference = (uu - vv) / 2;
    Doubles root = half_difference * half_difference + uv * uv;
    TakeRoots(root);
    const Longs u_larger = half_difference >= 0;
    Doubles cu = u_larger ? half_difference + root : uv;
    Doubles cv = u_larger ? uv : root - half_difference;
    Doubles norm = cu * cu + cv * cv;
    TakeRoots(norm);
    const Longs has_direction = norm > 0;
    norm = has_direction ? norm : one;
    cu = has_direction ? cu / norm : one;
    cv = has_direction ? cv / norm : zero;
    Vector high_axis = {cu * u.x + cv * v.x, cu * u.y + cv * v.y, cu * u.z + cv * v.z};
    Vector low_axis;
    Cross(high_axis, w, low_axis);

    // A diagonal matrix has its axes and values already.
    Doubles value0 = (mean + spread * apart) * scale;
    Doubles value1 = (mean + spread * (middle - root)) * scale;
    Doubles value2 = (mean + spread * (middle + root)) * scale;
    Pick(is_diagonal, matrix.xx, {one, zero, zero}, value0, w);
    Pick(is_diagonal, matrix.yy, {zero, one, zero}, value1, low_axis);
    Pick(is_diagonal, matrix.zz, {zero, zero, one}, value2, high_axis);
    Doubles least;
    Larger(value0, value1, least);
    Larger(value2, least, least);
    Larger(ratio * least, Doubles{} + kMinVariance, least);
    Raise(value0, least, w, matrix);
    Raise(value1, least, low_axis, matrix);
    Raise(value2, least, high_axis, matrix);
  }
};

template <int kLanes>
[[gnu::always_inline]] inline void FloorLanes(CovarianceLanes& lanes, double ratio) {
  auto& c = lanes.coefficients;
  for (int lane = 0; lane < CovarianceLanes::kCount; lane += kLanes) {
    typename Floor<kLanes>::Matrix m;
    Load(m.xx, c[0].data() + lane);
    Load(m.xy, c[1].data() + lane);
    Load(m.xz, c[2].data() + lane);
    Load(m.yy, c[3].data() + lane);
    Load(m.yz, c[4].data() + lane);
    Load(m.zz, c[5].data() + lane);
    Floor<kLanes>::Apply(ratio, m);
    Store(m.xx, c[0].data() + lane);
    Store(m.xy, c[1].data() + lane);
    Store(m.xz, c[2].data() + lane);
    Store(m.yy, c[3].data() + lane);
    Store(m.yz, c[4].data() + lane);
    Store(m.zz, c[5].data() + lane);
  }
}

void FloorPortable(CovarianceLanes& lanes, double ratio) { FloorLanes<2>(lanes, ratio); }

FALLEN_TARGET_AVX2 void FloorAvx2(CovarianceLanes& lanes, double ratio) {
  FloorLanes<4>(lanes, ratio);
}
// With masks in registers of their own.
FALLEN_TARGET_AVX512 void FloorAvx512(CovarianceLanes& lanes, double ratio) {
  FloorLanes<4>(lanes, ratio);
}

}  // namespace

void FloorEigenvalueLanes(CovarianceLanes& lanes, double ratio) {
  ChooseSimd(FloorPortable, FloorAvx2, FloorAvx512)(lanes, ratio);
}

}  // namespace fallen
