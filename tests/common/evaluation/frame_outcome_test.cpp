// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/frame_outcome.hpp"

#include <gtest/gtest.h>

namespace fallen {
namespace {

PersonHypothesis At(double x, double probability) {
  PersonHypothesis hypothesis;
  hypothesis.centroid = {x, 0, 0.1};
  hypothesis.probability = probability;
  return hypothesis;
}

Decision InWorld(std::vector<PersonHypothesis> hypotheses) {
  Decision decision;
  decision.frame = MapFrame::kWorld;
  decision.hypotheses = std::move(hypotheses);
  return decision;
}

const OrientedBox kBox{{0, 0, 0.2}, {2, 1, 0.4}, 0};

TEST(FrameOutcome, OnlyTheBestHypothesisInTheBoxIsAHit) {
  const Decision decision = InWorld({At(0.5, 0.6), At(-0.5, 0.8), At(5, 0.7)});
  const FrameOutcome outcome = JudgeFrame(decision, kBox, 100);
  EXPECT_TRUE(outcome.is_positive);
  EXPECT_EQ(outcome.hit_score, 0.8);
  EXPECT_EQ(outcome.false_scores, (std::vector<double>{0.6, 0.7}));
}

TEST(FrameOutcome, WithTooFewCellsAHypothesisInTheBoxCountsNeitherWay) {
  const Decision decision = InWorld({At(0.5, 0.6), At(5, 0.7)});
  const FrameOutcome outcome = JudgeFrame(decision, kBox, kMinCellsInBox - 1);
  EXPECT_FALSE(outcome.is_positive);
  EXPECT_FALSE(outcome.hit_score);
  EXPECT_EQ(outcome.false_scores, std::vector<double>{0.7});
}

TEST(FrameOutcome, WithoutAPersonEveryHypothesisIsFalse) {
  const Decision decision = InWorld({At(0.5, 0.6)});
  const FrameOutcome outcome = JudgeFrame(decision, std::nullopt, 500);
  EXPECT_FALSE(outcome.is_positive);
  EXPECT_EQ(outcome.false_scores, std::vector<double>{0.6});
}

TEST(FrameOutcome, CountsCellsByTheirMeans) {
  NdtMap map;
  for (const float x : {-1.5f, -0.5f, 0.5f, 1.5f}) {
    NdtCell cell;
    cell.mean = {x, 0, 0.1f};
    map.cells.push_back(cell);
  }
  EXPECT_EQ(CountCellsInBox(map, kBox), 2);
}

}  // namespace
}  // namespace fallen
