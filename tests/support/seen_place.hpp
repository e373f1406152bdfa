// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "fallen/classification/cluster_classification.hpp"

/// Decisions of a camera above a floor, without images: for tests of what follows on decisions.
namespace fallen::seen_place {

/// Camera at `position` that looks at `target`, image level.
inline Eigen::Isometry3d LookAt(const Eigen::Vector3d& position, const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - position).normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  T_world_camera.linear().col(0) = x;
  T_world_camera.linear().col(1) = z.cross(x);
  T_world_camera.linear().col(2) = z;
  T_world_camera.translation() = position;
  return T_world_camera;
}

/// A view of 57 x 43 degrees whose rays all end at the same depth.
inline CameraView FlatView(double depth_m) {
  CameraView view;
  view.intrinsics = {32, 24, 29, 29, 15.5, 11.5};
  view.depth_mm.assign(32 * 24, static_cast<std::uint16_t>(1000 * depth_m));
  return view;
}

/// Nobody found by a camera that sees 6 m far.
inline Decision Empty(const Eigen::Isometry3d& T_world_camera, double depth_m = 6) {
  Decision decision;
  decision.frame = MapFrame::kWorld;
  decision.T_map_camera = T_world_camera;
  decision.view = FlatView(depth_m);
  return decision;
}

/// Adds a cluster of a lying person's size.
inline void AddCluster(Decision& decision, const Eigen::Vector3d& centroid, double probability) {
  PersonHypothesis person;
  person.centroid = centroid;
  person.box = {centroid, {1.6, 0.5, 0.3}, 0.4};
  person.probability = probability;
  person.mahalanobis_distance = 10;
  person.cell_count = 100;
  person.is_person = probability >= decision.min_probability;
  const auto is_worse = [&](const PersonHypothesis& other) {
    return other.probability < probability;
  };
  decision.hypotheses.insert(
      std::find_if(decision.hypotheses.begin(), decision.hypotheses.end(), is_worse), person);
}

}  // namespace fallen::seen_place
