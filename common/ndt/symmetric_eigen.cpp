// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fallen {
namespace {

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector Multiply(const SymmetricMatrix3& m, const Vector& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

// cos(acos(h) / 3) for h in [0, 1]: the root of 4 c^3 - 3 c = h in [cos 30 deg, 1]. The chord is at
// most 0.007 off; Newton's error there is squared and multiplied by 1.5, so that three steps
// suffice.
double CosOfThirdAngle(double h) {
  constexpr double kCos30 = 0.86602540378443865;
  double c = kCos30 + (1 - kCos30) * h;
  for (int step = 0; step < 3; ++step) c -= ((4 * c * c - 3) * c - h) / (12 * c * c - 3);
  return c;
}

// Unit vector that `m - value I` maps to zero: across its two rows that are least parallel.
Vector EigenvectorOfIsolated(const SymmetricMatrix3& m, double value) {
  const Vector row0 = {m[0] - value, m[1], m[2]};
  const Vector row1 = {m[1], m[3] - value, m[4]};
  const Vector row2 = {m[2], m[4], m[5] - value};
  Vector best = Cross(row0, row1);
  double sq_best = Dot(best, best);
  for (const Vector& candidate : {Cross(row0, row2), Cross(row1, row2)}) {
    const double sq_norm = Dot(candidate, candidate);
    if (sq_norm <= sq_best) continue;
    best = candidate;
    sq_best = sq_norm;
  }
  const double scale = 1 / std::sqrt(sq_best);
  return {best[0] * scale, best[1] * scale, best[2] * scale};
}

Vector UnitAcross(const Vector& w) {
  if (std::abs(w[0]) > std::abs(w[1])) {
    const double scale = 1 / std::sqrt(w[0] * w[0] + w[2] * w[2]);
    return {-w[2] * scale, 0, w[0] * scale};
  }
  const double scale = 1 / std::sqrt(w[1] * w[1] + w[2] * w[2]);
  return {0, w[2] * scale, -w[1] * scale};
}

struct Plane2 {
  double low, high;  // eigenvalues
  Vector low_axis, high_axis;
};

// Eigenvalues and -vectors within the plane across `w`.
Plane2 DecomposeAcross(const SymmetricMatrix3& m, const Vector& w) {
  const Vector u = UnitAcross(w);
  const Vector v = Cross(w, u);
  const Vector mu = Multiply(m, u);
  const Vector mv = Multiply(m, v);
  const double uv = Dot(v, mu);
  const double mean = (Dot(u, mu) + Dot(v, mv)) / 2;
  const double half_difference = (Dot(u, mu) - Dot(v, mv)) / 2;
  const double root = std::sqrt(half_difference * half_difference + uv * uv);
  // Eigenvector of the larger value, by the row of the matrix that does not cancel.
  double cu = half_difference >= 0 ? half_difference + root : uv;
  double cv = half_difference >= 0 ? uv : root - half_difference;
  const double norm = std::sqrt(cu * cu + cv * cv);
  cu = norm > 0 ? cu / norm : 1;
  cv = norm > 0 ? cv / norm : 0;
  const Vector high_axis = {cu * u[0] + cv * v[0], cu * u[1] + cv * v[1], cu * u[2] + cv * v[2]};
  return {mean - root, mean + root, Cross(high_axis, w), high_axis};
}

void SwapIfFalling(SymmetricEigen3& eigen, int i, int j) {
  if (eigen.values[i] <= eigen.values[j]) return;
  std::swap(eigen.values[i], eigen.values[j]);
  std::swap(eigen.vectors[i], eigen.vectors[j]);
}

void Sort(SymmetricEigen3& eigen) {
  SwapIfFalling(eigen, 0, 1);
  SwapIfFalling(eigen, 1, 2);
  SwapIfFalling(eigen, 0, 1);
}

}  // namespace

SymmetricEigen3 DecomposeSymmetric(const SymmetricMatrix3& matrix) {
  SymmetricEigen3 result;
  double scale = 0;
  for (const double value : matrix) scale = std::max(scale, std::abs(value));
  SymmetricMatrix3 m = matrix;
  if (scale > 0)
    for (double& value : m) value /= scale;

  // Without its mean and its spread, what is left of the matrix has eigenvalues 2 cos(angle).
  const double mean = (m[0] + m[3] + m[5]) / 3;
  for (const int k : {0, 3, 5}) m[k] -= mean;
  const double sq_off_diagonal = m[1] * m[1] + m[2] * m[2] + m[4] * m[4];
  const double spread =
      std::sqrt((m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2 * sq_off_diagonal) / 6);
  if (sq_off_diagonal == 0 || spread == 0) {
    result.values = {matrix[0], matrix[3], matrix[5]};
    Sort(result);
    return result;
  }
  for (double& value : m) value /= spread;
  const double determinant = m[0] * (m[3] * m[5] - m[4] * m[4]) -
                             m[1] * (m[1] * m[5] - m[4] * m[2]) +
                             m[2] * (m[1] * m[4] - m[3] * m[2]);
  const double cosine = std::clamp(determinant / 2, -1.0, 1.0);

  // The largest eigenvalue stands apart if the determinant is positive, the smallest otherwise.
  const bool largest_apart = cosine >= 0;
  const double apart = (largest_apart ? 2 : -2) * CosOfThirdAngle(std::abs(cosine));
  const Vector axis = EigenvectorOfIsolated(m, apart);
  const Plane2 rest = DecomposeAcross(m, axis);
  if (largest_apart) {
    result.values = {rest.low, rest.high, apart};
    result.vectors = {rest.low_axis, rest.high_axis, axis};
  } else {
    result.values = {apart, rest.low, rest.high};
    result.vectors = {axis, rest.low_axis, rest.high_axis};
  }
  for (double& value : result.values) value = (mean + spread * value) * scale;
  Sort(result);  // rounding may have turned equal values round
  return result;
}

}  // namespace fallen
