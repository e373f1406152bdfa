// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_segmentation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "flat_cell.hpp"

namespace fallen {
namespace {

constexpr int kPlate = 12 * 8;

// Three plates of 12 x 8 cells: two at 0.2 m, a metre apart, and one at 0.9 m beside them. Two lone
// cells without descriptors are strewn in between.
ForegroundMap Scene() {
  ForegroundMap foreground;
  NdtMap& map = foreground.map;
  map.frame = MapFrame::kWorld;
  map.T_map_camera.translation() << 1, 2, 3;
  map.ground.status = GroundStatus::kOk;
  const auto add_plate = [&](float x_begin, float z) {
    for (int x = 0; x < 12; ++x)
      for (int y = 0; y < 8; ++y)
        map.cells.push_back(
            FlatCell({x_begin + 0.05F * static_cast<float>(x), 0.05F * static_cast<float>(y), z}));
  };
  map.cells.push_back(FlatCell({50, 50, 0.2F}));
  add_plate(0, 0.2F);
  map.cells.push_back(FlatCell({60, 50, 0.2F}));
  add_plate(3, 0.9F);
  add_plate(1.6F, 0.2F);
  foreground.is_foreground.assign(map.cells.size(), 1);
  foreground.status = BackgroundStatus::kSubtracted;
  return foreground;
}

// One tree: cells up to 0.5 m are persons.
CellModel LowCells() {
  CellModel model;
  model.features = CellFeatureSet::kIronAndShape;
  model.trees.feature_count = CellFeatureCount(model.iron, model.features);
  model.trees.roots = {0};
  model.trees.nodes = {{model.iron.dimension() + 4, 0.5F, 1, 0}, {-1, 0, 0, 2}, {-1, 0, 0, -2}};
  return model;
}

// All cells are persons, but those above 0.5 m get no descriptor.
CellModel GateToLowCells() {
  CellModel model = LowCells();
  model.trees.nodes = {{-1, 0, 0, 1}};
  constexpr int kHeight = 3;
  model.gate.trees.feature_count = kShapeFeatureCount;
  model.gate.trees.roots = {0};
  model.gate.trees.nodes = {{kHeight, 0.5F, 1, 0}, {-1, 0, 0, 1}, {-1, 0, 0, -1}};
  model.gate.min_score = 0.5;
  model.gate.turned_away_score = -0.25;
  model.Validate();
  return model;
}

double MeanScoreWithin(float radius_m, const ScoredCell& center,
                       const std::vector<ScoredCell>& cells) {
  double sum = 0;
  int count = 0;
  for (const ScoredCell& cell : cells)
    if ((cell.mean - center.mean).squaredNorm() <= radius_m * radius_m) {
      sum += cell.score;
      ++count;
    }
  return sum / count;
}

TEST(SegmentCells, FindsTheTwoLowPlates) {
  const ForegroundMap foreground = Scene();
  LowCells().Validate();
  SegmentationTimes times{-1, -1, -1};
  const SegmentedMap segmented = SegmentCells(foreground, LowCells(), {}, &times);
  ASSERT_EQ(segmented.cells.size(), 3U * kPlate);  // the lone cells have no descriptor
  ASSERT_EQ(segmented.clusters.size(), 2U);
  std::size_t k = 0;
  std::vector<NdtCell> members;
  for (std::size_t i = 0; i < foreground.map.cells.size(); ++i) {
    if (foreground.map.cells[i].mean.y() == 50) continue;
    EXPECT_EQ(segmented.cells[k].mean, foreground.map.cells[i].mean);
    const bool is_low = segmented.cells[k].mean.z() < 0.5F;
    EXPECT_EQ(segmented.cells[k].score, is_low ? 1 : -1);
    EXPECT_EQ(segmented.cells[k].cluster, !is_low ? -1 : k < kPlate ? 0 : 1);
    if (is_low) members.push_back(foreground.map.cells[i]);
    ++k;
  }
  EXPECT_EQ(segmented.members, members);
  EXPECT_EQ(segmented.frame, MapFrame::kWorld);
  EXPECT_EQ(segmented.ground, foreground.map.ground);
  EXPECT_EQ(segmented.background, BackgroundStatus::kSubtracted);
  EXPECT_TRUE(segmented.T_map_camera.isApprox(foreground.map.T_map_camera));
  EXPECT_EQ(segmented.iron, IronConfig{});
  EXPECT_GE(times.iron, 0);
  EXPECT_GE(times.cells, 0);
  EXPECT_GE(times.clusters, 0);
}

TEST(SegmentCells, ListsEachClustersCellsWithTheirDescriptors) {
  const ForegroundMap foreground = Scene();
  const SegmentedMap segmented = SegmentCells(foreground, LowCells(), {});
  const IronDescriptors descriptors =
      ComputeIronDescriptors(foreground.map.cells, ComputeNormals(foreground.map.cells));
  for (std::size_t c = 0; c < 2; ++c) {
    const CellCluster& cluster = segmented.clusters[c];
    ASSERT_EQ(cluster.cells.size(), static_cast<std::size_t>(kPlate));
    ASSERT_EQ(cluster.descriptors.rows(), kPlate);
    for (int k = 0; k < kPlate; ++k) {
      EXPECT_EQ(cluster.cells[k], static_cast<int>(c) * 2 * kPlate + k);
      // In the map, one lone cell comes before the first plate and two before the others.
      const int in_map = cluster.cells[k] + (c == 0 ? 1 : 2);
      EXPECT_EQ(cluster.descriptors.row(k), descriptors.values.row(in_map));
    }
  }
}

TEST(SegmentCells, OrientsNormalsToTheCameraIfTheModelWantsThemSo) {
  // Half of a plate is above the camera, and seen from below.
  ForegroundMap foreground = Scene();
  NdtMap& map = foreground.map;
  for (NdtCell& cell : map.cells)
    if (cell.mean.x() > 0.3F) cell.mean.z() = 0.4F;
  map.T_map_camera.translation().z() = 0.3;
  CellModel model = LowCells();
  model.signs = NormalSigns::kOriented;
  const SegmentedMap segmented = SegmentCells(foreground, model, {});
  auto normals = ComputeNormals(map.cells);
  OrientNormals(map.cells, map.T_map_camera.translation().cast<float>(), normals);
  const IronDescriptors expected =
      ComputeIronDescriptors(map.cells, normals, {}, {}, NormalSigns::kOriented);
  ASSERT_FALSE(segmented.clusters.empty());
  const auto first = segmented.clusters[0].descriptors.row(0);
  EXPECT_EQ(first, expected.values.row(1));
  const int last_column = model.iron.angle_bins - 1;
  EXPECT_GT(first[model.iron.angle_bins + last_column], 0);  // opposite normals, not too near
}

TEST(SegmentCells, SmoothsScoresOverTheDescribedForeground) {
  // Half of a plate is bent upwards past 0.5 m: scores mix along the bend.
  ForegroundMap foreground = Scene();
  for (NdtCell& cell : foreground.map.cells)
    if (cell.mean.x() > 0.3F) cell.mean.z() = 0.52F;
  SegmentationConfig config;
  config.smoothing_radius_m = 0.4;
  const SegmentedMap smooth = SegmentCells(foreground, LowCells(), config);
  config.smoothing_radius_m = 0;
  const SegmentedMap raw = SegmentCells(foreground, LowCells(), config);
  ASSERT_EQ(smooth.cells.size(), raw.cells.size());
  bool has_mixed = false;
  for (std::size_t i = 0; i < raw.cells.size(); ++i) {
    EXPECT_EQ(std::abs(raw.cells[i].score), 1);
    EXPECT_NEAR(smooth.cells[i].score, MeanScoreWithin(0.4F, raw.cells[i], raw.cells), 1e-6);
    has_mixed |= std::abs(smooth.cells[i].score) < 0.9F;
  }
  EXPECT_TRUE(has_mixed);
}

TEST(SegmentCells, TurnsCellsAwayAtTheGate) {
  SegmentationConfig config;
  config.min_score = -1;  // what was turned away is nobody's even so
  const SegmentedMap gated = SegmentCells(Scene(), GateToLowCells(), config);
  CellModel open = GateToLowCells();
  open.gate = {};
  config.max_height_m = 2;
  const SegmentedMap all = SegmentCells(Scene(), open, config);
  ASSERT_EQ(gated.cells.size(), all.cells.size());
  EXPECT_EQ(all.clusters.size(), 3U);
  ASSERT_EQ(gated.clusters.size(), 2U);
  for (std::size_t k = 0; k < gated.cells.size(); ++k) {
    const bool is_low = gated.cells[k].mean.z() < 0.5F;
    EXPECT_EQ(gated.cells[k].mean, all.cells[k].mean);
    EXPECT_EQ(gated.cells[k].score, is_low ? 1 : -0.25F);
    EXPECT_EQ(gated.cells[k].cluster < 0, !is_low);
  }
  // The neighbours of a cell are all there, whether they passed or not.
  EXPECT_EQ(gated.clusters[0].MemberDescriptors(), all.clusters[0].MemberDescriptors());
  EXPECT_EQ(gated.clusters[1].MemberDescriptors(), all.clusters[2].MemberDescriptors());
}

TEST(SegmentCells, LetsWhatWasTurnedAwayHaveItsSayInSmoothing) {
  ForegroundMap foreground = Scene();
  for (NdtCell& cell : foreground.map.cells)
    if (cell.mean.x() > 0.3F) cell.mean.z() = 0.52F;
  SegmentationConfig config;
  config.smoothing_radius_m = 0.4;
  const SegmentedMap segmented = SegmentCells(foreground, GateToLowCells(), config);
  config.smoothing_radius_m = 0;
  const SegmentedMap raw = SegmentCells(foreground, GateToLowCells(), config);
  int mixed = 0;
  for (const ScoredCell& cell : segmented.cells) {
    if (cell.mean.z() > 0.5F) {
      EXPECT_EQ(cell.score, -0.25F);
      continue;
    }
    EXPECT_NEAR(cell.score, MeanScoreWithin(0.4F, cell, raw.cells), 1e-6);
    mixed += cell.score < 0.9F ? 1 : 0;
  }
  EXPECT_GT(mixed, 10);
}

TEST(SegmentCells, LetsEveryCellPassWithoutAFloor) {
  ForegroundMap no_floor = Scene();
  no_floor.map.ground.status = GroundStatus::kNoFloorInView;
  EXPECT_EQ(SegmentCells(no_floor, GateToLowCells(), {}).clusters.size(), 3U);
}

TEST(SegmentCells, PassesOverBackgroundCellsButLetsDescriptorsSeeThem) {
  ForegroundMap foreground = Scene();
  for (int i = 0; i < kPlate / 2; ++i) foreground.is_foreground[1 + i] = 0;  // half a plate
  const SegmentedMap all_seen = SegmentCells(foreground, LowCells(), {});
  EXPECT_EQ(all_seen.cells.size(), 5U * kPlate / 2);
  ASSERT_EQ(all_seen.clusters.size(), 2U);
  EXPECT_EQ(all_seen.clusters[0].cells.size(), static_cast<std::size_t>(kPlate / 2));
  const IronDescriptors whole =
      ComputeIronDescriptors(foreground.map.cells, ComputeNormals(foreground.map.cells));
  EXPECT_EQ(all_seen.clusters[0].descriptors.row(0), whole.values.row(1 + kPlate / 2));

  SegmentationConfig config;
  config.descriptors_on_foreground_only = true;
  const SegmentedMap foreground_seen = SegmentCells(foreground, LowCells(), config);
  std::vector<NdtCell> cells;
  for (std::size_t i = 0; i < foreground.map.cells.size(); ++i)
    if (foreground.is_foreground[i]) cells.push_back(foreground.map.cells[i]);
  const IronDescriptors part = ComputeIronDescriptors(cells, ComputeNormals(cells));
  ASSERT_EQ(foreground_seen.clusters.size(), 2U);
  EXPECT_EQ(foreground_seen.clusters[0].descriptors.row(0), part.values.row(1));
  EXPECT_NE(foreground_seen.clusters[0].descriptors, all_seen.clusters[0].descriptors);
}

TEST(SegmentCells, NeverTakesCellsAboveTheGreatestHeight) {
  SegmentationConfig config;
  config.max_height_m = 0.1;
  config.min_score = -1;
  SegmentedMap segmented = SegmentCells(Scene(), LowCells(), config);
  EXPECT_TRUE(segmented.clusters.empty());
  for (const ScoredCell& cell : segmented.cells) EXPECT_EQ(cell.score, -1);

  ForegroundMap no_floor = Scene();
  no_floor.map.ground.status = GroundStatus::kNoFloorInView;
  segmented = SegmentCells(no_floor, LowCells(), config);
  EXPECT_EQ(segmented.clusters.size(), 3U);  // heights are not known: none is too high
}

TEST(SegmentCells, DropsSmallClustersAndNumbersTheRest) {
  ForegroundMap foreground = Scene();
  for (int i = 0; i < kPlate - 20; ++i) foreground.is_foreground[1 + i] = 0;
  SegmentationConfig config;
  config.min_cluster_cells = 21;
  const SegmentedMap segmented = SegmentCells(foreground, LowCells(), config);
  ASSERT_EQ(segmented.clusters.size(), 1U);
  EXPECT_EQ(segmented.clusters[0].cells.size(), static_cast<std::size_t>(kPlate));
  for (std::size_t k = 0; k < segmented.cells.size(); ++k)
    EXPECT_EQ(segmented.cells[k].cluster, k < 20 + kPlate ? -1 : 0);
}

TEST(SegmentCells, TakesMapsWithoutCellsAndWithoutForeground) {
  ForegroundMap nothing = Scene();
  nothing.map.cells.clear();
  nothing.is_foreground.clear();
  EXPECT_TRUE(SegmentCells(nothing, LowCells(), {}).cells.empty());
  ForegroundMap background = Scene();
  background.is_foreground.assign(background.is_foreground.size(), 0);
  SegmentationConfig config;
  for (const bool on_foreground_only : {false, true}) {
    config.descriptors_on_foreground_only = on_foreground_only;
    const SegmentedMap segmented = SegmentCells(background, LowCells(), config);
    EXPECT_TRUE(segmented.cells.empty());
    EXPECT_TRUE(segmented.clusters.empty());
  }
}

TEST(SegmentCells, RejectsMapsThatDoNotFit) {
  ForegroundMap foreground = Scene();
  foreground.map.cell_size_m = 0.1;
  EXPECT_THROW(SegmentCells(foreground, LowCells(), {}), std::invalid_argument);
  foreground = Scene();
  foreground.is_foreground.pop_back();
  EXPECT_THROW(SegmentCells(foreground, LowCells(), {}), std::invalid_argument);
  foreground = Scene();
  foreground.map.cells[7].mean.x() = std::nanf("");
  EXPECT_THROW(SegmentCells(foreground, LowCells(), {}), std::invalid_argument);
}

TEST(SegmentationConfig, ValidateRejectsValuesOutOfRange) {
  EXPECT_NO_THROW(SegmentationConfig{}.Validate());
  const auto rejects = [](auto&& change) {
    SegmentationConfig config;
    change(config);
    EXPECT_THROW(config.Validate(), std::invalid_argument);
  };
  rejects([](auto& c) { c.smoothing_radius_m = -0.1; });
  rejects([](auto& c) { c.smoothing_radius_m = std::nan(""); });
  rejects([](auto& c) { c.min_score = 1.1; });
  rejects([](auto& c) { c.max_height_m = 0; });
  rejects([](auto& c) { c.max_height_m = INFINITY; });
  rejects([](auto& c) { c.cluster_epsilon_m = 0; });
  rejects([](auto& c) { c.cluster_min_points = 0; });
  rejects([](auto& c) { c.min_cluster_cells = 0; });
}

TEST(CellModel, ValidateRejectsPartsThatDoNotFit) {
  const auto rejects = [](auto&& change) {
    CellModel model = LowCells();
    change(model);
    EXPECT_THROW(model.Validate(), std::invalid_argument);
  };
  rejects([](auto& m) { m.cell_size_m = 0; });
  rejects([](auto& m) { m.features = CellFeatureSet::kIron; });
  rejects([](auto& m) { m.features = static_cast<CellFeatureSet>(7); });
  rejects([](auto& m) { m.iron.angle_bins = 9; });
  rejects([](auto& m) { m.trees.roots.clear(); });
  rejects([](auto& m) { m.gate.min_score = 2; });
  rejects([](auto& m) { m.trees.nodes[0].left = 2; });
}

}  // namespace
}  // namespace fallen
