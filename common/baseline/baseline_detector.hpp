// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fallen/baseline/baseline_model.hpp"
#include "fallen/baseline/surface_cloud.hpp"
#include "fallen/classification/cluster_classification.hpp"
#include "fallen/detection/frame.hpp"
#include "fallen/geometry/ground_plane.hpp"

namespace fallen {

/// Finds the candidates of one image: ground removal, thinning, normals, Euclidean clusters
/// [Volkhardt13].
/// @param ground_camera  Floor in the camera frame, normal up.
/// @throws std::invalid_argument if image or config is out of range.
/// Deterministic. Thread-safe.
std::vector<SurfaceCloud> FindSurfaceClusters(const DepthImage& image, const Plane& ground_camera,
                                              const BaselineConfig& config);

/// Candidates of a frame, described, and where they are.
struct DescribedClusters {
  MapFrame frame = MapFrame::kCamera;  ///< kCamera: no floor was found, and nothing is described
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  FeatureMatrix features;                  ///< ComputeLayerFeatures, one row a cluster
  std::vector<Eigen::Vector3d> centroids;  ///< mean of the points, map frame [m]
  std::vector<OrientedBox> boxes;          ///< smallest upright ones around the points, map frame
  std::vector<std::int32_t> point_counts;
};

/// Everything of the baseline but the classifier. The map frame is the detector's: world where the
/// robot's pose and the mounting are known, else level.
/// @throws std::invalid_argument if frame or config is out of range.
DescribedClusters DescribeClusters(const Frame& frame, const GroundConfig& ground,
                                   const BaselineConfig& config);

/// Probability and acceptance of each cluster, best first, those beside a better one left out: as
/// ClassifyClusters does for the detector.
/// @throws std::invalid_argument if the features are not the model's, or `config` is out of range.
Decision JudgeClusters(const DescribedClusters& clusters, const BaselineModel& model,
                       const ClassificationConfig& config);

/// The comparison detector: a depth image goes in, fallen persons come out. Each frame stands
/// alone. Deterministic. Thread-safe.
class BaselineDetector {
 public:
  /// @throws std::invalid_argument if a part is out of range.
  BaselineDetector(BaselineModel model, const GroundConfig& ground,
                   const ClassificationConfig& classification);

  /// @throws std::invalid_argument if the image or a transform is malformed.
  Decision Detect(const Frame& frame) const;

 private:
  BaselineModel model_;
  GroundConfig ground_;
  ClassificationConfig classification_;
};

}  // namespace fallen
