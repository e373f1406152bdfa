// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/shape_features.hpp"

#include <algorithm>
#include <cmath>

namespace fallen {
namespace {

// Discs of the context features: about a torso's breadth, and the descriptor's radius.
constexpr float kNearRadius = 0.25F;
constexpr float kFarRadius = 0.5F;

using Row = Eigen::Matrix<float, 1, kShapeFeatureCount>;

float Ratio(float smaller, float larger) { return larger > 0 ? smaller / larger : 0.0F; }

// Columns in the order that the header documents.
Row RowOf(std::size_t i, const CellNormal& cell_normal, const Plane& ground,
          const HeightColumns* columns) {
  const Eigen::Vector3f& lambda = cell_normal.eigenvalues;
  Row values = Row::Zero();
  values[0] = Ratio(lambda[0], lambda[1]);
  values[1] = Ratio(lambda[1], lambda[2]);
  values[2] = std::sqrt(std::max(lambda[2], 0.0F));
  if (!columns) return values;  // the floor is not known: heights stay 0
  const ColumnSummary near = columns->Summarize(i, kNearRadius);
  const ColumnSummary far = columns->Summarize(i, kFarRadius);
  const float height = columns->height_m(i);
  values[3] = height;
  values[4] = std::abs(cell_normal.normal.dot(ground.normal.cast<float>()));
  values[5] = near.highest_m - height;
  values[6] = height - near.lowest_m;
  values[7] = far.highest_m;
  values[8] = far.mean_m;
  values[9] = far.occupied_share;
  return values;
}

}  // namespace

void ComputeShapeFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                          std::span<const std::int32_t> indices, ShapeFeatures& result) {
  GrowRows(result.matrix, static_cast<Eigen::Index>(indices.size()), kShapeFeatureCount);
  const HeightColumns* const columns = map.ground.ok() ? &result.columns : nullptr;
  if (columns) result.columns.Build(map.cells, map.ground.plane);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    result.matrix.row(static_cast<Eigen::Index>(k)) =
        RowOf(i, normals[i], map.ground.plane, columns);
  }
}

}  // namespace fallen
