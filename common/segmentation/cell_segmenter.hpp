// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/iron/iron_describer.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"
#include "fallen/segmentation/dbscan.hpp"
#include "fallen/segmentation/smoothing.hpp"
#include "fallen/segmentation/tree_scorer.hpp"

namespace fallen {

/// SegmentCells for frame after frame: with the model prepared once, and in the same memory. Not
/// thread-safe.
class CellSegmenter {
 public:
  /// @param model  Valid: see CellModel::Validate.
  /// @throws std::invalid_argument if `config` is out of range.
  CellSegmenter(const CellModel& model, const SegmentationConfig& config);

  /// @throws std::invalid_argument as SegmentCells.
  SegmentedMap Segment(const ForegroundMap& foreground, SegmentationTimes* times = nullptr);
  /// Likewise, into memory that is there.
  void Segment(const ForegroundMap& foreground, SegmentedMap& segmented,
               SegmentationTimes* times = nullptr);

 private:
  void FindWanted(const NdtMap& map, std::span<const std::uint8_t> is_foreground);
  void PassGate(const NdtMap& map);
  void FindJudged(const IronDescriptors& descriptors);
  void ScoreDescribed(const IronDescriptors& descriptors);
  void SmoothScores();
  void WriteCells(const NdtMap& visible, const GroundEstimate& ground,
                  std::vector<ScoredCell>& cells);
  CellCluster& AddCluster(std::vector<CellCluster>& clusters);
  void ClusterCells(const IronDescriptors& descriptors, SegmentedMap& segmented);
  void WriteMembers(const NdtMap& visible, SegmentedMap& segmented) const;

  SegmentationConfig config_;
  double cell_size_m_;
  NormalSigns signs_;
  CellFeatureSet features_;
  GateKeeper gate_keeper_;
  TreeScorer scorer_;
  IronDescriber describer_;
  ScoreSmoother smoother_;
  NdtMap foreground_only_;
  std::vector<std::uint8_t> is_wanted_;
  std::vector<CellNormal> normals_;
  std::vector<std::int32_t> at_gate_;          // usable cells that are wanted
  ShapeFeatures shapes_;                       // of those, if anybody asks
  std::vector<std::int32_t> judged_;           // cells that were turned away or have a descriptor
  std::vector<float> scores_;                  // of those
  std::vector<std::uint8_t> may_be_person_;    // likewise
  std::vector<std::int32_t> described_;        // cells with a descriptor
  std::vector<std::int32_t> described_shape_;  // rows in `shapes_` of those
  FeatureMatrix cell_features_;                // likewise
  std::vector<float> described_scores_;        // likewise
  std::vector<float> usable_scores_;           // by the describer's usable cells
  std::vector<std::uint8_t> is_judged_;        // likewise
  PointClusterer clusterer_;
  std::vector<std::int32_t> candidates_;  // scored cells that may be a person's
  std::vector<Eigen::Vector3f> candidate_means_;
  std::vector<std::int32_t> group_sizes_;
  std::vector<std::int32_t> cluster_of_group_;  // -1: too small
  std::vector<CellCluster> spare_clusters_;     // of earlier frames
};

}  // namespace fallen
