// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/iron/iron_describer.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr int kMaxRows = PairBinning::kMaxEdges + 1;

void RequireSize(const char* what, std::size_t got, std::size_t expected) {
  if (got == expected) return;
  throw std::invalid_argument("iron: " + std::string(what) + " has " + std::to_string(got) +
                              " entries, expected one a cell, " + std::to_string(expected));
}

const IronConfig& Validated(const IronConfig& config) {
  config.Validate();
  return config;
}

// Gives room for the cells' descriptors, none of them valid. Rows are zero but for those that the
// last call filled.
void ClearDescriptors(Eigen::Index cells, int dimension, IronDescriptors& descriptors) {
  const Eigen::Index had_rows = descriptors.values.rows();
  GrowRows(descriptors.values, cells, dimension);
  if (descriptors.values.rows() != had_rows) {
    descriptors.values.setZero();
  } else {
    for (std::size_t i = 0; i < descriptors.neighbor_counts.size(); ++i)
      if (descriptors.valid(i)) descriptors.values.row(static_cast<Eigen::Index>(i)).setZero();
  }
  descriptors.neighbor_counts.assign(static_cast<std::size_t>(cells), 0);
}

// A base was counted as its own neighbour: the line of length zero is at 90 degrees.
void RemoveItself(const PairBinning& binning, std::uint32_t* counts) {
  std::uint32_t* const between = counts + PairCountIndex(0, 0, 0, binning.columns);
  std::uint32_t* const along = counts + PairCountIndex(0, 1, binning.ColumnOf(0), binning.columns);
  for (int lane = 0; lane < kMostLanes; ++lane) {
    between[lane] -= 1;
    along[lane] -= 1;
  }
}

// Turns counts into shares: each non-empty row has the same share of 1, in each histogram.
// @return Neighbours of each lane; 0 where there are too few, whose shares mean nothing.
std::array<std::int32_t, kMostLanes> Normalize(const PairBinning& binning, int min_neighbors,
                                               const std::uint32_t* counts, float* shares) {
  using Lane = std::array<std::uint32_t, kMostLanes>;
  std::array<Lane, kMaxRows> in_row{};
  Lane neighbors{}, nonempty{};
  for (int row = 0; row < binning.rows; ++row) {
    for (int column = 0; column < binning.columns; ++column) {
      const std::uint32_t* from = counts + PairCountIndex(row, 0, column, binning.columns);
      for (int lane = 0; lane < kMostLanes; ++lane) in_row[row][lane] += from[lane];
    }
    for (int lane = 0; lane < kMostLanes; ++lane) {
      neighbors[lane] += in_row[row][lane];
      nonempty[lane] += in_row[row][lane] > 0 ? 1 : 0;
    }
  }
  for (int row = 0; row < binning.rows; ++row) {
    std::array<float, kMostLanes> share;
    for (int lane = 0; lane < kMostLanes; ++lane) {
      const auto parts = static_cast<std::int32_t>(in_row[row][lane] * nonempty[lane]);
      share[lane] = 1.0F / static_cast<float>(std::max(parts, 1));
    }
    for (int h = 0; h < 2; ++h)
      for (int column = 0; column < binning.columns; ++column) {
        const std::uint32_t* from = counts + PairCountIndex(row, h, column, binning.columns);
        const int value = (h * binning.rows + row) * binning.columns + column;
        float* const to = shares + static_cast<std::ptrdiff_t>(value) * kMostLanes;
        for (int lane = 0; lane < kMostLanes; ++lane)
          to[lane] = static_cast<float>(static_cast<std::int32_t>(from[lane])) * share[lane];
      }
  }
  std::array<std::int32_t, kMostLanes> result;
  for (int lane = 0; lane < kMostLanes; ++lane) {
    const auto count = static_cast<std::int32_t>(neighbors[lane]);
    result[lane] = count >= min_neighbors ? count : 0;
  }
  return result;
}

}  // namespace

IronDescriber::IronDescriber(const IronConfig& config, NormalSigns signs)
    : config_(Validated(config)), binning_(config, signs), tables_(binning_) {
  counts_.resize(static_cast<std::size_t>(config.dimension()) * kMostLanes);
  shares_.resize(counts_.size());
}

