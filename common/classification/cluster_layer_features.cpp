// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fallen/classification/cluster_feature_blocks.hpp"

namespace fallen {
namespace {

constexpr int kLayers = 10;
constexpr float kThickness = 0.05F;  // [m]

struct Layer {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  int count = 0;
  Eigen::Array2d least = Eigen::Array2d::Constant(kInfinity);  // along and across [m]
  Eigen::Array2d greatest = Eigen::Array2d::Constant(-kInfinity);
  Eigen::Array2d squares = Eigen::Array2d::Zero();
  double along_sum = 0;
  double cosine_sum = 0;
  double thickness_sum = 0;
};

}  // namespace

void AddLayers(const PlacedCluster& cluster, FeatureRow& row) {
  const ClusterScene& scene = cluster.scene;
  const Eigen::Vector3f up = scene.segmented.ground.plane.normal.cast<float>();
  std::array<Layer, kLayers> layers;
  for (std::size_t k = 0; k < cluster.cells.size(); ++k) {
    const PlacedCell& cell = cluster.cells[k];
    const CellNormal& normal = scene.normals[scene.member_of_cell[cluster.cluster.cells[k]]];
    Layer& layer =
        layers[std::clamp(static_cast<int>(std::floor(cell.height / kThickness)), 0, kLayers - 1)];
    const Eigen::Array2d place(cell.along, cell.across);
    ++layer.count;
    layer.least = layer.least.min(place);
    layer.greatest = layer.greatest.max(place);
    layer.squares += place.square();
    layer.along_sum += cell.along;
    layer.cosine_sum += std::abs(normal.normal.dot(up));
    layer.thickness_sum += std::sqrt(std::max(normal.eigenvalues[0], 0.0F));
  }
  for (const Layer& layer : layers) {
    if (layer.count == 0) {
      row.Add(0, 0, 0, 0, 0, 0, 0, 0);
      continue;
    }
    const double count = layer.count;
    const Eigen::Array2d extent = layer.greatest - layer.least;
    const Eigen::Array2d deviation = (layer.squares / count).sqrt();
    row.Add(count, extent.x(), extent.y(), deviation.x(), deviation.y(),
            std::abs(layer.along_sum / count), layer.cosine_sum / count,
            layer.thickness_sum / count);
  }
}

}  // namespace fallen
