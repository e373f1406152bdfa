// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/boosted_trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/support/simd_levels.hpp"

namespace fallen {
namespace {

using Node = BoostedTrees::Node;

// x0 <= 1 ? -0.5 : (x1 <= 2 ? 0.25 : 1), and a lone leaf that votes -1.
BoostedTrees TwoTrees() {
  BoostedTrees model;
  model.feature_count = 2;
  model.roots = {0, 5};
  model.nodes = {Node{0, 1.0F, 1, 0},   Node{-1, 0, 0, -0.5F}, Node{1, 2.0F, 3, 0},
                 Node{-1, 0, 0, 0.25F}, Node{-1, 0, 0, 1.0F},  Node{-1, 0, 0, -1.0F}};
  return model;
}

FeatureMatrix Row(float x0, float x1) {
  FeatureMatrix row(1, 2);
  row << x0, x1;
  return row;
}

float ScoreOf(const BoostedTrees& model, float x0, float x1) {
  return PredictScores(model, Row(x0, x1)).at(0);
}

// Random trees of every shape up to `max_depth`, children after their parents.
BoostedTrees RandomTrees(int trees, int features, int max_depth, std::mt19937& random) {
  BoostedTrees model;
  model.feature_count = features;
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int t = 0; t < trees; ++t) {
    std::vector<std::pair<std::int32_t, int>> open{
        {static_cast<std::int32_t>(model.nodes.size()), 0}};
    model.roots.push_back(open[0].first);
    model.nodes.emplace_back();
    while (!open.empty()) {
      const auto [at, depth] = open.back();
      open.pop_back();
      if (depth == max_depth || random() % 4 == 0) {
        model.nodes[at].value = uniform(random);
        continue;
      }
      const auto left = static_cast<std::int32_t>(model.nodes.size());
      model.nodes[at] = {static_cast<std::int32_t>(random() % features), uniform(random), left, 0};
      model.nodes.resize(model.nodes.size() + 2);
      open.push_back({left, depth + 1});
      open.push_back({left + 1, depth + 1});
    }
  }
  return model;
}

// The definition, walked one node at a time.
double LargestVote(const BoostedTrees& model, std::int32_t at) {
  const Node& node = model.nodes[at];
  if (node.feature < 0) return std::abs(node.value);
  return std::max(LargestVote(model, node.left), LargestVote(model, node.left + 1));
}

double DefinedScore(const BoostedTrees& model, const Eigen::RowVectorXf& x) {
  double sum = 0;
  double largest = 0;
  for (std::int32_t at : model.roots) {
    largest += LargestVote(model, at);
    while (model.nodes[at].feature >= 0)
      at = model.nodes[at].left + (x[model.nodes[at].feature] <= model.nodes[at].threshold ? 0 : 1);
    sum += model.nodes[at].value;
  }
  return sum / largest;
}

TEST(PredictScores, DividesTheSumOfVotesByTheLargestPossible) {
  const BoostedTrees model = TwoTrees();  // largest: 1 + 1
  EXPECT_FLOAT_EQ(ScoreOf(model, 0, 0), -0.75F);
  EXPECT_FLOAT_EQ(ScoreOf(model, 1.5F, 2), -0.375F);
  EXPECT_FLOAT_EQ(ScoreOf(model, 1.5F, 2.5F), 0.0F);
}

TEST(PredictScores, SendsAValueOnTheThresholdLeft) {
  EXPECT_FLOAT_EQ(ScoreOf(TwoTrees(), 1.0F, 9), -0.75F);
  EXPECT_FLOAT_EQ(ScoreOf(TwoTrees(), std::nextafter(1.0F, 2.0F), 9), 0.0F);
}

TEST(PredictScores, AgreesWithTheDefinitionOnRandomTrees) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (const int rows : {1, 7, 8, 9, 250}) {
    const BoostedTrees model = RandomTrees(40, 6, rows == 9 ? 13 : 7, random);
    model.Validate();
    FeatureMatrix features(rows, 6);
    for (Eigen::Index i = 0; i < features.size(); ++i) features.data()[i] = uniform(random);
    const std::vector<float> scores = PredictScores(model, features);
    ASSERT_EQ(scores.size(), static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) {
      // Rounding of one float.
      EXPECT_NEAR(scores[i], DefinedScore(model, features.row(i)), 1e-7);
      EXPECT_LE(std::abs(scores[i]), 1.0F);
    }
  }
}

