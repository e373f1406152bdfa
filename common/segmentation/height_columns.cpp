// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/height_columns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fallen {
namespace {

// Two cells of 5 cm: fine enough for a limb, coarse enough that noise leaves no holes.
constexpr float kColumnWidth = 0.1F;
// A room of 12 x 12 m has 14 400 columns. Cells far apart must not take all memory: beyond this
// number the columns get wider.
constexpr double kMaxColumns = 1 << 20;

}  // namespace

HeightColumns::HeightColumns(std::span<const NdtCell> cells, const Plane& ground)
    : width_m_(kColumnWidth) {
  if (cells.empty()) return;
  const Eigen::Vector3d u = ground.normal.unitOrthogonal();
  const Eigen::Vector3d v = ground.normal.cross(u);
  std::vector<Eigen::Array2d> places;
  for (const NdtCell& cell : cells) {
    if (!cell.mean.allFinite()) throw std::invalid_argument("height_columns: a cell is not finite");
    const Eigen::Vector3d mean = cell.mean.cast<double>();
    heights_m_.push_back(static_cast<float>(ground.SignedHeight(mean)));
    places.emplace_back(u.dot(mean), v.dot(mean));
  }
  Eigen::Array2d low = places[0];
  Eigen::Array2d high = places[0];
  for (const Eigen::Array2d& place : places) {
    low = low.min(place);
    high = high.max(place);
  }
  const auto counts = [&] { return ((high - low) / static_cast<double>(width_m_)).floor() + 1; };
  while (counts().prod() > kMaxColumns) width_m_ *= 2;
  size_ = counts().cast<int>();

  columns_.resize(static_cast<std::size_t>(size_.prod()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Array2i at =
        ((places[i] - low) / static_cast<double>(width_m_)).floor().cast<int>().min(size_ - 1);
    column_of_cell_.push_back(at.y() * size_.x() + at.x());
    Column& column = columns_[column_of_cell_.back()];
    const float height = heights_m_[i];
    column.lowest_m = column.count ? std::min(column.lowest_m, height) : height;
    column.highest_m = column.count ? std::max(column.highest_m, height) : height;
    column.sum_m += height;
    ++column.count;
  }
}

ColumnSummary HeightColumns::Summarize(std::size_t i, float radius_m) const {
  const Eigen::Array2i center(column_of_cell_[i] % size_.x(), column_of_cell_[i] / size_.x());
  const float reach = radius_m / width_m_;
  const int rows = static_cast<int>(reach);
  Column all = columns_[column_of_cell_[i]];
  all.sum_m = 0;
  all.count = 0;
  int columns_in_disc = 0;
  int occupied = 0;
  for (int dy = -rows; dy <= rows; ++dy) {
    const int half = static_cast<int>(std::sqrt(reach * reach - static_cast<float>(dy * dy)));
    columns_in_disc += 2 * half + 1;
    const int y = center.y() + dy;
    if (y < 0 || y >= size_.y()) continue;
    const int end = std::min(center.x() + half + 1, size_.x());
    for (int x = std::max(center.x() - half, 0); x < end; ++x) {
      const Column& column = columns_[y * size_.x() + x];
      if (column.count == 0) continue;
      ++occupied;
      all.lowest_m = std::min(all.lowest_m, column.lowest_m);
      all.highest_m = std::max(all.highest_m, column.highest_m);
      all.sum_m += column.sum_m;
      all.count += column.count;
    }
  }
  return {all.lowest_m, all.highest_m, all.sum_m / static_cast<float>(all.count),
          static_cast<float>(occupied) / static_cast<float>(columns_in_disc)};
}

}  // namespace fallen