void IronDescriber::SelectUsable(std::span<const NdtCell> cells,
                                 std::span<const CellNormal> normals,
                                 std::span<const std::uint8_t> wanted) {
  selected_.clear();
  means_.clear();
  is_base_.clear();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!normals[i].usable) continue;
    selected_.push_back(static_cast<std::int32_t>(i));
    means_.push_back(cells[i].mean);
    is_base_.push_back(wanted.empty() ? 1 : wanted[i]);
  }
  tiles_.Build(means_, is_base_, static_cast<float>(config_.radius_m));
  pair_cells_.resize(selected_.size());
  for (std::size_t k = 0; k < selected_.size(); ++k) {
    const auto i = static_cast<std::size_t>(cell_index(static_cast<std::int32_t>(k)));
    const Eigen::Vector3f& mean = cells[i].mean;
    const Eigen::Vector3f& normal = normals[i].normal;
    pair_cells_[k] = {mean.x(), mean.y(), mean.z(), normal.x(), normal.y(), normal.z()};
  }
}

void IronDescriber::DescribeTile(const CellTile& tile) {
  const std::span<const std::int32_t> near =
      tiles_.FindNear(tile, static_cast<float>(config_.radius_m));
  const std::span<const std::int32_t> bases = tiles_.bases_of(tile);
  BaseLanes lanes;
  lanes.normal_x = lanes.normal_y = lanes.normal_z = {};
  lanes.x.fill(kNowhere);
  lanes.y.fill(kNowhere);
  lanes.z.fill(kNowhere);
  for (std::size_t lane = 0; lane < bases.size(); ++lane) {
    const PairCell& cell = pair_cells_[bases[lane]];
    lanes.x[lane] = cell.x;
    lanes.y[lane] = cell.y;
    lanes.z[lane] = cell.z;
    lanes.normal_x[lane] = PairBinning::kNormalScale * cell.normal_x;
    lanes.normal_y[lane] = PairBinning::kNormalScale * cell.normal_y;
    lanes.normal_z[lane] = PairBinning::kNormalScale * cell.normal_z;
  }
  std::fill(counts_.begin(), counts_.end(), 0u);
  CountPairs(lanes, pair_cells_.data(), near.data(), static_cast<int>(near.size()), binning_,
             tables_, counts_.data());
  RemoveItself(binning_, counts_.data());
  const auto neighbors = Normalize(binning_, config_.min_neighbors, counts_.data(), shares_.data());
  const int dimension = config_.dimension();
  for (std::size_t lane = 0; lane < bases.size(); ++lane) {
    if (neighbors[lane] == 0) continue;
    const std::int32_t cell = cell_index(bases[lane]);
    descriptors_.neighbor_counts[cell] = neighbors[lane];
    float* const values = descriptors_.values.row(cell).data();
    for (int k = 0; k < dimension; ++k) values[k] = shares_[k * kMostLanes + lane];
  }
}

const IronDescriptors& IronDescriber::Describe(std::span<const NdtCell> cells,
                                               std::span<const CellNormal> normals,
                                               std::span<const std::uint8_t> wanted) {
  RequireSize("normals", normals.size(), cells.size());
  if (!wanted.empty()) RequireSize("wanted", wanted.size(), cells.size());
  ClearDescriptors(static_cast<Eigen::Index>(cells.size()), config_.dimension(), descriptors_);
  SelectUsable(cells, normals, wanted);
  for (const CellTile& tile : tiles_.tiles()) DescribeTile(tile);
  return descriptors_;
}

IronDescriptors ComputeIronDescriptors(std::span<const NdtCell> cells,
                                       std::span<const CellNormal> normals,
                                       std::span<const std::uint8_t> wanted,
                                       const IronConfig& config, NormalSigns signs) {
  IronDescriptors descriptors = IronDescriber(config, signs).Describe(cells, normals, wanted);
  descriptors.values.conservativeResize(static_cast<Eigen::Index>(cells.size()), Eigen::NoChange);
  return descriptors;
}

}  // namespace fallen
