// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>

#include "fallen/ndt/ndt_cell.hpp"
#include "fallen/ndt/voxel_statistics.hpp"
#include "fallen/segmentation/background_subtraction.hpp"

namespace fallen {

/// How points become the cells of an environment map.
struct EnvironmentBuilderConfig {
  double cell_size_m = 0.05;
  int min_points = 4;                  ///< fewer in a voxel: no cell
  double min_eigenvalue_ratio = 1e-3;  ///< as in NdtConfig

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
};

/// Gathers points and cells of any number of sources into one map of the world, without bounds.
class EnvironmentBuilder {
 public:
  /// @throws std::invalid_argument if `config` is out of range.
  explicit EnvironmentBuilder(const EnvironmentBuilderConfig& config);

  /// Adds a point of a surface, world frame [m]. One that is not finite, or farther from the origin
  /// than a grid of cells can reach, is left out.
  void AddPoint(const Eigen::Vector3d& p_world);

  /// Adds cells, world frame, of a map of any cell size up to this one's.
  void AddCells(std::span<const NdtCell> cells);

  /// The map of what was added; the order of the cells depends on their places only.
  EnvironmentMap Build() const;

 private:
  using VoxelIndex = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
  struct Voxel {
    Moments moments;
    double occupancy = 0;  ///< log-odds; the highest of what was merged
  };
  bool IsInReach(const Eigen::Vector3d& p_world) const;
  void Add(const Eigen::Vector3d& mean, double count, const SymmetricMatrix3& scatter,
           double occupancy);

  EnvironmentBuilderConfig config_;
  std::map<VoxelIndex, Voxel> voxels_;
};

}  // namespace fallen
