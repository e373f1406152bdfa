// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/pair_binning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fallen {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Where in one class of |q| the column falls, for one sign.
struct ClassColumns {
  int edges = 0;
  int first = 0;  // column at the class's lower end
  float edge = 0;
};

ClassColumns ColumnsOfClass(const PairBinning& binning, int index, bool negative) {
  ClassColumns found;
  for (int k = 0; k < binning.columns - 1; ++k) {
    // |q| < edge for either sign: q >= from is |q| <= -from.
    const float edge =
        negative ? std::nextafter(-binning.column_from[k], kInfinity) : binning.column_below[k];
    const int class_of_edge = std::min(static_cast<int>(edge), 7);
    if (class_of_edge < index) continue;
    ++found.first;
    if (class_of_edge != index) continue;
    ++found.edges;
    found.edge = edge;
  }
  return found;
}

}  // namespace

PairBinning::PairBinning(const IronConfig& config, NormalSigns signs)
    : rows(config.distance_bins),
      columns(config.angle_bins),
      is_folded(signs == NormalSigns::kArbitrary) {
  const auto radius = static_cast<float>(config.radius_m);
  sq_radius = radius * radius;
  for (int k = 1; k < rows; ++k)
    row_from[k - 1] = static_cast<float>(k) * sq_radius / static_cast<float>(rows);
  const double widest = is_folded ? std::numbers::pi / 2 : std::numbers::pi;
  for (int k = 1; k < columns; ++k) {
    // A cosine such as 0.5 that is a whole number of steps must not fall below it by rounding.
    constexpr double kRounding = 1e-9;
    const double edge = std::floor(kCosineSteps * std::cos(k * widest / columns) + kRounding);
    const double below = (edge + 1) / kCosineSteps;  // the step that begins with the edge
    const double from = edge / kCosineSteps;         // of a negative cosine: that ends with it
    constexpr double kSqScale = double{kNormalScale} * double{kNormalScale};
    column_below[k - 1] = static_cast<float>(kSqScale * below * std::abs(below));
    column_from[k - 1] = is_folded ? static_cast<float>(-kSqScale * from * from) : -kInfinity;
  }
}

ColumnTables::ColumnTables(const PairBinning& binning) {
  if (!binning.is_folded) return;
  valid = binning.rows <= kMaxRows && binning.columns <= kMaxColumns;
  for (int index = 0; index < 8; ++index) {
    const ClassColumns positive = ColumnsOfClass(binning, index, false);
    const ClassColumns negative = ColumnsOfClass(binning, index, true);
    least[index] = std::min(positive.first - positive.edges, negative.first - negative.edges);
    const auto edge_of = [&](const ClassColumns& columns) {
      valid = valid && columns.edges <= 1 && columns.first <= least[index] + 1;
      if (columns.edges == 1) return columns.edge;
      return columns.first > least[index] ? kInfinity : 0.0F;
    };
    edge_positive[index] = edge_of(positive);
    edge_negative[index] = edge_of(negative);
  }
  if (!valid) return;
  for (int index = 0; index < 8; ++index) {
    const std::int32_t inner = 1 << (4 * least[index]);
    // In the last column's class there is no column beyond it.
    const std::int32_t outer = least[index] < kMaxColumns - 1 ? inner * 16 : 0;
    signed_edge[index] = edge_positive[index];
    increment_below[index] = outer;
    increment_from[index] = inner;
    // Class k of |q| is class -k - 1 of q; |q| < edge is q > -edge, which is not q < (the next).
    const int mirrored = 15 - index;
    signed_edge[mirrored] = std::nextafter(-edge_negative[index], kInfinity);
    increment_below[mirrored] = inner;
    increment_from[mirrored] = outer;
  }
}

}  // namespace fallen
