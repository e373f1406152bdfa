// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/baseline_detector.hpp"

#include <utility>

#include "fallen/baseline/ground_free_points.hpp"
#include "fallen/baseline/layer_features.hpp"
#include "fallen/baseline/point_cloud_steps.hpp"
#include "fallen/classification/hypothesis_selection.hpp"

namespace fallen {

std::vector<SurfaceCloud> FindSurfaceClusters(const DepthImage& image, const Plane& ground_camera,
                                              const BaselineConfig& config) {
  config.Validate();
  const std::vector<Eigen::Vector3f> points =
      ThinPoints(GroundFreePoints(image, ground_camera, config), config.leaf_m);
  const Eigen::Vector3f camera(0, 0, static_cast<float>(ground_camera.offset));
  const std::vector<Eigen::Vector3f> normals =
      EstimateNormals(points, camera, config.normal_radius_m);
  std::vector<SurfaceCloud> clusters;
  for (const std::vector<std::int32_t>& members :
       EuclideanClusters(points, config.cluster_tolerance_m, config.min_cluster_points)) {
    SurfaceCloud& cluster = clusters.emplace_back();
    for (const std::int32_t i : members) {
      cluster.points.push_back(points[i]);
      cluster.normals.push_back(normals[i]);
    }
  }
  return clusters;
}

DescribedClusters DescribeClusters(const Frame& frame, const GroundConfig& ground_config,
                                   const BaselineConfig& config) {
  DescribedClusters described;
  described.features.resize(0, LayerFeatureCount(config));
  const GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera, ground_config);
  if (!ground.ok()) return described;
  const Eigen::Isometry3d T_level_camera = LevelFrameFromGround(ground.plane);
  const bool has_pose = frame.T_world_robot && frame.T_robot_camera;
  described.frame = has_pose ? MapFrame::kWorld : MapFrame::kLevel;
  described.T_map_camera = has_pose ? *frame.T_world_robot * *frame.T_robot_camera : T_level_camera;
  const Eigen::Isometry3d T_map_level = described.T_map_camera * T_level_camera.inverse();

  const std::vector<SurfaceCloud> clusters = FindSurfaceClusters(frame.image, ground.plane, config);
  described.features.resize(static_cast<Eigen::Index>(clusters.size()), Eigen::NoChange);
  for (const SurfaceCloud& cluster : clusters) {
    described.features.row(static_cast<Eigen::Index>(described.centroids.size())) =
        ComputeLayerFeatures(cluster, ground.plane.offset, config);
    std::vector<Eigen::Vector3d> points_map;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& p : cluster.points) {
      points_map.push_back(T_map_level * p.cast<double>());
      sum += points_map.back();
    }
    described.centroids.push_back(sum / static_cast<double>(points_map.size()));
    described.boxes.push_back(FitUprightBox(points_map, config.leaf_m / 2));
    described.point_counts.push_back(static_cast<std::int32_t>(points_map.size()));
  }
  return described;
}

Decision JudgeClusters(const DescribedClusters& clusters, const BaselineModel& model,
                       const ClassificationConfig& config) {
  config.Validate();
  Decision decision;
  decision.frame = clusters.frame;
  decision.T_map_camera = clusters.T_map_camera;
  decision.min_probability = model.calibration.MinProbability(config.false_positives_per_frame);
  const std::vector<float> scores = PredictScores(model.trees, clusters.features);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    PersonHypothesis& hypothesis = decision.hypotheses.emplace_back();
    hypothesis.centroid = clusters.centroids[i];
    hypothesis.box = clusters.boxes[i];
    hypothesis.cell_count = clusters.point_counts[i];
    hypothesis.mean_score = scores[i];
    hypothesis.probability = model.calibration.Probability(scores[i]);
    hypothesis.is_person = hypothesis.probability >= decision.min_probability;
  }
  KeepBestOfEachPlace(decision.hypotheses, config.min_separation_m);
  return decision;
}

BaselineDetector::BaselineDetector(BaselineModel model, const GroundConfig& ground,
                                   const ClassificationConfig& classification)
    : model_(std::move(model)), ground_(ground), classification_(classification) {
  model_.Validate();
  ground_.Validate();
  classification_.Validate();
}

Decision BaselineDetector::Detect(const Frame& frame) const {
  return JudgeClusters(DescribeClusters(frame, ground_, model_.config), model_, classification_);
}

}  // namespace fallen
