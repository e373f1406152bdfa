// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_segmentation.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fallen/segmentation/cell_segmenter.hpp"

namespace fallen {
namespace {

// Score of a cell that no score could make a person.
constexpr float kNeverPerson = -1;

[[noreturn]] void Fail(const std::string& what) {
  throw std::invalid_argument("cell_segmentation: " + what);
}

// Measures one stage after the other.
class Stopwatch {
 public:
  double Lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double, std::milli> lap = now - last_;
    last_ = now;
    return lap.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

void Check(const ForegroundMap& foreground, double cell_size_m) {
  const NdtMap& map = foreground.map;
  if (map.cell_size_m != cell_size_m)
    Fail("the map's cell size is " + std::to_string(map.cell_size_m) + " m, the model's " +
         std::to_string(cell_size_m) + " m");
  if (foreground.is_foreground.size() != map.cells.size())
    Fail("got " + std::to_string(foreground.is_foreground.size()) + " flags for " +
         std::to_string(map.cells.size()) + " cells");
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (!map.cells[i].mean.allFinite()) Fail("cell " + std::to_string(i) + " is not finite");
}

void TakeForegroundOnly(const ForegroundMap& foreground, NdtMap& map) {
  map.cell_size_m = foreground.map.cell_size_m;
  map.ground = foreground.map.ground;
  map.cells.clear();
  for (std::size_t i = 0; i < foreground.map.cells.size(); ++i)
    if (foreground.is_foreground[i]) map.cells.push_back(foreground.map.cells[i]);
}

}  // namespace

void GrowDescriptors(CellCluster& cluster, Eigen::Index dimension) {
  const auto rows = static_cast<Eigen::Index>(cluster.cells.size());
  if (cluster.descriptors.rows() < rows || cluster.descriptors.cols() != dimension)
    cluster.descriptors.resize(rows, dimension);
}

void CellModel::Validate() const {
  if (!(cell_size_m > 0) || !std::isfinite(cell_size_m))
    Fail("the model's cell_size_m is " + std::to_string(cell_size_m) + ", must be > 0 and finite");
  if (EnumName(features) == "unknown")
    Fail("the model's features are " + std::to_string(static_cast<int>(features)) +
         ", must be in [0, 1]");
  iron.Validate();
  gate.Validate();
  trees.Validate();
  if (trees.roots.empty()) Fail("the model has no trees");
  const int expected = CellFeatureCount(iron, features);
  if (trees.feature_count != expected)
    Fail("the model's trees take " + std::to_string(trees.feature_count) +
         " features, its settings make " + std::to_string(expected));
}

void SegmentationConfig::Validate() const {
  const auto check = [](const char* name, double value, bool is_good, const char* range) {
    if (!is_good || !std::isfinite(value))
      Fail(std::string(name) + " is " + std::to_string(value) + ", must be " + range);
  };
  check("smoothing_radius_m", smoothing_radius_m, smoothing_radius_m >= 0, ">= 0 and finite");
  check("min_score", min_score, min_score >= -1 && min_score <= 1, "in [-1, 1]");
  check("max_height_m", max_height_m, max_height_m > 0, "> 0 and finite");
  check("cluster_epsilon_m", cluster_epsilon_m, cluster_epsilon_m > 0, "> 0 and finite");
  check("cluster_min_points", cluster_min_points, cluster_min_points >= 1, ">= 1");
  check("min_cluster_cells", min_cluster_cells, min_cluster_cells >= 1, ">= 1");
}

CellSegmenter::CellSegmenter(const CellModel& model, const SegmentationConfig& config)
    : config_(config),
      cell_size_m_(model.cell_size_m),
      signs_(model.signs),
      features_(model.features),
      gate_keeper_(model.gate),
      scorer_(model.trees),
      describer_(model.iron, model.signs) {
  config_.Validate();
}

// The cells that can get a score, or give one by smoothing to a cell that can: foreground that does
// not lie too high above the floor.
void CellSegmenter::FindWanted(const NdtMap& map, std::span<const std::uint8_t> is_foreground) {
  is_wanted_.assign(map.cells.size(), 1);
  if (!is_foreground.empty()) is_wanted_.assign(is_foreground.begin(), is_foreground.end());
  if (!map.ground.ok()) return;
  const double max_height_m = config_.max_height_m + config_.smoothing_radius_m;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (map.ground.plane.SignedHeight(map.cells[i].mean.cast<double>()) > max_height_m)
      is_wanted_[i] = 0;
}

// Lets the gate look at the wanted cells; those that it turns away are not wanted any more.
void CellSegmenter::PassGate(const NdtMap& map) {
  at_gate_.clear();
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (is_wanted_[i] && normals_[i].usable) at_gate_.push_back(static_cast<std::int32_t>(i));
  const CellGate& gate = gate_keeper_.gate();
  if (gate.is_open() && features_ == CellFeatureSet::kIron) return;
  ComputeShapeFeatures(map, normals_, at_gate_, shapes_);
  const std::span<const float> scores =
      gate_keeper_.Score(map, shapes_.matrix.topRows(static_cast<Eigen::Index>(at_gate_.size())));
  for (std::size_t k = 0; k < scores.size(); ++k)
    if (!gate.Passes(scores[k])) is_wanted_[at_gate_[k]] = 0;
}

void CellSegmenter::FindJudged(const IronDescriptors& descriptors) {
  judged_.clear();
  scores_.clear();
  may_be_person_.clear();
  described_.clear();
  described_shape_.clear();
  for (std::size_t k = 0; k < at_gate_.size(); ++k) {
    const std::int32_t cell = at_gate_[k];
    const bool has_passed = is_wanted_[cell] != 0;
    if (has_passed && !descriptors.valid(cell)) continue;
    judged_.push_back(cell);
    may_be_person_.push_back(has_passed ? 1 : 0);
    scores_.push_back(static_cast<float>(gate_keeper_.gate().turned_away_score));
    if (!has_passed) continue;
    described_.push_back(cell);
    described_shape_.push_back(static_cast<std::int32_t>(k));
  }
}

void CellSegmenter::ScoreDescribed(const IronDescriptors& descriptors) {
  if (features_ == CellFeatureSet::kIron)
    TakeDescriptors(descriptors, described_, cell_features_);
  else
    JoinCellFeatures(descriptors, described_, shapes_.matrix, described_shape_, cell_size_m_,
                     cell_features_);
  scorer_.Score(cell_features_.topRows(static_cast<Eigen::Index>(described_.size())),
                described_scores_);
  std::size_t next = 0;
  for (std::size_t k = 0; k < judged_.size(); ++k)
    if (may_be_person_[k]) scores_[k] = described_scores_[next++];
}

// What was turned away has a say in its neighbours' scores, but keeps its own.
void CellSegmenter::SmoothScores() {
  if (config_.smoothing_radius_m == 0 || judged_.empty()) return;
  // The descriptors' tiles are over the usable cells, of which the judged ones are some.
  const std::span<const std::int32_t> usable = describer_.usable();
  usable_scores_.assign(usable.size(), 0);
  is_judged_.assign(usable.size(), 0);
  std::size_t k = 0;
  for (std::size_t u = 0; u < usable.size() && k < judged_.size(); ++u) {
    if (usable[u] != judged_[k]) continue;
    usable_scores_[u] = scores_[k++];
    is_judged_[u] = 1;
  }
  const std::vector<float>& smoothed =
      smoother_.Smooth(describer_.tiles(), usable_scores_, is_judged_,
                       static_cast<float>(config_.smoothing_radius_m));
  k = 0;
  for (std::size_t u = 0; u < usable.size(); ++u) {
    if (!is_judged_[u]) continue;
    if (may_be_person_[k]) scores_[k] = smoothed[u];
    ++k;
  }
}

void CellSegmenter::WriteCells(const NdtMap& visible, const GroundEstimate& ground,
                               std::vector<ScoredCell>& cells) {
  cells.clear();
  for (std::size_t k = 0; k < judged_.size(); ++k) {
    const NdtCell& cell = visible.cells[judged_[k]];
    const bool is_too_high =
        ground.ok() && ground.plane.SignedHeight(cell.mean.cast<double>()) > config_.max_height_m;
    if (is_too_high) may_be_person_[k] = 0;
    cells.push_back({cell.mean, is_too_high ? kNeverPerson : scores_[k], -1});
  }
}

// An empty cluster, in the memory of an old one if there is any.
CellCluster& CellSegmenter::AddCluster(std::vector<CellCluster>& clusters) {
  if (spare_clusters_.empty()) return clusters.emplace_back();
  clusters.push_back(std::move(spare_clusters_.back()));
  spare_clusters_.pop_back();
  clusters.back().cells.clear();
  return clusters.back();
}

// Makes clusters of the cells that are grouped, where the groups are large enough.
void CellSegmenter::ClusterCells(const IronDescriptors& descriptors, SegmentedMap& segmented) {
  std::vector<ScoredCell>& cells = segmented.cells;
  candidates_.clear();
  candidate_means_.clear();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!may_be_person_[k] || static_cast<double>(cells[k].score) < config_.min_score) continue;
    candidates_.push_back(static_cast<std::int32_t>(k));
    candidate_means_.push_back(cells[k].mean);
  }
  const std::vector<std::int32_t>& labels = clusterer_.Label(
      candidate_means_, static_cast<float>(config_.cluster_epsilon_m), config_.cluster_min_points);

