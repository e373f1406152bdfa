// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "plain_iron.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <flann/flann.hpp>
#include <numbers>
#include <vector>

namespace fallen {
namespace {

struct UsableCell {
  Eigen::Index index;
  Eigen::Vector3f mean;
  Eigen::Vector3f normal;
};

std::vector<UsableCell> FindUsable(std::span<const NdtCell> cells, const IronConfig& config) {
  std::vector<UsableCell> usable;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver(cells[i].CovarianceMatrix());
    const Eigen::Vector3d lambda = solver.eigenvalues().cast<double>();
    const bool ball = lambda[0] > config.max_ball_ratio * lambda[1];
    const bool needle = lambda[1] < config.min_needle_ratio * lambda[2];
    if (!ball && !needle)
      usable.push_back({static_cast<Eigen::Index>(i), cells[i].mean, solver.eigenvectors().col(0)});
  }
  return usable;
}

int ColumnOf(float cosine, int columns) {
  const float angle = std::acos(std::min(std::abs(cosine), 1.0F));
  const auto column =
      static_cast<int>(angle * static_cast<float>(2 * columns) / std::numbers::pi_v<float>);
  return std::min(column, columns - 1);
}

// Divides each row of both histograms by its neighbours and by the number of rows that have any.
void Normalize(const std::vector<int>& in_row, const IronConfig& config, float* values) {
  const auto nonempty =
      static_cast<float>(std::count_if(in_row.begin(), in_row.end(), [](int n) { return n > 0; }));
  const int columns = config.angle_bins, rows = config.distance_bins;
  for (int k = 0; k < config.dimension(); ++k) {
    const int count = in_row[(k / columns) % rows];
    if (count > 0) values[k] /= static_cast<float>(count) * nonempty;
  }
}

}  // namespace

IronDescriptors DescribePlainly(std::span<const NdtCell> cells, const IronConfig& config) {
  IronDescriptors result;
  result.values =
      IronDescriptors::Matrix::Zero(static_cast<Eigen::Index>(cells.size()), config.dimension());
  result.neighbor_counts.assign(cells.size(), 0);
  const std::vector<UsableCell> usable = FindUsable(cells, config);
  if (usable.empty()) return result;
  std::vector<float> coordinates;
  for (const UsableCell& cell : usable)
    coordinates.insert(coordinates.end(), cell.mean.begin(), cell.mean.end());
  flann::KDTreeSingleIndex<flann::L2_Simple<float>> tree(
      flann::Matrix<float>(coordinates.data(), usable.size(), 3));
  tree.buildIndex();

  const auto sq_radius = static_cast<float>(config.radius_m * config.radius_m);
  const int rows = config.distance_bins, columns = config.angle_bins;
  flann::SearchParams parameters;
  parameters.max_neighbors = -1;
  parameters.sorted = false;
  std::vector<std::vector<std::size_t>> indices;
  std::vector<std::vector<float>> sq_distances;
  for (std::size_t i = 0; i < usable.size(); ++i) {
    const UsableCell& base = usable[i];
    tree.radiusSearch(flann::Matrix<float>(&coordinates[3 * i], 1, 3), indices, sq_distances,
                      sq_radius, parameters);
    float* const values = result.values.row(base.index).data();
    std::vector<int> in_row(rows, 0);
    for (std::size_t n = 0; n < indices[0].size(); ++n) {
      if (indices[0][n] == i) continue;
      const UsableCell& other = usable[indices[0][n]];
      const float share = sq_distances[0][n] / sq_radius;
      const int row = std::min(rows - 1, static_cast<int>(share * static_cast<float>(rows)));
      const Eigen::Vector3f line = (other.mean - base.mean).normalized();
      ++values[row * columns + ColumnOf(base.normal.dot(other.normal), columns)];
      ++values[(rows + row) * columns + ColumnOf(base.normal.dot(line), columns)];
      ++in_row[row];
    }
    const auto neighbors = static_cast<int>(indices[0].size()) - 1;
    if (neighbors < config.min_neighbors) {
      result.values.row(base.index).setZero();
      continue;
    }
    result.neighbor_counts[base.index] = neighbors;
    Normalize(in_row, config, values);
  }
  return result;
}

}  // namespace fallen
