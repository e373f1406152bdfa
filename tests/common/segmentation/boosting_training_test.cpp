// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/segmentation/tree_growing.hpp"

namespace fallen {
namespace {

struct Samples {
  FeatureMatrix features;
  std::vector<std::int8_t> labels;
};

// One feature, 1 to 6, labelled + + + - - +: no single cut parts the classes.
Samples SixSamples() {
  Samples samples{FeatureMatrix(6, 1), {1, 1, 1, -1, -1, 1}};
  samples.features << 1, 2, 3, 4, 5, 6;
  return samples;
}

BoostingConfig Stumps(BoostingVariant variant, int rounds) {
  BoostingConfig config;
  config.variant = variant;
  config.rounds = rounds;
  config.max_depth = 1;
  config.min_leaf_weight = 0;
  return config;
}

// A ring in two of `feature_count` features is +1, with one label in ten flipped.
Samples Ring(int count, int feature_count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Samples samples{FeatureMatrix(count, feature_count), {}};
  for (int i = 0; i < count; ++i) {
    for (int f = 0; f < feature_count; ++f) samples.features(i, f) = uniform(random);
    const float radius = samples.features.row(i).head(2).norm();
    const bool is_ring = radius > 0.4F && radius < 0.8F;
    const bool is_flipped = random() % 10 == 0;
    samples.labels.push_back(is_ring != is_flipped ? 1 : -1);
  }
  return samples;
}

std::vector<BoostingProgress> TrainingCurve(const Samples& samples, const BoostingConfig& config) {
  std::vector<BoostingProgress> curve;
  TrainBoostedTrees(samples.features, samples.labels, {}, config,
                    [&](const BoostingProgress& progress) { curve.push_back(progress); });
  return curve;
}

// Worked by hand with the weights as exact fractions:
// round 1: cut 3.5, wrong: sample 6, error 1/6; weights become 1/10, and 1/2 for sample 6.
// round 2: cut 5.5 (Gini 0.24, the next best 0.2857), both leaves +, wrong: 4 and 5, error 1/5;
//          weights become 1/16 1/16 1/16 1/4 1/4 5/16.
// round 3: cut 5.5, - then +, wrong: 1 to 3, error 3/16.
TEST(DiscreteAdaBoost, FollowsTheHandWorkedRounds) {
  const Samples samples = SixSamples();
  const BoostedTrees model = TrainBoostedTrees(samples.features, samples.labels, {},
                                               Stumps(BoostingVariant::kDiscrete, 3));
  ASSERT_EQ(model.roots, (std::vector<std::int32_t>{0, 3, 6}));
  const double votes[] = {0.5 * std::log(5.0), 0.5 * std::log(4.0), 0.5 * std::log(13.0 / 3)};
  const double signs[][2] = {{1, -1}, {1, 1}, {-1, 1}};
  const float cuts[] = {3.5F, 5.5F, 5.5F};
  for (int t = 0; t < 3; ++t) {
    EXPECT_EQ(model.nodes[3 * t].feature, 0);
    EXPECT_EQ(model.nodes[3 * t].threshold, cuts[t]);
    EXPECT_NEAR(model.nodes[3 * t + 1].value, signs[t][0] * votes[t], 1e-6);
    EXPECT_NEAR(model.nodes[3 * t + 2].value, signs[t][1] * votes[t], 1e-6);
  }
}

TEST(DiscreteAdaBoost, HasTheHandWorkedMarginsAndTrainingError) {
  const Samples samples = SixSamples();
  const BoostingConfig config = Stumps(BoostingVariant::kDiscrete, 3);
  const BoostedTrees model = TrainBoostedTrees(samples.features, samples.labels, {}, config);
  const std::vector<float> scores = PredictScores(model, samples.features);
  const double a = 0.5 * std::log(5.0), b = 0.5 * std::log(4.0), c = 0.5 * std::log(13.0 / 3);
  for (int i : {0, 1, 2}) EXPECT_NEAR(scores[i], (a + b - c) / (a + b + c), 1e-6);
  for (int i : {3, 4}) EXPECT_NEAR(scores[i], (-a + b - c) / (a + b + c), 1e-6);
  EXPECT_NEAR(scores[5], (-a + b + c) / (a + b + c), 1e-6);

  const std::vector<BoostingProgress> curve = TrainingCurve(samples, config);
  ASSERT_EQ(curve.size(), 3U);
  EXPECT_NEAR(curve[0].training_error, 1.0 / 6, 1e-12);
  EXPECT_NEAR(curve[1].training_error, 1.0 / 6, 1e-12);
  EXPECT_EQ(curve[2].training_error, 0.0);
  // [Freund95] Theorem 6: the bound is the product of 2 sqrt(error (1 - error)).
  const double bound =
      8 * std::sqrt(1.0 / 6 * 5 / 6) * std::sqrt(0.2 * 0.8) * std::sqrt(3.0 / 16 * 13 / 16);
  EXPECT_NEAR(curve[2].exponential_loss, bound, 1e-6);
}

TEST(DiscreteAdaBoost, EndsWithAFiniteVoteWhenATreeIsFaultless) {
  Samples samples = SixSamples();
  samples.labels = {-1, -1, 1, 1, 1, 1};
  const BoostedTrees model = TrainBoostedTrees(samples.features, samples.labels, {},
                                               Stumps(BoostingVariant::kDiscrete, 10));
  EXPECT_NO_THROW(model.Validate());
  EXPECT_EQ(model.nodes[0].threshold, 2.5F);
  const std::vector<float> scores = PredictScores(model, samples.features);
  for (std::size_t i = 0; i < scores.size(); ++i)
    EXPECT_GT(scores[i] * static_cast<float>(samples.labels[i]), 0.9F);
}

TEST(RealAdaBoost, VotesHalfTheSmoothedLogOdds) {
  const Samples samples = SixSamples();
  const BoostedTrees model =
      TrainBoostedTrees(samples.features, samples.labels, {}, Stumps(BoostingVariant::kReal, 1));
  ASSERT_EQ(model.nodes.size(), 3U);
  EXPECT_EQ(model.nodes[0].threshold, 3.5F);
  EXPECT_NEAR(model.nodes[1].value, 0.5 * std::log((3 + 1) / (0 + 1.0)), 1e-6);
  EXPECT_NEAR(model.nodes[2].value, 0.5 * std::log((1 + 1) / (2 + 1.0)), 1e-6);
}

TEST(GentleAdaBoost, VotesTheMeanLabelAndReweightsByIt) {
  const Samples samples = SixSamples();
  const BoostedTrees model =
      TrainBoostedTrees(samples.features, samples.labels, {}, Stumps(BoostingVariant::kGentle, 2));
  ASSERT_EQ(model.nodes.size(), 6U);
  EXPECT_NEAR(model.nodes[1].value, 1.0, 1e-6);
  EXPECT_NEAR(model.nodes[2].value, -1.0 / 3, 1e-6);
  // Round 2: weights exp(-1) for 1 to 3, exp(-1/3) for 4 and 5, exp(1/3) for 6: cut 5.5.
  const double front = 3 * std::exp(-1.0), middle = 2 * std::exp(-1.0 / 3);
  EXPECT_EQ(model.nodes[3].threshold, 5.5F);
  EXPECT_NEAR(model.nodes[4].value, (front - middle) / (front + middle), 1e-6);
  EXPECT_NEAR(model.nodes[5].value, 1.0, 1e-6);
}

TEST(Boosting, LearningRateScalesTheVotesAndSlowsTheLoss) {
  const Samples samples = SixSamples();
  BoostingConfig config = Stumps(BoostingVariant::kGentle, 3);
  const BoostedTrees whole = TrainBoostedTrees(samples.features, samples.labels, {}, config);
  const double whole_loss = TrainingCurve(samples, config).back().exponential_loss;
  config.learning_rate = 0.25;
  const BoostedTrees quarter = TrainBoostedTrees(samples.features, samples.labels, {}, config);
  EXPECT_EQ(quarter.nodes[0], whole.nodes[0]);
  EXPECT_EQ(quarter.nodes[1].value, whole.nodes[1].value / 4);
  EXPECT_EQ(quarter.nodes[2].value, whole.nodes[2].value / 4);
  const double loss = TrainingCurve(samples, config).back().exponential_loss;
  EXPECT_LT(loss, 1);
  EXPECT_GT(loss, whole_loss);
  for (const double bad : {0.0, -1.0, 1.5, std::nan("")}) {
    config.learning_rate = bad;
    EXPECT_THROW(config.Validate(), std::invalid_argument) << bad;
  }
}

TEST(Boosting, WeightsCountLikeRepeatedSamples) {
  const Samples ring = Ring(300, 3, 3);
  std::vector<float> weights;
  Samples repeated{FeatureMatrix(0, 3), {}};
  std::vector<int> rows;
  for (int i = 0; i < 300; ++i) {
    weights.push_back(static_cast<float>(1 + i % 3));
    for (int k = 0; k <= i % 3; ++k) rows.push_back(i);
  }
  repeated.features = ring.features(rows, Eigen::all);
  for (const int i : rows) repeated.labels.push_back(ring.labels[i]);
  BoostingConfig config;
  config.rounds = 1;
  config.max_depth = 2;
  config.threshold_bins = 256;
  // More values than bins would cut at other quantiles, so they are made few.
  const auto coarse = [](FeatureMatrix m) { return (m.array() * 20).round().matrix().eval(); };
  const BoostedTrees a = TrainBoostedTrees(coarse(ring.features), ring.labels, weights, config);
  const BoostedTrees b = TrainBoostedTrees(coarse(repeated.features), repeated.labels, {}, config);
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].feature, b.nodes[i].feature);
    EXPECT_EQ(a.nodes[i].threshold, b.nodes[i].threshold);
    EXPECT_NEAR(a.nodes[i].value, b.nodes[i].value, 1e-5);
  }
}