  // Small groups are dropped before memory is made for them.
  group_sizes_.clear();
  for (const std::int32_t label : labels) {
    if (label == kNoise) continue;
    if (static_cast<std::size_t>(label) >= group_sizes_.size()) group_sizes_.resize(label + 1, 0);
    ++group_sizes_[label];
  }
  for (CellCluster& cluster : segmented.clusters) spare_clusters_.push_back(std::move(cluster));
  segmented.clusters.clear();
  cluster_of_group_.clear();
  for (const std::int32_t size : group_sizes_) {
    const bool is_cluster = size >= config_.min_cluster_cells;
    cluster_of_group_.push_back(is_cluster ? static_cast<std::int32_t>(segmented.clusters.size())
                                           : -1);
    if (is_cluster) AddCluster(segmented.clusters).cells.reserve(size);
  }
  for (std::size_t c = 0; c < labels.size(); ++c) {
    if (labels[c] == kNoise || cluster_of_group_[labels[c]] < 0) continue;
    cells[candidates_[c]].cluster = cluster_of_group_[labels[c]];
    segmented.clusters[cluster_of_group_[labels[c]]].cells.push_back(candidates_[c]);
  }
  for (CellCluster& cluster : segmented.clusters) {
    GrowDescriptors(cluster, descriptors.values.cols());
    for (std::size_t k = 0; k < cluster.cells.size(); ++k)
      cluster.descriptors.row(static_cast<Eigen::Index>(k)) =
          descriptors.values.row(judged_[cluster.cells[k]]);
  }
}

