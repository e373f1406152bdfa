// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fallen/classification/calibration.hpp"
#include "fallen/classification/feature_network.hpp"
#include "fallen/classification/growing_neural_gas.hpp"
#include "fallen/classification/mahalanobis.hpp"
#include "fallen/geometry/oriented_box.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// Trained part of the classification, with the settings that it was trained for.
struct ClusterModel {
  IronConfig iron;
  Codebook codebook;
  double alpha = 0.7;  ///< soft threshold on the cosine
  MahalanobisModel gaussian;
  /// Judges ComputeClusterFeatures. Without trees the Mahalanobis distance alone decides, as in the
  /// paper.
  BoostedTrees trees;
  /// Judges the same beside the trees; empty: they alone.
  FeatureNetwork network;
  double network_share = 0;  ///< of the evidence, [0, 1]: the rest is the trees'
  Calibration calibration;

  void Validate() const;
};

struct ClassificationConfig {
  /// The user's wish: false positives per frame at which the validation set set the threshold.
  double false_positives_per_frame = 0.01;
  /// Of clusters whose centroids lie nearer to each other along the floor, only the likeliest is
  /// kept: the others most likely are parts of the same person [m], >= 0. A grown person is 1.5 to
  /// 2 m long; tuned on simulated validation recordings.
  double min_separation_m = 1.6;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("false_positives_per_frame", false_positives_per_frame);
    visit("min_separation_m", min_separation_m);
  }
};

/// A cluster, judged.
struct PersonHypothesis {
  /// Mean of the cells' means, weighted by score if trees judge the clusters, map frame [m].
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  OrientedBox box;         ///< smallest upright box around the cells
  double probability = 0;  ///< p(fallen | evidence)
  double mahalanobis_distance = 0;
  std::int32_t cell_count = 0;
  double mean_score = 0;   ///< of the cell classifier, [-1, 1]
  bool is_person = false;  ///< probability >= the threshold in force

  bool operator==(const PersonHypothesis&) const = default;
};

/// The decision about one frame: every cluster but those beside a better one, best first (ties: the
/// order of the clusters).
struct Decision {
  MapFrame frame = MapFrame::kCamera;
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  CameraView view;               ///< what the newest frame could see
  double min_probability = 0.5;  ///< threshold in force
  std::vector<PersonHypothesis> hypotheses;

  bool operator==(const Decision& other) const;
};

/// Judges every cluster (the paper, Sec. III-E and III-F), by trees its parts too. Of one cluster's
/// parts within 2 m of each other the likeliest is kept, as of clusters within min_separation_m.
/// @throws std::invalid_argument if the descriptors are of another kind than the model's, or the
/// calibration has no operating points.
/// Deterministic. Thread-safe.
Decision ClassifyClusters(const SegmentedMap& segmented, const ClusterModel& model,
                          const ClassificationConfig& config = {});

/// Finds the box of the least ground area around the cells of `cluster`: about their means, and
/// half a cell more on each side.
///
/// Upright means along z of the map frame, which is the vertical in all frames but
/// MapFrame::kCamera, where no vertical is known. The box's x axis is the longer one; yaw lies in
/// (-pi/2, pi/2].
/// [Freeman75] Freeman, Shapira: Determining the minimum-area encasing rectangle for an arbitrary
///             closed curve. CACM 18(7), 1975.
/// @throws std::invalid_argument for a cluster without cells. O(n log n), and n^2 in hull corners.
OrientedBox FitUprightBox(const SegmentedMap& segmented, const CellCluster& cluster);

}  // namespace fallen