class EveryVariant : public testing::TestWithParam<BoostingVariant> {};
INSTANTIATE_TEST_SUITE_P(Boosting, EveryVariant,
                         testing::Values(BoostingVariant::kDiscrete, BoostingVariant::kReal,
                                         BoostingVariant::kGentle),
                         [](const auto& variant) { return std::string(EnumName(variant.param)); });

TEST_P(EveryVariant, LowersTheExponentialLossInEveryRoundAndItBoundsTheError) {
  BoostingConfig config;
  config.variant = GetParam();
  config.rounds = 40;
  config.max_depth = 3;
  const std::vector<BoostingProgress> curve = TrainingCurve(Ring(3000, 5, 7), config);
  ASSERT_EQ(curve.size(), 40U);
  double before = 1;
  for (const BoostingProgress& progress : curve) {
    EXPECT_LT(progress.exponential_loss, before);
    EXPECT_LE(progress.training_error, progress.exponential_loss);
    before = progress.exponential_loss;
  }
}

TEST_P(EveryVariant, ReportsTheErrorThatPredictionHas) {
  const Samples samples = Ring(2000, 4, 8);
  BoostingConfig config;
  config.variant = GetParam();
  config.rounds = 15;
  double reported = -1;
  const BoostedTrees model =
      TrainBoostedTrees(samples.features, samples.labels, {}, config,
                        [&](const BoostingProgress& p) { reported = p.training_error; });
  EXPECT_NO_THROW(model.Validate());
  const std::vector<float> scores = PredictScores(model, samples.features);
  int wrong = 0;
  for (std::size_t i = 0; i < scores.size(); ++i)
    wrong += (scores[i] > 0) != (samples.labels[i] > 0);
  EXPECT_NEAR(reported, wrong / 2000.0, 1e-9);
}