TEST(PredictScores, GivesARowTheSameBitsInAnyCompany) {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const BoostedTrees model = RandomTrees(50, 4, 7, random);
  FeatureMatrix features(19, 4);
  for (Eigen::Index i = 0; i < features.size(); ++i) features.data()[i] = uniform(random);
  const std::vector<float> together = PredictScores(model, features);
  for (int i = 0; i < 19; ++i) EXPECT_EQ(PredictScores(model, features.row(i))[0], together[i]);
}

TEST(PredictScores, GivesTheSameBitsAtEverySimdLevel) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (const int max_depth : {1, 4, 5, 7}) {
    const BoostedTrees model = RandomTrees(60, 13, max_depth, random);
    FeatureMatrix features(101, 13);
    for (Eigen::Index i = 0; i < features.size(); ++i) features.data()[i] = uniform(random);
    for (Eigen::Index i = 0; i < 40; ++i) {  // values on thresholds
      const Node& node = model.nodes[random() % model.nodes.size()];
      if (node.feature >= 0) features(i, node.feature) = node.threshold;
    }
    std::vector<float> portable;
    test::AtEverySimdLevel([&](SimdLevel level) {
      const std::vector<float> scores = PredictScores(model, features);
      if (level == SimdLevel::kPortable) portable = scores;
      EXPECT_EQ(scores, portable) << "level " << static_cast<int>(level);
    });
  }
}

TEST(PredictScores, TakesNoRowsAndModelsThatDoNotVote) {
  EXPECT_TRUE(PredictScores(TwoTrees(), FeatureMatrix(0, 2)).empty());
  BoostedTrees silent;
  silent.feature_count = 2;
  EXPECT_EQ(ScoreOf(silent, 1, 1), 0.0F);
  silent.roots = {0};
  silent.nodes = {Node{}};
  EXPECT_EQ(ScoreOf(silent, 1, 1), 0.0F);
}

TEST(PredictScores, RejectsOtherColumnsAndValuesThatAreNotFinite) {
  EXPECT_THROW(PredictScores(TwoTrees(), FeatureMatrix::Zero(3, 3)), std::invalid_argument);
  EXPECT_THROW(ScoreOf(TwoTrees(), std::nanf(""), 0), std::invalid_argument);
  EXPECT_THROW(ScoreOf(TwoTrees(), 0, std::numeric_limits<float>::infinity()),
               std::invalid_argument);
}

TEST(BoostedTreesValidate, RejectsWhatEvaluationCouldNotSurvive) {
  EXPECT_NO_THROW(TwoTrees().Validate());
  const auto broken = [](auto&& change) {
    BoostedTrees model = TwoTrees();
    change(model);
    return model;
  };
  const auto rejects = [](const BoostedTrees& model) {
    EXPECT_THROW(model.Validate(), std::invalid_argument);
  };
  rejects(broken([](auto& m) { m.feature_count = 0; }));
  rejects(broken([](auto& m) { m.roots[1] = 6; }));
  rejects(broken([](auto& m) { m.roots[1] = -1; }));
  rejects(broken([](auto& m) { m.nodes[0].feature = 2; }));
  rejects(broken([](auto& m) { m.nodes[0].feature = -2; }));
  rejects(broken([](auto& m) { m.nodes[0].left = 0; }));  // leads to itself
  rejects(broken([](auto& m) { m.nodes[2].left = 1; }));  // leads back
  rejects(broken([](auto& m) { m.nodes[2].left = 5; }));  // the right child is past the end
  rejects(broken([](auto& m) { m.nodes[2].left = std::numeric_limits<std::int32_t>::max(); }));
  rejects(broken([](auto& m) { m.nodes[1].value = std::nanf(""); }));
  rejects(broken([](auto& m) { m.nodes[0].threshold = std::numeric_limits<float>::infinity(); }));
}

}  // namespace
}  // namespace fallen
