// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_features.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fallen/classification/cluster_feature_blocks.hpp"

namespace fallen {
namespace {

constexpr double kMinDistance = 1e-9;

static_assert(2 + kShapeColumns + kSurfaceColumns + kSurroundingsColumns + kWholeColumns +
                  kLayerColumns ==
              kClusterShapeFeatures);

void AddMeanAndDeviation(const Eigen::Ref<const IronDescriptors::Matrix>& descriptors,
                         Eigen::Ref<Eigen::RowVectorXf> values) {
  auto mean = values.head(descriptors.cols());
  mean = descriptors.colwise().mean();
  values.tail(descriptors.cols()) =
      (descriptors.rowwise() - mean).array().square().colwise().mean().sqrt().matrix();
}

}  // namespace

int ClusterFeatureCount(const IronConfig& iron, Eigen::Index code_words) {
  return kClusterShapeFeatures + 2 * iron.dimension() + static_cast<int>(code_words);
}

Eigen::RowVectorXf ComputeClusterFeatures(const ClusterScene& scene, const CellCluster& cluster,
                                          const OrientedBox& box, const WholeCluster& whole,
                                          const Eigen::VectorXd& code,
                                          double mahalanobis_distance) {
  Eigen::RowVectorXf values;
  ComputeClusterFeatures(scene, cluster, box, whole, code, mahalanobis_distance, values);
  return values;
}

void ComputeClusterFeatures(const ClusterScene& scene, const CellCluster& cluster,
                            const OrientedBox& box, const WholeCluster& whole,
                            const Eigen::VectorXd& code, double mahalanobis_distance,
                            Eigen::RowVectorXf& values) {
  if (cluster.cells.empty())
    throw std::invalid_argument("cluster_features: the cluster has no cells");
  const PlacedCluster placed(scene, cluster, box);
  values.resize(ClusterFeatureCount(scene.segmented.iron, code.size()));
  FeatureRow row(values);
  row.Add(std::log(static_cast<double>(cluster.cells.size())),
          std::log(std::max(mahalanobis_distance, kMinDistance)));
  AddShape(placed, row);
  AddSurface(placed, row);
  AddSurroundings(placed, row);
  AddWhole(PlacedCluster(scene, whole.cluster, whole.box), cluster.cells.size(), row);
  AddLayers(placed, row);
  AddMeanAndDeviation(cluster.MemberDescriptors(),
                      values.segment(kClusterShapeFeatures, 2 * scene.segmented.iron.dimension()));
  values.tail(code.size()) = code.transpose().cast<float>();
}

}  // namespace fallen
