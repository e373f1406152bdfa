// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "fallen/classification/cluster_feature_blocks.hpp"
#include "fallen/geometry/kept_vector.hpp"

namespace fallen {
namespace {

constexpr int kCosineBins = 4;
constexpr float kLayers[] = {0.12F, 0.3F};  // [m]
constexpr int kLayerCount = 3;
constexpr float kMinSlope = 0.3F;  // sine of a normal to the vertical from which it has a direction

int CosineBin(float cosine) {
  return std::min(static_cast<int>(cosine * kCosineBins), kCosineBins - 1);
}

float Ratio(float smaller, float larger) { return larger > 0 ? smaller / larger : 0.0F; }

}  // namespace

void AddSurface(const PlacedCluster& cluster, FeatureRow& row) {
  const ClusterScene& scene = cluster.scene;
  const Eigen::Vector3f up = scene.segmented.ground.plane.normal.cast<float>();
  const Eigen::Vector2f main_axis = cluster.frame.x_axis().cast<float>();
  const auto count = static_cast<double>(cluster.cells.size());
  std::array<double, kLayerCount * kCosineBins> inclinations{};
  std::array<double, kCosineBins> directions{};
  KeptVector<float> thicknesses;
  double cosine_sum = 0, flatness_sum = 0, breadth_sum = 0, points_sum = 0, occupancy_sum = 0;
  int level = 0;
  for (const std::int32_t i : cluster.cluster.cells) {
    const std::int32_t member = scene.member_of_cell[i];
    const CellNormal& normal = scene.normals[member];
    const NdtCell& cell = scene.segmented.members[member];
    const float cosine = std::abs(normal.normal.dot(up));
    const float height = scene.heights_m[i];
    const int layer = height < kLayers[0] ? 0 : height < kLayers[1] ? 1 : 2;
    inclinations[layer * kCosineBins + CosineBin(cosine)] += 1 / count;
    const Eigen::Vector2f aside = normal.normal.head<2>();
    if (aside.norm() > kMinSlope)
      directions[CosineBin(std::abs(aside.dot(main_axis)) / aside.norm())] += 1 / count;
    cosine_sum += cosine;
    level += cosine > 0.9F;
    const Eigen::Vector3f& lambda = normal.eigenvalues;
    flatness_sum += Ratio(lambda[0], lambda[1]);
    breadth_sum += Ratio(lambda[1], lambda[2]);
    thicknesses.push_back(std::sqrt(std::max(lambda[0], 0.0F)));
    points_sum += std::log(std::max(static_cast<double>(cell.point_count), 1.0));
    occupancy_sum += cell.occupancy;
  }
  std::sort(thicknesses.begin(), thicknesses.end());
  row.AddAll(inclinations);
  row.AddAll(directions);
  row.Add(cosine_sum / count, level / count, flatness_sum / count, breadth_sum / count);
  row.Add(thicknesses[thicknesses.size() / 4], thicknesses[thicknesses.size() / 2],
          thicknesses[thicknesses.size() * 3 / 4], points_sum / count, occupancy_sum / count);
}

}  // namespace fallen