void CellSegmenter::WriteMembers(const NdtMap& visible, SegmentedMap& segmented) const {
  segmented.members.clear();
  for (std::size_t k = 0; k < segmented.cells.size(); ++k)
    if (segmented.cells[k].cluster >= 0) segmented.members.push_back(visible.cells[judged_[k]]);
}

SegmentedMap CellSegmenter::Segment(const ForegroundMap& foreground, SegmentationTimes* times) {
  SegmentedMap segmented;
  Segment(foreground, segmented, times);
  return segmented;
}

void CellSegmenter::Segment(const ForegroundMap& foreground, SegmentedMap& segmented,
                            SegmentationTimes* times) {
  Check(foreground, cell_size_m_);
  const NdtMap& map = foreground.map;
  Stopwatch stopwatch;

  const bool foreground_only = config_.descriptors_on_foreground_only;
  if (foreground_only) TakeForegroundOnly(foreground, foreground_only_);
  const NdtMap& visible = foreground_only ? foreground_only_ : map;
  FindWanted(visible, foreground_only ? std::span<const std::uint8_t>() : foreground.is_foreground);
  ComputeNormals(visible.cells, describer_.config(), normals_);
  if (signs_ == NormalSigns::kOriented)
    OrientNormals(visible.cells, map.T_map_camera.translation().cast<float>(), normals_);
  double iron_ms = stopwatch.Lap();
  PassGate(visible);
  double cells_ms = stopwatch.Lap();
  const IronDescriptors& descriptors = describer_.Describe(visible.cells, normals_, is_wanted_);
  iron_ms += stopwatch.Lap();
  FindJudged(descriptors);
  ScoreDescribed(descriptors);
  SmoothScores();

  segmented.cell_size_m = map.cell_size_m;
  segmented.frame = map.frame;
  segmented.T_map_camera = map.T_map_camera;
  segmented.view = map.view;
  segmented.ground = map.ground;
  segmented.background = foreground.status;
  segmented.iron = describer_.config();
  WriteCells(visible, map.ground, segmented.cells);
  cells_ms += stopwatch.Lap();

  ClusterCells(descriptors, segmented);
  WriteMembers(visible, segmented);
  if (times) *times = {iron_ms, cells_ms, stopwatch.Lap()};
}

SegmentedMap SegmentCells(const ForegroundMap& foreground, const CellModel& model,
                          const SegmentationConfig& config, SegmentationTimes* times) {
  return CellSegmenter(model, config).Segment(foreground, times);
}

}  // namespace fallen
