// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/iron_descriptor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "fallen/iron/neighbor_grid.hpp"
#include "fallen/iron/pair_codes.hpp"

namespace fallen {
namespace {

// Grid buckets of half the radius: few buckets to visit, few points visited in vain.
constexpr double kBucketsPerRadius = 2;
// Pairs whose bins are computed at a time: the codes stay in the first-level cache.
constexpr int kChunk = 512;
// Neighbours on one wall fall into one bin, and each count would wait for the one before: as many
// copies of the histograms, in turn.
constexpr int kLanes = 4;

// The usable cells, in grid order and coordinate by coordinate.
class UsableCells {
 public:
  UsableCells(std::span<const NdtCell> cells, std::span<const CellNormal> normals,
              const IronConfig& config)
      : UsableCells(Select(cells, normals), cells, normals, config) {}

  const NeighborGrid& grid() const { return grid_; }
  CellArrays arrays() const {
    return {coordinates_[0].data(), coordinates_[1].data(), coordinates_[2].data(),
            coordinates_[3].data(), coordinates_[4].data(), coordinates_[5].data()};
  }
  /// Index in `cells` of the cell at grid position `position`.
  std::int32_t cell_index(std::int32_t position) const {
    return selected_[grid_.sorted_index()[position]];
  }

 private:
  static std::vector<std::int32_t> Select(std::span<const NdtCell> cells,
                                          std::span<const CellNormal> normals) {
    std::vector<std::int32_t> selected;
    selected.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (normals[i].usable) selected.push_back(static_cast<std::int32_t>(i));
    return selected;
  }
  static std::vector<Eigen::Vector3f> Means(std::span<const NdtCell> cells,
                                            const std::vector<std::int32_t>& selected) {
    std::vector<Eigen::Vector3f> means(selected.size());
    for (std::size_t k = 0; k < selected.size(); ++k) means[k] = cells[selected[k]].mean;
    return means;
  }
  UsableCells(std::vector<std::int32_t> selected, std::span<const NdtCell> cells,
              std::span<const CellNormal> normals, const IronConfig& config)
      : selected_(std::move(selected)),
        grid_(Means(cells, selected_), static_cast<float>(config.radius_m / kBucketsPerRadius)) {
    for (auto& coordinate : coordinates_) coordinate.resize(selected_.size());
    for (std::size_t k = 0; k < selected_.size(); ++k) {
      const std::int32_t i = cell_index(static_cast<std::int32_t>(k));
      for (int axis = 0; axis < 3; ++axis) {
        coordinates_[axis][k] = cells[i].mean[axis];
        coordinates_[3 + axis][k] = normals[i].normal[axis];
      }
    }
  }

  std::vector<std::int32_t> selected_;
  NeighborGrid grid_;
  std::array<std::vector<float>, 6> coordinates_;
};

// Cosines of the inner edges between the angle bins, 0 to 90 degrees, in whole steps.
std::vector<int> CosineEdges(int columns) {
  // A cosine such as 0.5 that is a whole number of steps must not fall below it by rounding.
  constexpr double kRounding = 1e-9;
  std::vector<int> edges(columns - 1);
  for (int k = 1; k < columns; ++k)
    edges[k - 1] =
        static_cast<int>(kCosineSteps * std::cos(k * std::numbers::pi / (2 * columns)) + kRounding);
  return edges;
}

// Counts of both histograms of one cell.
class PairHistograms {
 public:
  explicit PairHistograms(const IronConfig& config)
      : rows_(config.distance_bins), columns_(config.angle_bins), bins_(rows_ * columns_ + 1) {
    for (auto& lane : lanes_) lane.resize(2 * bins_);
  }

  void Clear() {
    for (auto& lane : lanes_) std::fill(lane.begin(), lane.end(), 0);
  }

  void Count(const std::uint32_t* codes, int count) {
    int i = 0;
    for (; i + kLanes <= count; i += kLanes)
      for (int lane = 0; lane < kLanes; ++lane) CountOne(lanes_[lane].data(), codes[i + lane], 1);
    for (; i < count; ++i) CountOne(lanes_[0].data(), codes[i], 1);
  }

  void Remove(std::uint32_t code) { CountOne(lanes_[0].data(), code, -1); }

