// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "fallen/iron/eigen_lanes.hpp"
#include "fallen/iron/iron_descriptor.hpp"

namespace fallen {
namespace {

bool IsFinite(const NdtCell& cell) {
  float zero = 0;  // else NaN: no branch
  for (const float value : cell.mean) zero += 0 * value;
  for (const float value : cell.covariance) zero += 0 * value;
  return zero == 0;
}

CellNormal NormalOf(const EigenBatch& batch, std::size_t lane, const IronConfig& config) {
  CellNormal result;
  if (batch.converged[lane] == 0) return result;
  for (int k = 0; k < 3; ++k) {
    result.eigenvalues[k] = batch.values[k][lane];
    result.normal[k] = batch.smallest[k][lane];
  }
  // Products, not quotients: a covariance that is zero in two directions is a needle, not 0 / 0.
  const double smallest = result.eigenvalues[0];
  const double middle = result.eigenvalues[1];
  const double largest = result.eigenvalues[2];
  const bool ball = smallest > config.max_ball_ratio * middle;
  const bool needle = middle < config.min_needle_ratio * largest;
  result.usable = largest > 0 && !ball && !needle;
  return result;
}

void RequireOneEach(std::size_t normals, std::size_t cells) {
  if (normals == cells) return;
  throw std::invalid_argument("iron: got room for " + std::to_string(normals) +
                              " normals, expected one a cell, " + std::to_string(cells));
}

}  // namespace

// The solver, its single precision and with them the sign that it happens to give the normal are
// the reference implementation's: descriptors depend on that sign where a cosine lies within 1/2500
// of a bin edge (see PairBinning), and so agree with the reference in every count. Closed forms are
// no faster than this many lanes, and their signs cost 40 % of the descriptors a count.
void ComputeNormals(std::span<const NdtCell> cells, const IronConfig& config,
                    std::span<CellNormal> normals) {
  config.Validate();
  RequireOneEach(normals.size(), cells.size());
  MatrixBatch batch;
  EigenBatch solved;
  std::array<bool, kMostLanes> finite;
  for (std::size_t begin = 0; begin < cells.size(); begin += kMostLanes) {
    const std::size_t count = std::min<std::size_t>(kMostLanes, cells.size() - begin);
    if (count < kMostLanes) batch = {};
    for (std::size_t lane = 0; lane < count; ++lane) {
      const NdtCell& cell = cells[begin + lane];
      finite[lane] = IsFinite(cell);
      for (std::size_t k = 0; k < 6; ++k)
        batch.coefficients[k][lane] = finite[lane] ? cell.covariance[k] : 0.0F;
    }
    DecomposeLikeEigen(batch, solved);
    for (std::size_t lane = 0; lane < count; ++lane)
      normals[begin + lane] = finite[lane] ? NormalOf(solved, lane, config) : CellNormal{};
  }
}

void ComputeNormals(std::span<const NdtCell> cells, const IronConfig& config,
                    std::vector<CellNormal>& normals) {
  normals.resize(cells.size());
  ComputeNormals(cells, config, std::span(normals));
}

std::vector<CellNormal> ComputeNormals(std::span<const NdtCell> cells, const IronConfig& config) {
  std::vector<CellNormal> normals;
  ComputeNormals(cells, config, normals);
  return normals;
}

void OrientNormals(std::span<const NdtCell> cells, const Eigen::Vector3f& eye,
                   std::span<CellNormal> normals) {
  RequireOneEach(normals.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (normals[i].normal.dot(eye - cells[i].mean) < 0) normals[i].normal *= -1;
}

}  // namespace fallen
