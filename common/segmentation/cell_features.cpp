// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_features.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

constexpr int kShapeFeatures = 11;
// Discs of the context features: about a torso's breadth, and the descriptor's radius.
constexpr float kNearRadius = 0.25F;
constexpr float kFarRadius = 0.5F;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("cell_segmentation: " + what);
}

float Ratio(float smaller, float larger) { return larger > 0 ? smaller / larger : 0.0F; }

// Columns of kIronAndShape after the descriptor, in the order that the header documents.
Eigen::Matrix<float, 1, kShapeFeatures> ShapeFeatures(std::size_t i, const CellNormal& cell_normal,
                                                      std::int32_t neighbor_count,
                                                      float expected_neighbors, const Plane& ground,
                                                      const HeightColumns* columns) {
  const Eigen::Vector3f& lambda = cell_normal.eigenvalues;
  Eigen::Matrix<float, 1, kShapeFeatures> values = Eigen::Matrix<float, 1, kShapeFeatures>::Zero();
  values[0] = Ratio(lambda[0], lambda[1]);
  values[1] = Ratio(lambda[1], lambda[2]);
  values[2] = std::sqrt(std::max(lambda[2], 0.0F));
  values[3] = static_cast<float>(neighbor_count) / expected_neighbors;
  if (!columns) return values;  // the floor is not known: heights stay 0
  const ColumnSummary near = columns->Summarize(i, kNearRadius);
  const ColumnSummary far = columns->Summarize(i, kFarRadius);
  const float height = columns->height_m(i);
  values[4] = height;
  values[5] = std::abs(cell_normal.normal.dot(ground.normal.cast<float>()));
  values[6] = near.highest_m - height;
  values[7] = height - near.lowest_m;
  values[8] = far.highest_m;
  values[9] = far.mean_m;
  values[10] = far.occupied_share;
  return values;
}

}  // namespace

int CellFeatureCount(const IronConfig& iron, CellFeatureSet features) {
  return iron.dimension() + (features == CellFeatureSet::kIronAndShape ? kShapeFeatures : 0);
}

void ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                         const IronDescriptors& descriptors, std::span<const std::int32_t> indices,
                         CellFeatureSet features, CellFeatures& result) {
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

  const Eigen::Index dimension = descriptors.values.cols();
  const bool has_shape = features == CellFeatureSet::kIronAndShape;
  FeatureMatrix& matrix = result.matrix;
  GrowRows(matrix, static_cast<Eigen::Index>(indices.size()),
           dimension + (has_shape ? kShapeFeatures : 0));
  for (std::size_t k = 0; k < indices.size(); ++k)
    matrix.row(static_cast<Eigen::Index>(k)).head(dimension) = descriptors.values.row(indices[k]);
  if (!has_shape) return;

  const HeightColumns* const columns = map.ground.ok() ? &result.columns : nullptr;
  if (columns) result.columns.Build(map.cells, map.ground.plane);
  const auto cells_per_radius = static_cast<float>(kFarRadius / map.cell_size_m);
  const float expected_neighbors = std::numbers::pi_v<float> * cells_per_radius * cells_per_radius;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    matrix.row(static_cast<Eigen::Index>(k)).tail(kShapeFeatures) =
        ShapeFeatures(i, normals[i], descriptors.neighbor_counts[i], expected_neighbors,
                      map.ground.plane, columns);
  }
}

FeatureMatrix ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                                  const IronDescriptors& descriptors,
                                  std::span<const std::int32_t> indices, CellFeatureSet features) {
  CellFeatures result;
  ComputeCellFeatures(map, normals, descriptors, indices, features, result);
  return result.matrix.topRows(static_cast<Eigen::Index>(indices.size()));
}

}  // namespace fallen