  /// Writes both histograms, each non-empty row with the same share of 1.
  /// @return The number of neighbours, or 0 (and nothing is written) if there are too few.
  std::int32_t Normalize(int min_neighbors, float* values) {
    std::vector<std::int32_t>& total = lanes_[0];
    for (int lane = 1; lane < kLanes; ++lane)
      for (std::size_t k = 0; k < total.size(); ++k) total[k] += lanes_[lane][k];

    std::int32_t neighbors = 0;
    int nonempty_rows = 0;
    for (int row = 0; row < rows_; ++row) {
      const std::int32_t in_row = RowCount(row);
      neighbors += in_row;
      nonempty_rows += in_row > 0 ? 1 : 0;
    }
    if (neighbors < min_neighbors) return 0;
    for (int row = 0; row < rows_; ++row) {
      const std::int32_t in_row = RowCount(row);
      if (in_row == 0) continue;
      const float share = 1.0f / static_cast<float>(in_row * nonempty_rows);
      for (int k = row * columns_; k < (row + 1) * columns_; ++k) {
        values[k] = static_cast<float>(total[k]) * share;
        values[rows_ * columns_ + k] = static_cast<float>(total[bins_ + k]) * share;
      }
    }
    return neighbors;
  }

 private:
  void CountOne(std::int32_t* lane, std::uint32_t code, std::int32_t amount) const {
    lane[code & 0xffff] += amount;
    lane[bins_ + (code >> 16)] += amount;
  }
  std::int32_t RowCount(int row) const {
    std::int32_t sum = 0;
    for (int k = row * columns_; k < (row + 1) * columns_; ++k) sum += lanes_[0][k];
    return sum;
  }

  int rows_, columns_;
  int bins_;  // of one histogram, with one more for pairs beyond the radius
  std::array<std::vector<std::int32_t>, kLanes> lanes_;
};

void RequireSize(const char* what, std::size_t got, std::size_t expected) {
  if (got == expected) return;
  throw std::invalid_argument("iron: " + std::string(what) + " has " + std::to_string(got) +
                              " entries, expected one a cell, " + std::to_string(expected));
}

}  // namespace

IronDescriptors ComputeIronDescriptors(std::span<const NdtCell> cells,
                                       std::span<const CellNormal> normals,
                                       std::span<const std::uint8_t> wanted,
                                       const IronConfig& config) {
  config.Validate();
  RequireSize("normals", normals.size(), cells.size());
  if (!wanted.empty()) RequireSize("wanted", wanted.size(), cells.size());

  IronDescriptors result;
  result.values =
      IronDescriptors::Matrix::Zero(static_cast<Eigen::Index>(cells.size()), config.dimension());
  result.neighbor_counts.assign(cells.size(), 0);
  const UsableCells usable(cells, normals, config);
  const CellArrays arrays = usable.arrays();

  const auto radius = static_cast<float>(config.radius_m);
  const std::vector<int> cosine_edges = CosineEdges(config.angle_bins);
  const PairBinning binning = {radius * radius,
                               static_cast<float>(config.distance_bins) / (radius * radius),
                               config.distance_bins, config.angle_bins, cosine_edges.data()};
  PairHistograms histograms(config);
  std::array<std::uint32_t, kChunk> codes;

  const auto usable_count = static_cast<std::int32_t>(usable.grid().size());
  for (std::int32_t base = 0; base < usable_count; ++base) {
    const std::int32_t cell = usable.cell_index(base);
    if (!wanted.empty() && wanted[cell] == 0) continue;
    histograms.Clear();
    const auto count_run = [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t from = begin; from < end; from += kChunk) {
        const std::int32_t to = std::min(end, from + kChunk);
        ComputePairCodes(arrays, base, from, to, binning, codes.data());
        histograms.Count(codes.data(), to - from);
      }
    };
    usable.grid().ForEachRun(cells[cell].mean, radius, count_run);
    ComputePairCodes(arrays, base, base, base + 1, binning, codes.data());
    histograms.Remove(codes[0]);  // nobody is its own neighbour
    result.neighbor_counts[cell] =
        histograms.Normalize(config.min_neighbors, result.values.row(cell).data());
  }
  return result;
}

}  // namespace fallen