TEST_P(EveryVariant, LearnsARingFromNoisyLabels) {
  BoostingConfig config;
  config.variant = GetParam();
  config.rounds = 60;
  const Samples train = Ring(6000, 4, 1);
  const BoostedTrees model = TrainBoostedTrees(train.features, train.labels, {}, config);
  const Samples test = Ring(4000, 4, 2);
  const std::vector<float> scores = PredictScores(model, test.features);
  int wrong = 0;
  for (std::size_t i = 0; i < scores.size(); ++i) wrong += (scores[i] > 0) != (test.labels[i] > 0);
  EXPECT_LT(wrong / 4000.0, 0.2);  // one label in ten is false by construction; always -1: 0.40
}

TEST_P(EveryVariant, IsBitIdenticalOnAnyNumberOfThreads) {
  const Samples samples = Ring(5000, 19, 4);
  BoostingConfig config;
  config.variant = GetParam();
  config.rounds = 12;
  const auto train = [&](int threads) {
    return TrainBoostedTrees(samples.features, samples.labels, {}, config, {}, threads);
  };
  const BoostedTrees alone = train(1);
  for (const int threads : {0, 2, 3, 7}) EXPECT_EQ(train(threads), alone) << threads;
}

TEST(Boosting, KeepsTheLeastWeightInEveryLeaf) {
  const Samples samples = Ring(1000, 3, 9);
  BoostingConfig config;
  config.rounds = 1;
  config.max_depth = 6;
  config.min_leaf_weight = 0.05;
  const BoostedTrees model = TrainBoostedTrees(samples.features, samples.labels, {}, config);
  ASSERT_GT(model.nodes.size(), 3U);
  std::vector<int> in_leaf(model.nodes.size());
  for (int i = 0; i < 1000; ++i) {
    std::int32_t at = 0;
    while (model.nodes[at].feature >= 0)
      at = model.nodes[at].left +
           (samples.features(i, model.nodes[at].feature) <= model.nodes[at].threshold ? 0 : 1);
    ++in_leaf[at];
  }
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].feature >= 0) continue;
    EXPECT_GE(in_leaf[n], 50);
  }
}

