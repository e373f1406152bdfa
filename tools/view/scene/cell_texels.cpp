// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/scene/cell_texels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fallen {
namespace {

constexpr double kMaxStep = std::numeric_limits<std::int16_t>::max();
constexpr std::int16_t kNoScore = std::numeric_limits<std::int16_t>::min();
constexpr std::int16_t kKnownBackground = -2;

using Root = std::array<double, 6>;

/// Cholesky's lower triangular root by rows. What rounding made negative counts as flat.
Root LowerRoot(const NdtCell& cell) {
  const auto [xx, xy, xz, yy, yz, zz] = cell.covariance;
  const auto share = [](double value, double by) { return by > 0 ? value / by : 0; };
  Root root{};
  root[0] = std::sqrt(std::max<double>(xx, 0));
  root[1] = share(xy, root[0]);
  root[2] = std::sqrt(std::max(yy - root[1] * root[1], 0.0));
  root[3] = share(xz, root[0]);
  root[4] = share(yz - root[3] * root[1], root[2]);
  root[5] = std::sqrt(std::max(zz - root[3] * root[3] - root[4] * root[4], 0.0));
  return root;
}

std::int16_t Steps(double value, double step) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value / step, -kMaxStep, kMaxStep)));
}

std::int16_t ClusterNumber(const CellMark& mark) {
  return mark.is_foreground ? Steps(mark.cluster, 1) : kKnownBackground;
}

std::int16_t ScoreNumber(const CellMark& mark) {
  return mark.score ? Steps(*mark.score, 1 / kMaxStep) : kNoScore;
}

/// Where the cells lie, and the steps that hold them all.
CellTexels MeasureCells(std::span<const NdtCell> cells, std::span<const Root> roots) {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  constexpr double kSmallest = 1e-6;  // [m]: one cell alone has no extent
  double largest_root = kSmallest;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    low = low.min(cells[i].mean.array().cast<double>());
    high = high.max(cells[i].mean.array().cast<double>());
    for (const double value : roots[i]) largest_root = std::max(largest_root, std::abs(value));
  }
  CellTexels measured;
  measured.origin = (low + high) / 2;
  measured.place_step_m = std::max((high - low).maxCoeff() / 2, kSmallest) / kMaxStep;
  measured.root_step_m = largest_root / kMaxStep;
  return measured;
}

}  // namespace

CellTexels ToCellTexels(std::span<const NdtCell> cells, std::span<const CellMark> marks) {
  if (cells.empty()) return {};
  std::vector<Root> roots(cells.size());
  std::transform(cells.begin(), cells.end(), roots.begin(), LowerRoot);
  CellTexels result = MeasureCells(cells, roots);
  result.texels.reserve(CellTexels::kNumbersPerCell * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellMark mark = marks.empty() ? CellMark{} : marks[i];
    const Eigen::Vector3d offset = cells[i].mean.cast<double>() - result.origin;
    const auto place = [&](int axis) { return Steps(offset[axis], result.place_step_m); };
    const auto root = [&](std::size_t k) { return Steps(roots[i][k], result.root_step_m); };
    result.texels.insert(result.texels.end(),
                         {place(0), place(1), place(2), ClusterNumber(mark),  //
                          root(0), root(1), root(2), ScoreNumber(mark),       //
                          root(3), root(4), root(5), Steps(mark.age_s, 0.1)});
  }
  return result;
}

}  // namespace fallen
