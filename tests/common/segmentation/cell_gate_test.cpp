// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/cell_gate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fallen {
namespace {

constexpr int kHeight = 3;  // column of the shape features

// Cells up to 0.5 m get 1, others -1.
CellGate LowCells() {
  CellGate gate;
  gate.trees.feature_count = kShapeFeatureCount;
  gate.trees.roots = {0};
  gate.trees.nodes = {{kHeight, 0.5F, 1, 0}, {-1, 0, 0, 1}, {-1, 0, 0, -1}};
  gate.min_score = 0;
  gate.turned_away_score = -0.2;
  return gate;
}

NdtMap MapWithFloor() {
  NdtMap map;
  map.ground.status = GroundStatus::kOk;
  return map;
}

FeatureMatrix ALowAndAHighCell() {
  FeatureMatrix shapes = FeatureMatrix::Zero(2, kShapeFeatureCount);
  shapes(0, kHeight) = 0.2F;
  shapes(1, kHeight) = 0.8F;
  return shapes;
}

TEST(CellGate, LetsPassFromTheThresholdOn) {
  CellGate gate = LowCells();
  gate.min_score = 0.25;
  EXPECT_TRUE(gate.Passes(0.25F));
  EXPECT_FALSE(gate.Passes(0.2499F));
  EXPECT_FALSE(gate.is_open());
  EXPECT_TRUE(CellGate{}.is_open());
}

TEST(CellGate, ValidateRejectsValuesOutOfRange) {
  EXPECT_NO_THROW(LowCells().Validate());
  EXPECT_NO_THROW(CellGate{}.Validate());
  const auto rejects = [](auto&& change) {
    CellGate gate = LowCells();
    change(gate);
    EXPECT_THROW(gate.Validate(), std::invalid_argument);
  };
  rejects([](auto& gate) { gate.min_score = -1.01; });
  rejects([](auto& gate) { gate.min_score = std::nan(""); });
  rejects([](auto& gate) { gate.turned_away_score = 1.01; });
  rejects([](auto& gate) { gate.trees.feature_count = kShapeFeatureCount + 1; });
  rejects([](auto& gate) { gate.trees.nodes[0].left = 2; });
}

TEST(GateKeeper, ScoresEveryCellWhereTheFloorIsKnown) {
  GateKeeper keeper(LowCells());
  const std::span<const float> scores = keeper.Score(MapWithFloor(), ALowAndAHighCell());
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_FLOAT_EQ(scores[0], 1);
  EXPECT_FLOAT_EQ(scores[1], -1);
  EXPECT_TRUE(keeper.Score(MapWithFloor(), FeatureMatrix(0, kShapeFeatureCount)).empty());
}

TEST(GateKeeper, LooksAtNothingWithoutAFloorOrWithoutTrees) {
  NdtMap no_floor;
  no_floor.ground.status = GroundStatus::kNoFloorInView;
  GateKeeper keeper(LowCells());
  EXPECT_TRUE(keeper.Score(no_floor, ALowAndAHighCell()).empty());
  GateKeeper open{CellGate{}};
  EXPECT_TRUE(open.Score(MapWithFloor(), ALowAndAHighCell()).empty());
}

}  // namespace
}  // namespace fallen