TEST(Boosting, VotesThePriorWhenNoFeatureTellsAnything) {
  const FeatureMatrix features = FeatureMatrix::Constant(4, 2, 3.5F);
  const std::vector<std::int8_t> labels{1, 1, 1, -1};
  BoostingConfig config;
  config.rounds = 1;
  const BoostedTrees model = TrainBoostedTrees(features, labels, {}, config);
  ASSERT_EQ(model.nodes.size(), 1U);
  EXPECT_FLOAT_EQ(model.nodes[0].value, 0.5F);
}

TEST(Boosting, RejectsBrokenSamplesAndSettings) {
  const Samples good = SixSamples();
  const auto rejects = [](const Samples& s, const std::vector<float>& weights,
                          const BoostingConfig& config = {}) {
    EXPECT_THROW(TrainBoostedTrees(s.features, s.labels, weights, config), std::invalid_argument);
  };
  Samples s = good;
  s.features(2, 0) = std::nanf("");
  rejects(s, {});
  s = good;
  s.labels.pop_back();
  rejects(s, {});
  s = good;
  s.labels[0] = 0;
  rejects(s, {});
  s = good;
  std::fill(s.labels.begin(), s.labels.end(), std::int8_t{1});
  rejects(s, {});
  std::fill(s.labels.begin(), s.labels.end(), std::int8_t{-1});
  rejects(s, {});
  rejects({FeatureMatrix(0, 1), {}}, {});
  rejects({FeatureMatrix(6, 0), good.labels}, {});
  rejects(good, {1, 1});
  rejects(good, {1, 1, 1, 1, 1, 0});
  rejects(good, {1, 1, 1, 1, 1, std::nanf("")});
  BoostingConfig config;
  config.max_depth = 0;
  rejects(good, {}, config);
  config = {};
  config.threshold_bins = 257;
  rejects(good, {}, config);
  config = {};
  config.min_leaf_weight = std::nan("");
  rejects(good, {}, config);
  config = {};
  config.rounds = 0;
  rejects(good, {}, config);
}

