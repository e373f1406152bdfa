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
    for (auto& coordinate : coordinates_) coordinate.resize(selected_.size() + kPairPadding);
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

// Counts of one cell's neighbours, in both histograms at once: one count a neighbour.
class PairHistogram {
 public:
  explicit PairHistogram(const PairBinning& binning)
      : rows_(binning.rows),
        columns_(binning.columns),
        bins_(JointBins(binning)),
        stride_(bins_ + 1),  // one more, for pairs beyond the radius
        counts_(static_cast<std::size_t>(kLanes) * stride_) {}

  void Clear() { std::fill(counts_.begin(), counts_.end(), 0u); }

  void Count(const std::uint32_t* codes, int count) {
    std::uint32_t* const lane0 = counts_.data();
    std::uint32_t* const lane1 = lane0 + stride_;
    std::uint32_t* const lane2 = lane1 + stride_;
    std::uint32_t* const lane3 = lane2 + stride_;
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) {
      ++lane0[codes[i]];
      ++lane1[codes[i + 1]];
      ++lane2[codes[i + 2]];
      ++lane3[codes[i + 3]];
    }
    for (; i < count; ++i) ++lane0[codes[i]];
  }

  void Remove(std::uint32_t code) { --counts_[code]; }  // modulo 2^32 until the lanes are summed

  /// Writes both histograms, each non-empty row with the same share of 1.
  /// @param values  2 * rows * columns zeros.
  /// @return The number of neighbours, or 0 (and nothing is written) if there are too few.
  std::int32_t Normalize(int min_neighbors, float* values) {
    SumLanes(counts_.data(), kLanes, stride_, bins_);
    std::array<std::uint32_t, kMaxBins> in_row{};
    const int bins_in_row = columns_ * columns_;
    for (int row = 0; row < rows_; ++row)
      for (int k = 0; k < bins_in_row; ++k) in_row[row] += counts_[row * bins_in_row + k];
    std::uint32_t neighbors = 0;
    std::uint32_t nonempty_rows = 0;
    for (int row = 0; row < rows_; ++row) {
      neighbors += in_row[row];
      nonempty_rows += in_row[row] > 0 ? 1 : 0;
    }
    if (neighbors < static_cast<std::uint32_t>(min_neighbors)) return 0;
    for (int row = 0; row < rows_; ++row)
      if (in_row[row] > 0)
        WriteRow(row, 1.0f / static_cast<float>(in_row[row] * nonempty_rows), values);
    return static_cast<std::int32_t>(neighbors);
  }

 private:
  // As many copies of the counts, in turn: neighbours on one wall fall into one bin, and each count
  // would wait for the one before.
  static constexpr int kLanes = 4;
  static constexpr int kMaxBins = 32;

  void WriteRow(int row, float share, float* values) const {
    const std::uint32_t* counts =
        counts_.data() + static_cast<std::ptrdiff_t>(row) * columns_ * columns_;
    float* const of_normals = values + row * columns_;
    float* const of_lines = values + (rows_ + row) * columns_;
    std::array<std::uint32_t, kMaxBins> lines{};
    for (int column1 = 0; column1 < columns_; ++column1) {
      std::uint32_t normals = 0;
      for (int column2 = 0; column2 < columns_; ++column2) {
        const std::uint32_t count = counts[column1 * columns_ + column2];
        normals += count;
        lines[column2] += count;
      }
      of_normals[column1] = static_cast<float>(normals) * share;
    }
    for (int column2 = 0; column2 < columns_; ++column2)
      of_lines[column2] = static_cast<float>(lines[column2]) * share;
  }

  int rows_, columns_, bins_, stride_;
  std::vector<std::uint32_t> counts_;
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
  PairHistogram histogram(binning);
  const auto usable_count = static_cast<std::int32_t>(usable.grid().size());
  std::vector<CellRun> runs;
  std::vector<std::uint32_t> codes(usable_count + kPairPadding);
  for (std::int32_t base = 0; base < usable_count; ++base) {
    const std::int32_t cell = usable.cell_index(base);
    if (!wanted.empty() && wanted[cell] == 0) continue;
    runs.clear();
    usable.grid().ForEachRun(cells[cell].mean, radius, [&](std::int32_t begin, std::int32_t end) {
      runs.push_back({begin, end});
    });
    histogram.Clear();
    histogram.Count(codes.data(), ComputePairCodes(arrays, base, runs, binning, codes.data()));
    const CellRun itself = {base, base + 1};
    ComputePairCodes(arrays, base, {&itself, 1}, binning, codes.data());
    histogram.Remove(codes[0]);  // nobody is its own neighbour
    result.neighbor_counts[cell] =
        histogram.Normalize(config.min_neighbors, result.values.row(cell).data());
  }
  return result;
}

}  // namespace fallen
