// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/cell_tiles.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fallen/iron/cells_near_box.hpp"

namespace fallen {
namespace {

// Tuned on rooms at 5 cm cells and 0.5 m: small buckets fit the sphere, few are visited in vain.
constexpr float kBucketsPerRadius = 2;
constexpr float kStepsPerRadius = 11;
// A tile that grew larger would have few neighbours in common.
constexpr float kMaxExtentPerRadius = 1;

constexpr int kBitsPerAxis = 10;
constexpr int kDigitBits = 10;  // of the radix sort

// Spreads ten bits so that two zeros follow each.
std::uint32_t Spread(std::uint32_t bits) {
  bits = (bits | (bits << 16)) & 0x030000FFu;
  bits = (bits | (bits << 8)) & 0x0300F00Fu;
  bits = (bits | (bits << 4)) & 0x030C30C3u;
  bits = (bits | (bits << 2)) & 0x09249249u;
  return bits;
}

// Place on Morton's space-filling curve: near each other on it is near each other in space.
std::uint32_t CurveKey(const Eigen::Array3f& steps) {
  constexpr float kLast = (1 << kBitsPerAxis) - 1;
  const Eigen::Array3i index = steps.max(0.0F).min(kLast).cast<int>();
  return Spread(static_cast<std::uint32_t>(index.x())) |
         Spread(static_cast<std::uint32_t>(index.y())) << 1 |
         Spread(static_cast<std::uint32_t>(index.z())) << 2;
}

}  // namespace

void CellTiles::Build(std::span<const Eigen::Vector3f> points,
                      std::span<const std::uint8_t> is_base, float radius_m) {
  grid_.Build(points, radius_m / kBucketsPerRadius);
  for (auto* column : {&x_, &y_, &z_}) column->resize(points.size() + kMostLanes);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3f& point = grid_.sorted_points()[k];
    x_[k] = point.x();
    y_[k] = point.y();
    z_[k] = point.z();
  }
  SortBases(is_base, radius_m / kStepsPerRadius);
  CutTiles(radius_m * kMaxExtentPerRadius);
}

void CellTiles::SortBases(std::span<const std::uint8_t> is_base, float step_m) {
  const std::span<const Eigen::Vector3f> points = grid_.sorted_points();
  bases_.clear();
  Eigen::Array3f low = Eigen::Array3f::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == 0) low = points[0].array();
    low = low.min(points[k].array());
    if (is_base[grid_.sorted_index()[k]] != 0) bases_.push_back(static_cast<std::int32_t>(k));
  }
  keys_.clear();
  for (const std::int32_t base : bases_)
    keys_.push_back(CurveKey((points[base].array() - low) / step_m));

  sorted_bases_.resize(bases_.size());
  sorted_keys_.resize(bases_.size());
  for (int shift = 0; shift < 3 * kBitsPerAxis; shift += kDigitBits) {
    std::array<std::int32_t, (1 << kDigitBits) + 1> begin{};
    const auto digit = [&](std::uint32_t key) { return (key >> shift) & ((1u << kDigitBits) - 1); };
    for (const std::uint32_t key : keys_) ++begin[digit(key) + 1];
    for (std::size_t d = 1; d < begin.size(); ++d) begin[d] += begin[d - 1];
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      const std::int32_t to = begin[digit(keys_[i])]++;
      sorted_bases_[to] = bases_[i];
      sorted_keys_[to] = keys_[i];
    }
    std::swap(bases_, sorted_bases_);
    std::swap(keys_, sorted_keys_);
  }
}

void CellTiles::CutTiles(float max_extent_m) {
  tiles_.clear();
  for (std::size_t i = 0; i < bases_.size(); ++i) {
    const Eigen::Array3f point = grid_.sorted_points()[bases_[i]].array();
    const auto at = static_cast<std::int32_t>(i);
    if (!tiles_.empty() && at - tiles_.back().begin < kMostLanes) {
      CellTile& tile = tiles_.back();
      const Eigen::Array3f low = tile.low.min(point), high = tile.high.max(point);
      if ((high - low).maxCoeff() <= max_extent_m) {
        tile = {tile.begin, at + 1, low, high};
        continue;
      }
    }
    tiles_.push_back({at, at + 1, point, point});
  }
}

std::span<const std::int32_t> CellTiles::FindNear(const CellTile& tile, float radius_m) {
  runs_.clear();
  grid_.ForEachRunNearBox(tile.low, tile.high, radius_m, [&](std::int32_t begin, std::int32_t end) {
    runs_.push_back({begin, end});
  });
  near_.resize(grid_.size() + kMostLanes);
  const BoxSurroundings box = {{tile.low.x(), tile.low.y(), tile.low.z()},
                               {tile.high.x(), tile.high.y(), tile.high.z()},
                               radius_m * radius_m};
  const int count = FindNearBox({x_.data(), y_.data(), z_.data()}, runs_.data(),
                                static_cast<int>(runs_.size()), box, near_.data());
  return std::span(near_).first(count);
}

}  // namespace fallen
