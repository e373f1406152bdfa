// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_features.hpp"

#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace fallen {
namespace {

// Discs of this radius are compared with: the paper's descriptor [m].
constexpr double kPlaneRadius = 0.5;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("cell_segmentation: " + what);
}

void Check(const NdtMap& map, std::span<const CellNormal> normals,
           const IronDescriptors& descriptors, std::span<const std::int32_t> indices) {
  const std::size_t cell_count = map.cells.size();
  if (normals.size() != cell_count || descriptors.neighbor_counts.size() != cell_count ||
      static_cast<std::size_t>(descriptors.values.rows()) < cell_count)
    Fail("got " + std::to_string(cell_count) + " cells, " + std::to_string(normals.size()) +
         " normals and " + std::to_string(descriptors.values.rows()) +
         " descriptors, must be equally many");
  for (const std::int32_t index : indices)
    if (index < 0 || static_cast<std::size_t>(index) >= cell_count)
      Fail("index " + std::to_string(index) + " is not of one of " + std::to_string(cell_count) +
           " cells");
}

}  // namespace

int CellFeatureCount(const IronConfig& iron, CellFeatureSet features) {
  return iron.dimension() +
         (features == CellFeatureSet::kIronAndShape ? 1 + kShapeFeatureCount : 0);
}

void TakeDescriptors(const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                     FeatureMatrix& matrix) {
  GrowRows(matrix, static_cast<Eigen::Index>(indices.size()), descriptors.values.cols());
  for (std::size_t k = 0; k < indices.size(); ++k)
    matrix.row(static_cast<Eigen::Index>(k)) = descriptors.values.row(indices[k]);
}

void JoinCellFeatures(const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                      const FeatureMatrix& shapes, std::span<const std::int32_t> shape_rows,
                      double cell_size_m, FeatureMatrix& matrix) {
  const Eigen::Index dimension = descriptors.values.cols();
  const auto cells_per_radius = static_cast<float>(kPlaneRadius / cell_size_m);
  const float expected_neighbors = std::numbers::pi_v<float> * cells_per_radius * cells_per_radius;
  GrowRows(matrix, static_cast<Eigen::Index>(indices.size()), dimension + 1 + kShapeFeatureCount);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    auto row = matrix.row(static_cast<Eigen::Index>(k));
    row.head(dimension) = descriptors.values.row(indices[k]);
    row[dimension] =
        static_cast<float>(descriptors.neighbor_counts[indices[k]]) / expected_neighbors;
    row.tail<kShapeFeatureCount>() = shapes.row(shape_rows[k]);
  }
}

FeatureMatrix ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                                  const IronDescriptors& descriptors,
                                  std::span<const std::int32_t> indices, CellFeatureSet features) {
  Check(map, normals, descriptors, indices);
  FeatureMatrix matrix;
  if (features == CellFeatureSet::kIron) {
    TakeDescriptors(descriptors, indices, matrix);
  } else {
    ShapeFeatures shapes;
    ComputeShapeFeatures(map, normals, indices, shapes);
    std::vector<std::int32_t> rows(indices.size());
    std::iota(rows.begin(), rows.end(), 0);
    JoinCellFeatures(descriptors, indices, shapes.matrix, rows, map.cell_size_m, matrix);
  }
  return matrix.topRows(static_cast<Eigen::Index>(indices.size()));
}

}  // namespace fallen
