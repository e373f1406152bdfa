// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/cell_features.hpp"
#include "fallen/segmentation/cell_gate.hpp"

namespace fallen {

/// Trained part of the segmentation, with the settings that it was trained for.
struct CellModel {
  double cell_size_m = 0.05;
  IronConfig iron;
  /// Oriented to where the camera of the frame is, of cells seen earlier too. Of experiments only:
  /// model files are of arbitrary signs.
  NormalSigns signs = NormalSigns::kArbitrary;
  CellGate gate;  ///< which cells get a descriptor at all
  CellFeatureSet features = CellFeatureSet::kIron;
  BoostedTrees trees;

  /// @throws std::invalid_argument for values out of range, a model without trees, or trees that
  /// take another number of features than the settings make.
  void Validate() const;
};

struct SegmentationConfig {
  double smoothing_radius_m = 0.15;  ///< 0: no smoothing
  double min_score = 0.0;            ///< smoothed score from which a cell counts as person, [-1, 1]
  /// Cells higher above the floor are never person: their score is -1. Without a known floor this
  /// is not applied.
  double max_height_m = 0.9;
  double cluster_epsilon_m = 0.12;  ///< DBSCAN's radius, > 0; 0.10-0.15 m suit cells of 5 cm
  int cluster_min_points = 6;  ///< cells within it that make a core cell, itself included, >= 1
  int min_cluster_cells = 15;  ///< smaller clusters are dropped, >= 1
  /// True: descriptors see foreground cells only, though the paper's Fig. 2 computes them before.
  bool descriptors_on_foreground_only = false;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("smoothing_radius_m", smoothing_radius_m);
    visit("min_score", min_score);
    visit("max_height_m", max_height_m);
    visit("cluster_epsilon_m", cluster_epsilon_m);
    visit("cluster_min_points", cluster_min_points);
    visit("min_cluster_cells", min_cluster_cells);
    visit("descriptors_on_foreground_only", descriptors_on_foreground_only);
  }
  bool operator==(const SegmentationConfig&) const = default;
};

/// A foreground cell after classification, smoothing and clustering.
struct ScoredCell {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();  ///< of the cell, map frame [m]
  float score = 0;                                 ///< smoothed, or the gate's, [-1, 1]; NaN never
  std::int32_t cluster = -1;                       ///< index into `clusters`, or -1

  bool operator==(const ScoredCell&) const = default;
};

/// Cells that most likely are one object, most likely a person.
struct CellCluster {
  std::vector<std::int32_t> cells;      ///< indices into `SegmentedMap::cells`, ascending
  IronDescriptors::Matrix descriptors;  ///< one row a member, the same order; more mean nothing

  /// The members' rows.
  auto MemberDescriptors() const {
    return descriptors.topRows(static_cast<Eigen::Index>(cells.size()));
  }
};

/// Gives `cluster` room for the descriptors of its members, in memory that is there if it suffices.
void GrowDescriptors(CellCluster& cluster, Eigen::Index dimension);

/// What the segmentation leaves of a map.
struct SegmentedMap {
  double cell_size_m = 0.05;
  MapFrame frame = MapFrame::kCamera;
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  CameraView view;        ///< what the newest frame could see
  GroundEstimate ground;  ///< plane in the map frame
  BackgroundStatus background = BackgroundStatus::kNoEnvironmentMap;
  IronConfig iron;  ///< how `descriptors` were computed
  /// Foreground cells that the gate turned away or that have a descriptor; not far above
  /// `max_height_m`.
  std::vector<ScoredCell> cells;
  std::vector<NdtCell> members;  ///< the cells that belong to a cluster, in the order of `cells`
  std::vector<CellCluster> clusters;
};

/// Time spent inside the segmentation [ms].
struct SegmentationTimes {
  double iron = 0;
  double cells = 0;
  double clusters = 0;
};

/// Descriptors, cell classification, smoothing, clustering (the paper, Sec. III-C and III-D.2-4).
///
/// Cells keep the map's order, clusters come in the order of their first core cells.
/// @param model  Valid: see CellModel::Validate.
/// @param times  If given, is told how long the parts took.
/// @throws std::invalid_argument if `config` is out of range, the map's cell size is not the
/// model's, the flags are not one a cell, or a cell's mean is not finite. Deterministic.
/// Thread-safe.
SegmentedMap SegmentCells(const ForegroundMap& foreground, const CellModel& model,
                          const SegmentationConfig& config, SegmentationTimes* times = nullptr);

}  // namespace fallen
