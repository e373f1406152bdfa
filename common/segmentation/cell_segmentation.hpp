// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/segmentation/boosted_trees.hpp"

namespace fallen {

/// What the cell classifier looks at.
enum class CellFeatureSet : std::int32_t {
  kIron = 0,          ///< the descriptor alone: the paper
  kIronAndShape = 1,  ///< and height above the floor, verticality of the normal, the cell's shape
};
constexpr auto EnumNames(CellFeatureSet) {
  return EnumTable<CellFeatureSet, 2>{
      {{CellFeatureSet::kIron, "iron"}, {CellFeatureSet::kIronAndShape, "iron_and_shape"}}};
}

/// Trained part of the segmentation, with the settings that it was trained for.
struct CellModel {
  double cell_size_m = 0.05;
  IronConfig iron;
  CellFeatureSet features = CellFeatureSet::kIron;
  BoostedTrees trees;

  void Validate() const;
};

struct SegmentationConfig {
  double smoothing_radius_m = 0.15;  ///< 0: no smoothing
  double min_score = 0.0;            ///< smoothed score from which a cell counts as person, [-1, 1]
  double max_height_m = 1.2;         ///< cells higher above the floor are never person
  double cluster_epsilon_m = 0.12;
  int cluster_min_points = 6;
  int min_cluster_cells = 15;        ///< smaller clusters are dropped
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
  NdtCell cell;
  float score = 0;                   ///< smoothed, [-1, 1]; NaN never
  std::int32_t cluster = -1;         ///< index into `clusters`, or -1

  bool operator==(const ScoredCell&) const = default;
};

/// Cells that most likely are one object, most likely a person.
struct CellCluster {
  std::vector<std::int32_t> cells;     ///< indices into `SegmentedMap::cells`, ascending
  IronDescriptors::Matrix descriptors; ///< one row a member, the same order
};

/// What the segmentation leaves of a map.
struct SegmentedMap {
  double cell_size_m = 0.05;
  MapFrame frame = MapFrame::kCamera;
  Eigen::Isometry3d T_map_camera = Eigen::Isometry3d::Identity();
  GroundEstimate ground;              ///< plane in the map frame
  BackgroundStatus background = BackgroundStatus::kNoEnvironmentMap;
  IronConfig iron;                    ///< how `descriptors` were computed
  std::vector<ScoredCell> cells;      ///< all foreground cells with a descriptor
  std::vector<CellCluster> clusters;
};

/// Time spent inside the segmentation [ms].
struct SegmentationTimes {
  double iron = 0;
  double cells = 0;
  double clusters = 0;
};

/// Features of the cells that have a descriptor, one row a cell of `indices`: the descriptor, and
/// for kIronAndShape further columns. Shared by training and use.
FeatureMatrix ComputeCellFeatures(const NdtMap& map, std::span<const CellNormal> normals,
                                  const IronDescriptors& descriptors,
                                  std::span<const std::int32_t> indices, CellFeatureSet features);

/// Number of columns of ComputeCellFeatures.
int CellFeatureCount(const IronConfig& iron, CellFeatureSet features);

/// Descriptors, cell classification, smoothing, clustering (the paper, Sec. III-C and III-D.2-4).
/// @throws std::invalid_argument if the map's cell size is not the model's.
/// Deterministic. Thread-safe.
SegmentedMap SegmentCells(const ForegroundMap& foreground, const CellModel& model,
                          const SegmentationConfig& config, SegmentationTimes* times = nullptr);

}  // namespace fallen
