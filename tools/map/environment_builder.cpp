// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/environment_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

/// Log-odds of a voxel in which a surveyed cloud has points: as sure as the mapper gets by default.
constexpr double kSurveyedLogOdds = 4.0;
/// Cells from the origin that the grid reaches; at 5 cm that is 50 km, and floats still tell
/// positions apart by 4 mm there.
constexpr double kMaxIndex = 1e6;

void Require(bool holds, const char* name, double value, const char* expected) {
  if (!holds)
    throw std::invalid_argument(std::string("environment map: ") + name + " is " +
                                std::to_string(value) + ", must be " + expected);
}

Eigen::Vector3d Index(const Eigen::Vector3d& p_world, double cell_size_m) {
  return (p_world / cell_size_m).array().floor();
}

}  // namespace

void EnvironmentBuilderConfig::Validate() const {
  Require(cell_size_m >= 0.01 && cell_size_m <= 1, "cell_size_m", cell_size_m, "in [0.01, 1]");
  Require(min_points >= 1, "min_points", min_points, ">= 1");
  Require(min_eigenvalue_ratio >= kLeastEigenvalueRatio && min_eigenvalue_ratio <= 1,
          "min_eigenvalue_ratio", min_eigenvalue_ratio, "in [1e-6, 1]");
}

EnvironmentBuilder::EnvironmentBuilder(const EnvironmentBuilderConfig& config) : config_(config) {
  config_.Validate();
}

bool EnvironmentBuilder::IsInReach(const Eigen::Vector3d& p_world) const {
  return p_world.allFinite() && p_world.cwiseAbs().maxCoeff() < kMaxIndex * config_.cell_size_m;
}

void EnvironmentBuilder::Add(const Eigen::Vector3d& mean, double count,
                             const SymmetricMatrix3& scatter, double occupancy) {
  const Eigen::Vector3d index = Index(mean, config_.cell_size_m);
  const Eigen::Vector3d offset =
      mean - (index + Eigen::Vector3d::Constant(0.5)) * config_.cell_size_m;
  Voxel& voxel =
      voxels_[{static_cast<std::int32_t>(index.x()), static_cast<std::int32_t>(index.y()),
               static_cast<std::int32_t>(index.z())}];
  Moments added;
  added.count = count;
  added.mean = {offset.x(), offset.y(), offset.z()};
  added.scatter = scatter;
  voxel.occupancy = voxel.moments.count > 0 ? std::max(voxel.occupancy, occupancy) : occupancy;
  voxel.moments = voxel.moments.count > 0 ? Merge(voxel.moments, added) : added;
}

void EnvironmentBuilder::AddPoint(const Eigen::Vector3d& p_world) {
  if (IsInReach(p_world)) Add(p_world, 1, SymmetricMatrix3{}, kSurveyedLogOdds);
}

void EnvironmentBuilder::AddCells(std::span<const NdtCell> cells) {
  for (const NdtCell& cell : cells) {
    const Eigen::Vector3d mean = cell.mean.cast<double>();
    if (!IsInReach(mean)) continue;
    SymmetricMatrix3 scatter{};
    for (std::size_t k = 0; k < scatter.size(); ++k)
      scatter[k] = static_cast<double>(cell.covariance[k]) * (cell.point_count - 1.0);
    Add(mean, cell.point_count, scatter, cell.occupancy);
  }
}

EnvironmentMap EnvironmentBuilder::Build() const {
  EnvironmentMap map;
  map.cell_size_m = config_.cell_size_m;
  for (const auto& [index, voxel] : voxels_) {
    if (voxel.moments.count < config_.min_points) continue;
    const auto [x, y, z] = index;
    const Eigen::Vector3d center =
        (Eigen::Vector3d(x, y, z) + Eigen::Vector3d::Constant(0.5)) * config_.cell_size_m;
    NdtCell cell;
    cell.mean = (center + Eigen::Vector3d(voxel.moments.mean.data())).cast<float>();
    const SymmetricMatrix3 covariance =
        FloorEigenvalues(voxel.moments.Covariance(), config_.min_eigenvalue_ratio);
    for (std::size_t k = 0; k < covariance.size(); ++k)
      cell.covariance[k] = static_cast<float>(covariance[k]);
    constexpr double kMaxCount = std::numeric_limits<std::uint32_t>::max();
    cell.point_count = static_cast<std::uint32_t>(std::min(voxel.moments.count, kMaxCount));
    cell.occupancy = static_cast<float>(voxel.occupancy);
    map.cells.push_back(cell);
  }
  return map;
}

}  // namespace fallen
