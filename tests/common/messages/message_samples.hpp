// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/messages/baseline_files.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/service_status_t.hpp"

/// Values and messages in which every field says something, for tests.
namespace fallen::samples {

inline Header SampleHeader() { return {1'700'000'000'123'456, 42, "FRONT"}; }

inline OrientedBox SampleBox() { return {{1, 2, 0.2}, {1.7, 0.5, 0.3}, 0.7}; }

inline Eigen::Isometry3d SampleTransform() {
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) *
                        Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()))
                           .toRotationMatrix();
  transform.translation() << 10.1, -20.2, 0.95;
  return transform;
}

inline std::vector<NdtCell> SampleCells(int count) {
  std::vector<NdtCell> cells;
  for (int i = 0; i < count; ++i) {
    const float f = static_cast<float>(i);
    NdtCell cell;
    cell.mean = {10 + 0.05f * f, -20 - 0.07f * f, 0.01f * f};
    cell.covariance = {1e-4f + 1e-6f * f, 1e-5f, -2e-5f, 2e-4f, 3e-5f, 1.5e-4f};
    cell.point_count = 4 + i;
    cell.occupancy = 0.4f * f - 1;
    cells.push_back(cell);
  }
  return cells;
}

inline GroundEstimate SampleGround() {
  GroundEstimate ground;
  ground.status = GroundStatus::kOk;
  ground.method = GroundMethod::kVDisparity;
  ground.plane = {Eigen::Vector3d(0.1, -0.2, 1).normalized(), 0.123456789};
  ground.inlier_count = 1234;
  ground.point_count = 4000;
  return ground;
}

inline CameraView SampleView() {
  return {{3, 2, 2.5, 2.25, 1, 0.5}, {0, 1, 250, 3000, 32767, 1234}};
}

inline NdtMap SampleMap() {
  return {0.05, MapFrame::kWorld, SampleTransform(), SampleView(), SampleGround(), SampleCells(7)};
}

inline ForegroundMap SampleForeground() {
  return {SampleMap(), {1, 0, 1, 1, 0, 0, 1}, BackgroundStatus::kSubtracted};
}

/// Two clusters whose cells interleave, and cells in none.
inline SegmentedMap SampleSegmented() {
  SegmentedMap segmented;
  segmented.cell_size_m = 0.05;
  segmented.frame = MapFrame::kLevel;
  segmented.T_map_camera = SampleTransform();
  segmented.view = SampleView();
  segmented.ground = SampleGround();
  segmented.background = BackgroundStatus::kNoPose;
  segmented.iron.distance_bins = 2;
  segmented.iron.angle_bins = 3;
  const std::int32_t clusters[] = {-1, 1, 0, 1, -1, 0, 0};
  segmented.clusters.resize(2);
  const auto cells = SampleCells(7);
  for (int i = 0; i < 7; ++i) {
    segmented.cells.push_back({cells[i].mean, 0.25f * static_cast<float>(i) - 0.9f, clusters[i]});
    if (clusters[i] < 0) continue;
    segmented.members.push_back(cells[i]);
    segmented.clusters[clusters[i]].cells.push_back(i);
  }
  for (auto& cluster : segmented.clusters) {
    cluster.descriptors.resize(static_cast<Eigen::Index>(cluster.cells.size()), 12);
    for (Eigen::Index row = 0; row < cluster.descriptors.rows(); ++row)
      for (Eigen::Index column = 0; column < 12; ++column)
        cluster.descriptors(row, column) =
            0.01f * static_cast<float>(cluster.cells[row]) + 0.001f * static_cast<float>(column);
  }
  return segmented;
}

inline Decision SampleDecision() {
  Decision decision;
  decision.frame = MapFrame::kWorld;
  decision.T_map_camera = SampleTransform();
  decision.view = SampleView();
  decision.min_probability = 0.625;
  decision.hypotheses.push_back({{1, 2, 0.3}, SampleBox(), 0.875, 3.25, 120, 0.5, true});
  decision.hypotheses.push_back({{-1, 2.5, 0.1}, SampleBox(), 0.125, 33.5, 17, -0.25, false});
  return decision;
}

inline NumberedAlarm SampleAlarm() {
  FallAlarm alarm;
  alarm.id = "robot-20231114T221320Z-7";
  alarm.revision = 3;
  alarm.change = AlarmChange::kAcknowledged;
  alarm.change_utime = 1'700'000'009'000'000;
  alarm.camera = "FRONT";
  alarm.first_utime = 1'700'000'000'000'000;
  alarm.raised_utime = 1'700'000'001'000'000;
  alarm.acknowledged_utime = 1'700'000'009'000'000;
  alarm.acknowledged_by = "night shift";
  alarm.cleared_utime = 1'700'000'019'000'000;
  alarm.cleared_by = "day shift";
  alarm.frame = MapFrame::kLevel;
  alarm.position = {1, 2, 0.25};
  alarm.box = SampleBox();
  alarm.probability = 0.998;
  alarm.best_probability = 0.97;
  alarm.views = 4;
  alarm.frames = 55;
  return {"robot", 12, alarm};
}

