// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/layer_features.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// Share of the points, extents along both axes.
constexpr int kLayerGeometryFeatures = 3;

int LayerColumns(const BaselineConfig& config) {
  return 3 * config.normal_bins + kLayerGeometryFeatures;
}

int Clamped(double value, int count) {
  return std::clamp(static_cast<int>(std::floor(value)), 0, count - 1);
}

/// Where the points are along the cluster's own axes.
struct FloorAxes {
  Eigen::Vector2f center;
  Eigen::Vector2f along;
  Eigen::Vector2f across;
  Eigen::Vector2f deviation;  ///< along, across

  explicit FloorAxes(const std::vector<Eigen::Vector3f>& points) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const Eigen::Vector3f& p : points) sum += p.head<2>().cast<double>();
    const Eigen::Vector2d mean = sum / static_cast<double>(points.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector2d d = p.head<2>().cast<double>() - mean;
      scatter += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter /
                                                                static_cast<double>(points.size()));
    center = mean.cast<float>();
    along = solver.eigenvectors().col(1).cast<float>();
    across = {-along.y(), along.x()};
    deviation = solver.eigenvalues().cwiseMax(0).cwiseSqrt().reverse().cast<float>();
  }

  Eigen::Vector2f Of(const Eigen::Vector2f& horizontal) const {
    return {along.dot(horizontal), across.dot(horizontal)};
  }
};

/// Smallest and largest of what was added.
struct Extent {
  Eigen::Vector2f low = Eigen::Vector2f::Constant(INFINITY);
  Eigen::Vector2f high = Eigen::Vector2f::Constant(-INFINITY);

  void Add(const Eigen::Vector2f& value) {
    low = low.cwiseMin(value);
    high = high.cwiseMax(value);
  }
  Eigen::Vector2f size() const {
    return low.x() > high.x() ? Eigen::Vector2f(0, 0) : Eigen::Vector2f(high - low);
  }
};

// One layer: `columns` are zero and become the layer's.
void DescribeLayer(const SurfaceCloud& cluster, const std::vector<int>& members,
                   const FloorAxes& axes, int bins, Eigen::Ref<Eigen::RowVectorXf> columns) {
  Extent extent;
  int normals = 0;
  for (const int i : members) {
    extent.Add(axes.Of(cluster.points[i].head<2>() - axes.center));
    const Eigen::Vector3f& normal = cluster.normals[i];
    if (normal.isZero()) continue;
    ++normals;
    const Eigen::Vector2f horizontal = axes.Of(normal.head<2>()).cwiseAbs();
    columns[Clamped(horizontal.x() * static_cast<float>(bins), bins)] += 1;
    columns[bins + Clamped(horizontal.y() * static_cast<float>(bins), bins)] += 1;
    columns[2 * bins + Clamped((normal.z() + 1) / 2 * static_cast<float>(bins), bins)] += 1;
  }
  if (normals > 0) columns.head(3 * bins) /= static_cast<float>(normals);
  const auto all = static_cast<float>(cluster.points.size());
  columns.tail<kLayerGeometryFeatures>() << static_cast<float>(members.size()) / all,
      extent.size().x(), extent.size().y();
}

void DescribeWhole(const SurfaceCloud& cluster, const FloorAxes& axes, double camera_height_m,
                   double leaf_m, Eigen::Ref<Eigen::RowVectorXf> columns) {
  Extent extent;
  std::vector<float> heights;
  double sum = 0, sum_of_squares = 0;
  for (const Eigen::Vector3f& p : cluster.points) {
    extent.Add(axes.Of(p.head<2>() - axes.center));
    heights.push_back(p.z());
    sum += p.z();
    sum_of_squares += static_cast<double>(p.z()) * p.z();
  }
  std::sort(heights.begin(), heights.end());
  const auto count = static_cast<double>(heights.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, sum_of_squares / count - mean * mean));
  columns << static_cast<float>(count * leaf_m * leaf_m), extent.size().x(), extent.size().y(),
      heights.back() - heights.front(), heights.front(), static_cast<float>(mean),
      static_cast<float>(deviation), heights[heights.size() / 4], heights[heights.size() * 3 / 4],
      axes.deviation.x(), axes.deviation.y(), axes.center.norm(),
      static_cast<float>(camera_height_m);
}

}  // namespace

int LayerFeatureCount(const BaselineConfig& config) {
  return config.layers * LayerColumns(config) + kClusterGeometryFeatures;
}

Eigen::RowVectorXf ComputeLayerFeatures(const SurfaceCloud& cluster, double camera_height_m,
                                        const BaselineConfig& config) {
  if (cluster.points.empty() || cluster.normals.size() != cluster.points.size())
    throw std::invalid_argument("baseline: got " + std::to_string(cluster.points.size()) +
                                " points and " + std::to_string(cluster.normals.size()) +
                                " normals, must be as many of both and at least one");
  const FloorAxes axes(cluster.points);
  std::vector<std::vector<int>> layers(static_cast<std::size_t>(config.layers));
  for (std::size_t i = 0; i < cluster.points.size(); ++i)
    layers[Clamped(cluster.points[i].z() / config.layer_height_m, config.layers)].push_back(
        static_cast<int>(i));

  Eigen::RowVectorXf features = Eigen::RowVectorXf::Zero(LayerFeatureCount(config));
  const int columns = LayerColumns(config);
  for (int layer = 0; layer < config.layers; ++layer)
    DescribeLayer(cluster, layers[layer], axes, config.normal_bins,
                  features.segment(layer * columns, columns));
  DescribeWhole(cluster, axes, camera_height_m, config.leaf_m,
                features.tail(kClusterGeometryFeatures));
  return features;
}

}  // namespace fallen