// The same greedy growth without histograms: every cut between two values, by the definition.
double NaiveImpurity(SplitCriterion criterion, double p, double n) {
  if (p <= 0 || n <= 0) return 0;
  return criterion == SplitCriterion::kGini ? 2 * p * n / (p + n) : 2 * std::sqrt(p * n);
}

void ExpectNaiveTree(const GrownTree& tree, std::int32_t at, const FeatureMatrix& x,
                     const std::vector<std::uint8_t>& y, const std::vector<double>& w,
                     const std::vector<int>& rows, int depth, SplitCriterion criterion) {
  double p = 0, n = 0;
  for (const int i : rows) (y[i] ? p : n) += w[i];
  EXPECT_NEAR(tree.weights[at].positive, p, 1e-12);
  EXPECT_NEAR(tree.weights[at].negative, n, 1e-12);
  double best = 1e-7 * (p + n);
  int best_feature = -1;
  for (int f = 0; f < x.cols() && depth > 0; ++f)
    for (const int i : rows) {
      double lp = 0, ln = 0, rp = 0, rn = 0;
      for (const int k : rows) (x(k, f) <= x(i, f) ? (y[k] ? lp : ln) : (y[k] ? rp : rn)) += w[k];
      if (rp + rn <= 0) continue;
      const double gain = NaiveImpurity(criterion, p, n) - NaiveImpurity(criterion, lp, ln) -
                          NaiveImpurity(criterion, rp, rn);
      if (gain > best) best = gain, best_feature = f;
    }
  const BoostedTrees::Node& node = tree.nodes[at];
  ASSERT_EQ(node.feature < 0, best_feature < 0);
  if (best_feature < 0) {
    for (const int i : rows) EXPECT_EQ(tree.leaf_indices[i], at);
    return;
  }
  // Compared by what the split gains: cuts in a gap between this node's values all part it alike.
  std::vector<int> left, right;
  double lp = 0, ln = 0, rp = 0, rn = 0;
  for (const int k : rows) {
    const bool is_left = x(k, node.feature) <= node.threshold;
    (is_left ? left : right).push_back(k);
    (is_left ? (y[k] ? lp : ln) : (y[k] ? rp : rn)) += w[k];
  }
  EXPECT_NEAR(NaiveImpurity(criterion, p, n) - NaiveImpurity(criterion, lp, ln) -
                  NaiveImpurity(criterion, rp, rn),
              best, 1e-9);
  ExpectNaiveTree(tree, node.left, x, y, w, left, depth - 1, criterion);
  ExpectNaiveTree(tree, node.left + 1, x, y, w, right, depth - 1, criterion);
}

TEST(GrowTree, FindsTheSplitsOfAnExhaustiveSearch) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const SplitCriterion criterion : {SplitCriterion::kGini, SplitCriterion::kExponentialLoss})
    for (int trial = 0; trial < 5; ++trial) {
      FeatureMatrix x(120, 11);
      std::vector<std::uint8_t> y(120);
      std::vector<double> w(120);
      std::vector<int> rows(120);
      for (int i = 0; i < 120; ++i) {
        for (int f = 0; f < x.cols(); ++f) x(i, f) = static_cast<float>(uniform(random));
        y[i] = uniform(random) < 0.2 + 0.6 * x(i, 3);
        w[i] = uniform(random) / 60;
        rows[i] = i;
      }
      const BinnedFeatures binned = BinFeatures(x, 256, 1);
      const GrownTree tree = GrowTree(binned, y, w, {3, 0.0, criterion}, 1);
      ExpectNaiveTree(tree, 0, x, y, w, rows, 3, criterion);
    }
}

}  // namespace
}  // namespace fallen