inline AlarmAnswer SampleAnswer() {
  return {1'700'000'009'000'000, "robot-20231114T221320Z-7", "night shift", true};
}

inline GroundTruth SampleTruth() {
  GroundTruth truth;
  truth.person_box = SampleBox();
  truth.person = "body-3";
  truth.room = "room-1";
  truth.objects.push_back({"furniture", "sofa", 3, {{0, 0, 0.4}, {2, 1, 0.8}, -1}});
  truth.objects.push_back({"fallen_person", "body-3", 7, *truth.person_box});
  truth.label_width = 4;
  truth.label_height = 3;
  truth.labels = {0, 0, 3, 3, 0, 7, 7, 3, 0, 7, 7, 0};
  return truth;
}

inline StampedDepthImage SampleDepthImage() {
  StampedDepthImage value;
  value.header = SampleHeader();
  value.image.intrinsics = {8, 6, 525.5, 526.25, 3.5, 2.5};
  value.image.depth_unit_m = 1e-4;
  for (int i = 0; i < 48; ++i) value.image.depth.push_back(static_cast<std::uint16_t>(i * 1000));
  value.T_robot_camera = SampleTransform();
  return value;
}

inline pose_t SamplePose() {
  return ToMessage(StampedPose{1'700'000'000'000'001, {1.1, -2.2, 3.3}, {0.5, -0.5, 0.5, 0.5}});
}

inline service_status_t SampleStatus() {
  service_status_t status{};
  status.header = ToMessage(SampleHeader());
  status.service = "ndt-mapping";
  status.version = "0.1.0";
  status.pid = 4711;
  status.state = service_status_t::RUNNING;
  status.text = "all is well";
  status.received = 10;
  status.rate_hz = 29.5;
  return status;
}

/// A model with two code words, one tree and one layer; only the wire is to like it.
inline model_t SampleModelMessage() {
  model_t model{};
  model.description = "sample";
  model.cell_size_m = 0.05;
  model.iron.radius_m = 0.5;
  model.iron.distance_bins = 1;
  model.iron.angle_bins = 2;
  model.cell_trees.feature_count = 4;
  model.cell_trees.tree_count = 1;
  model.cell_trees.root = {0};
  model.cell_trees.node_count = 3;
  model.cell_trees.node_feature = {2, -1, -1};
  model.cell_trees.node_threshold = {0.5f, 0, 0};
  model.cell_trees.node_left = {1, 0, 0};
  model.cell_trees.node_value = {0, -1, 1};
  model.cluster_trees = model.cell_trees;
  model.gate_trees = model.cell_trees;
  model.gate_min_score = -0.25;
  model.gate_turned_away_score = -0.5;
  model.cluster_network.feature_count = 2;
  model.cluster_network.mean = {0.5f, 1};
  model.cluster_network.scale = {1, 2};
  model.cluster_network.layer_count = 1;
  model.cluster_network.layers.resize(1);
  model.cluster_network.layers[0].input_count = 2;
  model.cluster_network.layers[0].output_count = 1;
  model.cluster_network.layers[0].weight = {{0.25f}, {-1}};
  model.cluster_network.layers[0].bias = {3};
  model.network_share = 0.5;
  model.dimension = 4;
  model.unit_count = 2;
  model.codebook = {{1, 0, 0, 0}, {0, 1, 0, 0}};
  model.gaussian_mean = {0.1, 0.2};
  model.gaussian_covariance = {{1, 0.5}, {0.5, 2}};
  model.operating_point_count = 2;
  model.operating_point_min_probability = {0.5, 0.7};
  model.operating_point_false_positives_per_frame = {0.1, 0.01};
  model.operating_point_miss_rate = {0.2, 0.3};
  return model;
}

/// A baseline of few features, with values that no rounding leaves alone.
inline BaselineModel SampleBaselineModel() {
  BaselineModel model;
  model.description = "two recordings, seed 1";
  model.config = {.max_range_m = 4.9,
                  .ground_clearance_m = 0.031,
                  .ground_clearance_per_sq_m = 0.0021,
                  .max_height_m = 0.61,
                  .leaf_m = 0.021,
                  .normal_radius_m = 0.071,
                  .cluster_tolerance_m = 0.051,
                  .min_cluster_points = 41,
                  .layers = 2,
                  .layer_height_m = 0.13,
                  .normal_bins = 3};
  model.trees.feature_count = 2 * (3 * 3 + 3) + 13;
  model.trees.roots = {0, 3};
  model.trees.nodes = {{2, 0.1f, 1, 0}, {-1, 0, 0, -0.3f}, {-1, 0, 0, 0.7f}, {-1, 0, 0, 0.01f}};
  model.calibration.slope = 2.345;
  model.calibration.intercept = 1.0 / 3;
  model.calibration.operating_points = {{0.5, 0.1, 0.05}, {0.75, 0.01, 0.2}};
  return model;
}

}  // namespace fallen::samples
