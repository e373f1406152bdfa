// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/height_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fallen {
namespace {

// Two cells of 5 cm: fine enough for a limb, coarse enough that noise leaves no holes.
constexpr float kColumnWidth = 0.1F;
// A room of 12 x 12 m has 14 400 columns. Cells far apart must not take all memory: beyond this
// number the columns get wider.
constexpr double kMaxColumns = 1 << 20;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

void HeightColumns::Build(std::span<const NdtCell> cells, const Plane& ground) {
  width_m_ = kColumnWidth;
  heights_m_.resize(cells.size());
  column_of_cell_.resize(cells.size());
  places_.resize(cells.size());
  for (Disc& disc : discs_) disc.is_summarized.clear();
  columns_.clear();
  if (cells.empty()) return;
  const Eigen::Vector3d u = ground.normal.unitOrthogonal();
  const Eigen::Vector3d v = ground.normal.cross(u);
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].mean.allFinite())
      throw std::invalid_argument("height_columns: a cell is not finite");
    const Eigen::Vector3d mean = cells[i].mean.cast<double>();
    heights_m_[i] = static_cast<float>(ground.SignedHeight(mean));
    places_[i] = {u.dot(mean), v.dot(mean)};
    low = low.min(places_[i]);
    high = high.max(places_[i]);
  }
  const auto counts = [&] { return ((high - low) / static_cast<double>(width_m_)).floor() + 1; };
  while (counts().prod() > kMaxColumns) width_m_ *= 2;
  size_ = counts().cast<int>();

  columns_.assign(static_cast<std::size_t>(size_.prod()), Column{kInfinity, -kInfinity, 0, 0});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Array2d steps = (places_[i] - low) / static_cast<double>(width_m_);
    const Eigen::Array2i at = steps.cast<int>().min(size_ - 1);  // not negative: rounds down
    column_of_cell_[i] = at.y() * size_.x() + at.x();
    Column& column = columns_[column_of_cell_[i]];
    const float height = heights_m_[i];
    column.lowest_m = std::min(column.lowest_m, height);
    column.highest_m = std::max(column.highest_m, height);
    column.sum_m += height;
    ++column.count;
  }
}

HeightColumns::Disc& HeightColumns::DiscOf(float radius_m) const {
  auto disc = std::find_if(discs_.begin(), discs_.end(),
                           [&](const Disc& known) { return known.radius_m == radius_m; });
  if (disc == discs_.end()) disc = discs_.insert(discs_.end(), {radius_m, {}, {}, {}});
  if (!disc->is_summarized.empty()) return *disc;
  disc->is_summarized.assign(columns_.size(), 0);
  disc->summaries.resize(columns_.size());
  const float reach = radius_m / width_m_;
  disc->half_widths.clear();
  for (int dy = 0; dy <= static_cast<int>(reach); ++dy)
    disc->half_widths.push_back(
        static_cast<int>(std::sqrt(reach * reach - static_cast<float>(dy * dy))));
  return *disc;
}

const ColumnSummary& HeightColumns::Summarize(std::size_t i, float radius_m) const {
  Disc& disc = DiscOf(radius_m);
  const std::int32_t column = column_of_cell_[i];
  if (disc.is_summarized[column] == 0) {
    disc.summaries[column] = SummarizeColumn(column, disc);
    disc.is_summarized[column] = 1;
  }
  return disc.summaries[column];
}

ColumnSummary HeightColumns::SummarizeColumn(std::int32_t column, const Disc& disc) const {
  const Eigen::Array2i center(column % size_.x(), column / size_.x());
  const int rows = static_cast<int>(disc.half_widths.size()) - 1;
  Column all = {kInfinity, -kInfinity, 0, 0};
  int columns_in_disc = 0;
  int occupied = 0;
  for (int dy = -rows; dy <= rows; ++dy) {
    const int half = disc.half_widths[std::abs(dy)];
    columns_in_disc += 2 * half + 1;
    const int y = center.y() + dy;
    if (y < 0 || y >= size_.y()) continue;
    const Column* const row = columns_.data() + y * size_.x();
    const Column* const end = row + std::min(center.x() + half + 1, size_.x());
    for (const Column* c = row + std::max(center.x() - half, 0); c != end; ++c) {
      occupied += c->count > 0 ? 1 : 0;
      all.lowest_m = std::min(all.lowest_m, c->lowest_m);
      all.highest_m = std::max(all.highest_m, c->highest_m);
      all.sum_m += c->sum_m;
      all.count += c->count;
    }
  }
  return {all.lowest_m, all.highest_m, all.sum_m / static_cast<float>(all.count),
          static_cast<float>(occupied) / static_cast<float>(columns_in_disc)};
}

}  // namespace fallen
