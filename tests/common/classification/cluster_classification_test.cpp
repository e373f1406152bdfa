// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_classification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "fallen/classification/cluster_features.hpp"
#include "fallen/classification/soft_threshold_encoding.hpp"

namespace fallen {
namespace {

Codebook RandomUnits(int rows, int columns, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(0, 1);
  Codebook units = Codebook::NullaryExpr(rows, columns, [&] { return uniform(random); });
  units.rowwise().normalize();
  return units;
}

ClusterModel SmallModel() {
  std::mt19937 random(1);
  ClusterModel model;
  model.codebook = RandomUnits(6, model.iron.dimension(), random);
  model.gaussian =
      MahalanobisModel(Eigen::VectorXd::Constant(6, 0.05), Eigen::MatrixXd::Identity(6, 6) * 1e-4);
  model.calibration.slope = 2;
  model.calibration.intercept = 5;
  model.calibration.operating_points = {{0.1, 1.0, 0.0}, {0.6, 0.01, 0.2}};
  return model;
}

// `clusters` clusters of `each` cells that lie along x, `apart` metres from each other.
SegmentedMap MapOf(int clusters, int each, float apart = 2) {
  std::mt19937 random(2);
  SegmentedMap map;
  map.frame = MapFrame::kWorld;
  for (int c = 0; c < clusters; ++c) {
    CellCluster cluster;
    for (int i = 0; i < each; ++i) {
      cluster.cells.push_back(static_cast<std::int32_t>(map.cells.size()));
      const Eigen::Vector3f mean(apart * static_cast<float>(c), 0.05F * static_cast<float>(i),
                                 0.1F);
      map.cells.push_back({mean, 0.25F * static_cast<float>(1 + i % 2), c});
      map.members.emplace_back().mean = mean;
    }
    cluster.descriptors = RandomUnits(each, map.iron.dimension(), random);
    map.clusters.push_back(cluster);
  }
  return map;
}

TEST(ClassifyClusters, JudgesEveryClusterBestFirst) {
  const ClusterModel model = SmallModel();
  EXPECT_NO_THROW(model.Validate());
  const SegmentedMap map = MapOf(5, 8);
  const Decision decision = ClassifyClusters(map, model);
  EXPECT_EQ(decision.frame, MapFrame::kWorld);
  EXPECT_EQ(decision.min_probability, 0.6);
  ASSERT_EQ(decision.hypotheses.size(), 5U);
  double before = 1;
  for (const PersonHypothesis& hypothesis : decision.hypotheses) {
    EXPECT_LE(hypothesis.probability, before);
    before = hypothesis.probability;
    const auto index = static_cast<std::size_t>(hypothesis.centroid.x() / 2 + 0.5);
    const CellCluster& cluster = map.clusters[index];
    const double distance =
        model.gaussian.Distance(EncodeCluster(cluster.descriptors, model.codebook, model.alpha));
    EXPECT_EQ(hypothesis.mahalanobis_distance, distance);
    EXPECT_EQ(hypothesis.probability, model.calibration.Probability(MahalanobisEvidence(distance)));
    EXPECT_EQ(hypothesis.is_person, hypothesis.probability >= 0.6);
    EXPECT_NEAR(hypothesis.centroid.y(), 0.05 * 3.5, 1e-6);
    EXPECT_NEAR(hypothesis.mean_score, 0.375, 1e-12);
    EXPECT_EQ(hypothesis.cell_count, 8);
    EXPECT_EQ(hypothesis.box, FitUprightBox(map, cluster));
  }
}

TEST(ClassifyClusters, TakesTheThresholdOfTheWantedRate) {
  const ClusterModel model = SmallModel();
  const Decision loose = ClassifyClusters(MapOf(5, 8), model, {.false_positives_per_frame = 2});
  EXPECT_EQ(loose.min_probability, 0.1);
  for (const PersonHypothesis& hypothesis : loose.hypotheses)
    EXPECT_EQ(hypothesis.is_person, hypothesis.probability >= 0.1);
}

TEST(ClassifyClusters, KeepsTheOrderOfEqualClusters) {
  SegmentedMap map = MapOf(4, 3);
  for (CellCluster& cluster : map.clusters) cluster.descriptors = map.clusters[0].descriptors;
  const Decision decision = ClassifyClusters(map, SmallModel());
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(decision.hypotheses[c].centroid.x(), 2 * c, 1e-6);
}

TEST(ClassifyClusters, KeepsOnlyTheBestOfClustersThatLieTogether) {
  const SegmentedMap map = MapOf(3, 8, 0.8F);
  const Decision all = ClassifyClusters(map, SmallModel(), {.min_separation_m = 0});
  ASSERT_EQ(all.hypotheses.size(), 3U);
  const Decision apart = ClassifyClusters(map, SmallModel());  // 0.8 m and 1.6 m apart
  ASSERT_FALSE(apart.hypotheses.empty());
  EXPECT_EQ(apart.hypotheses[0], all.hypotheses[0]);
  const auto distance = [](const PersonHypothesis& a, const PersonHypothesis& b) {
    return (a.centroid - b.centroid).norm();
  };
  for (const PersonHypothesis& a : apart.hypotheses)
    for (const PersonHypothesis& b : apart.hypotheses) EXPECT_TRUE(a == b || distance(a, b) >= 1.2);
  EXPECT_LT(apart.hypotheses.size(), 3U);
}

// A model whose trees say that clusters higher than 0.15 m are persons.
ClusterModel ModelWithTrees() {
  ClusterModel model = SmallModel();
  model.trees.feature_count = ClusterFeatureCount(model.iron, 6);
  model.trees.roots = {0};
  model.trees.nodes = {{4, 0.15F, 1, 0}, {-1, 0, 0, -1}, {-1, 0, 0, 1}};
  return model;
}

TEST(ClassifyClusters, LetsTheTreesDecideWhereThereAreSome) {
  const ClusterModel model = ModelWithTrees();
  EXPECT_NO_THROW(model.Validate());
  SegmentedMap map = MapOf(2, 8);
  map.ground.status = GroundStatus::kOk;
  map.ground.plane = {Eigen::Vector3d::UnitZ(), 0};
  map.cells[0].mean.z() = 0.3F;
  const Decision decision = ClassifyClusters(map, model);
  ASSERT_EQ(decision.hypotheses.size(), 2U);
  EXPECT_NEAR(decision.hypotheses[0].centroid.x(), 0, 1e-6);
  EXPECT_EQ(decision.hypotheses[0].probability, model.calibration.Probability(1));
  EXPECT_EQ(decision.hypotheses[1].probability, model.calibration.Probability(-1));
}

// Trees, and a network that sees the greatest height: log-odds of ten for each metre above 0.2 m.
ClusterModel ModelWithNetwork() {
  ClusterModel model = ModelWithTrees();
  FeatureNetwork& network = model.network;
  network.mean.setZero(model.trees.feature_count);
  network.mean[4] = 0.2F;
  network.scale.setOnes(model.trees.feature_count);
  network.layers = {
      {FeatureMatrix::Zero(model.trees.feature_count, 1), Eigen::RowVectorXf::Zero(1)}};
  network.layers[0].weights(4, 0) = 10;
  model.network_share = 0.25;
  return model;
}

TEST(ClassifyClusters, TheNetworkHasItsShareOfTheEvidence) {
  ClusterModel model = ModelWithNetwork();
  EXPECT_NO_THROW(model.Validate());
  SegmentedMap map = MapOf(2, 8);
  map.ground.status = GroundStatus::kOk;
  map.ground.plane = {Eigen::Vector3d::UnitZ(), 0};
  map.cells[0].mean.z() = 0.3F;
  const double high = std::tanh(1.0 / 16), low = std::tanh(-1.0 / 16);  // 0.3 m and 0.1 m
  const auto expect = [&](double best, double other) {
    const Decision decision = ClassifyClusters(map, model);
    ASSERT_EQ(decision.hypotheses.size(), 2U);
    EXPECT_NEAR(decision.hypotheses[0].probability, model.calibration.Probability(best), 1e-6);
    EXPECT_NEAR(decision.hypotheses[1].probability, model.calibration.Probability(other), 1e-6);
  };
  expect(0.75 + 0.25 * high, -0.75 + 0.25 * low);
  model.network_share = 1;
  expect(high, low);
  model.network_share = 0;
  expect(1, -1);
}

// Cells along y from 0 to 0.35 m, of which the first two score ten times as high as the others.
SegmentedMap PersonBesideAThing() {
  SegmentedMap map = MapOf(1, 8);
  map.ground.status = GroundStatus::kOk;
  map.ground.plane = {Eigen::Vector3d::UnitZ(), 0};
  for (std::size_t i = 0; i < 8; ++i) map.cells[i].score = i < 2 ? 1.0F : 0.1F;
  return map;
}

TEST(ClassifyClusters, PlacesWhatTreesJudgeWhereTheScoreIs) {
  const Decision decision = ClassifyClusters(PersonBesideAThing(), ModelWithTrees());
  ASSERT_EQ(decision.hypotheses.size(), 1U);
  const double expected = 0.05 * (0 + 1 + 0.1 * (2 + 3 + 4 + 5 + 6 + 7)) / (2 + 0.6);
  EXPECT_NEAR(decision.hypotheses[0].centroid.y(), expected, 1e-6);
}

TEST(ClassifyClusters, PlacesWhatTheDistanceJudgesInTheMiddle) {
  const Decision decision = ClassifyClusters(PersonBesideAThing(), SmallModel());
  ASSERT_EQ(decision.hypotheses.size(), 1U);
  EXPECT_NEAR(decision.hypotheses[0].centroid.y(), 0.05 * 3.5, 1e-6);
}

TEST(ClassifyClusters, NoScoreAtAllStillGivesAPlace) {
  SegmentedMap map = PersonBesideAThing();
  for (ScoredCell& cell : map.cells) cell.score = 0;
  const Decision decision = ClassifyClusters(map, ModelWithTrees());
  ASSERT_EQ(decision.hypotheses.size(), 1U);
  EXPECT_NEAR(decision.hypotheses[0].centroid.y(), 0.05 * 3.5, 1e-6);
}

TEST(ClassifyClusters, JudgesPartsToo) {
  ClusterModel model = ModelWithTrees();
  // Shorter than 2.5 m is a person.
  model.trees.nodes = {{21, 2.5F, 1, 0}, {-1, 0, 0, 1}, {-1, 0, 0, -1}};
  SegmentedMap map = MapOf(1, 100);  // 5 m long
  map.ground.status = GroundStatus::kOk;
  map.ground.plane = {Eigen::Vector3d::UnitZ(), 0};
  const Decision decision = ClassifyClusters(map, model);
  ASSERT_FALSE(decision.hypotheses.empty());
  EXPECT_EQ(decision.hypotheses[0].probability, model.calibration.Probability(1));
  EXPECT_LT(decision.hypotheses[0].box.size.x(), 2.6);
  EXPECT_EQ(decision.hypotheses[0].cell_count, 50);

  EXPECT_EQ(decision.hypotheses.size(), 2U);  // 2.5 m apart: two persons

  for (ScoredCell& scored : map.cells) scored.mean.y() *= 0.6F;
  const Decision of_one = ClassifyClusters(map, model);  // upper body and legs, 1.5 m apart
  ASSERT_EQ(of_one.hypotheses.size(), 1U);
  EXPECT_EQ(of_one.hypotheses[0].cell_count, 50);

  model.trees = {};  // the paper judges whole clusters
  ASSERT_EQ(ClassifyClusters(map, model).hypotheses.size(), 1U);
  EXPECT_EQ(ClassifyClusters(map, model).hypotheses[0].cell_count, 100);
}

TEST(ClassifyClusters, FindsNobodyByTreesWithoutAFloor) {
  const ClusterModel model = ModelWithTrees();
  SegmentedMap map = MapOf(2, 8);
  map.cells[0].mean.z() = 0.3F;
  for (const PersonHypothesis& hypothesis : ClassifyClusters(map, model).hypotheses)
    EXPECT_EQ(hypothesis.probability, model.calibration.Probability(-1));
}

TEST(ClassifyClusters, DecidesFramesWithoutClusters) {
  EXPECT_TRUE(ClassifyClusters(MapOf(0, 0), SmallModel()).hypotheses.empty());
}

TEST(ClassifyClusters, RejectsOtherDescriptorsAndSettings) {
  SegmentedMap map = MapOf(1, 4);
  map.iron.radius_m = 0.4;
  EXPECT_THROW(ClassifyClusters(map, SmallModel()), std::invalid_argument);
  EXPECT_THROW(ClassifyClusters(MapOf(1, 4), SmallModel(), {.false_positives_per_frame = -1}),
               std::invalid_argument);
  EXPECT_THROW(ClassifyClusters(MapOf(1, 4), SmallModel(), {.min_separation_m = -1}),
               std::invalid_argument);
  ClusterModel uncalibrated = SmallModel();
  uncalibrated.calibration.operating_points.clear();
  EXPECT_THROW(ClassifyClusters(MapOf(1, 4), uncalibrated), std::invalid_argument);
}

TEST(ClusterModel, ValidateRejectsPartsThatDoNotFit) {
  const auto rejects = [](auto&& change) {
    ClusterModel model = SmallModel();
    change(model);
    EXPECT_THROW(model.Validate(), std::invalid_argument);
  };
  rejects([](auto& m) { m.codebook.resize(0, 48); });
  rejects([](auto& m) { m.codebook.conservativeResize(6, 40); });
  rejects([](auto& m) { m.codebook.row(2) *= 2; });
  rejects([](auto& m) { m.codebook(2, 2) = std::nanf(""); });
  rejects([](auto& m) { m.codebook.conservativeResize(5, 48); });
  rejects([](auto& m) { m.alpha = 1; });
  rejects([](auto& m) { m.alpha = std::nan(""); });
  rejects([](auto& m) { m.gaussian = {}; });
  rejects([](auto& m) { m.calibration.slope = -1; });
  rejects([](auto& m) { m.iron.distance_bins = 0; });
  rejects([](auto& m) { m.trees = ModelWithTrees().trees, m.trees.feature_count = 5; });
  rejects([](auto& m) { m.network_share = -0.1; });
  rejects([](auto& m) { m.network_share = std::nan(""); });
  rejects([](auto& m) { m = ModelWithNetwork(), m.trees = {}; });
  rejects([](auto& m) { m = ModelWithNetwork(), m.network.layers[0].bias[0] = std::nanf(""); });
  rejects([](auto& m) {
    m = ModelWithNetwork();
    m.network.mean.setZero(5), m.network.scale.setOnes(5);
    m.network.layers[0].weights.setZero(5, 1);
  });
}

}  // namespace
}  // namespace fallen
