// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/baseline_detector.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fallen/baseline/layer_features.hpp"
#include "tests/tools/common/lying_scene.hpp"

namespace fallen {
namespace {

using lying_scene::With;

// Takes what is at most 0.3 m high for a person: the block, not the wall.
BaselineModel LowIsAPerson() {
  BaselineModel model;
  const int height = LayerFeatureCount(model.config) - kClusterGeometryFeatures + 3;
  model.trees.feature_count = LayerFeatureCount(model.config);
  model.trees.roots = {0};
  model.trees.nodes = {{height, 0.3F, 1, 0}, {-1, 0, 0, 1}, {-1, 0, 0, -1}};
  model.calibration.slope = 3;
  model.calibration.operating_points = {{0.5, 0.01, 0.1}};
  return model;
}

Decision Detect(const Frame& frame) {
  return BaselineDetector(LowIsAPerson(), {}, {}).Detect(frame);
}

std::vector<PersonHypothesis> Persons(const Decision& decision) {
  std::vector<PersonHypothesis> persons;
  for (const PersonHypothesis& hypothesis : decision.hypotheses)
    if (hypothesis.is_person) persons.push_back(hypothesis);
  return persons;
}

TEST(BaselineDetector, FindsTheBlockWhereItLies) {
  for (const double robot_x : {0.0, 0.3}) {
    const Decision decision = Detect(lying_scene::Render(0, robot_x, With::kPerson));
    EXPECT_EQ(decision.frame, MapFrame::kWorld);
    const auto persons = Persons(decision);
    ASSERT_EQ(persons.size(), 1u);
    const OrientedBox block = lying_scene::Person();
    EXPECT_TRUE(block.Contains(persons[0].centroid)) << persons[0].centroid.transpose();
    // Top and front are seen: the length to within two leaves.
    EXPECT_NEAR(persons[0].box.size.x(), block.size.y(), 0.06);
    EXPECT_EQ(persons[0].mean_score, 1);
    EXPECT_DOUBLE_EQ(persons[0].probability, LowIsAPerson().calibration.Probability(1));
  }
}

TEST(BaselineDetector, FindsNobodyInAnEmptyRoom) {
  const Decision decision = Detect(lying_scene::Render(0, 0, With::kNobody));
  EXPECT_FALSE(decision.hypotheses.empty());  // the wall
  EXPECT_TRUE(Persons(decision).empty());
}

TEST(BaselineDetector, WithoutAPoseTheFloorBelowTheCameraIsTheOrigin) {
  Frame frame = lying_scene::Render(0, 0.3, With::kPerson);
  frame.T_world_robot.reset();
  const Decision decision = Detect(frame);
  EXPECT_EQ(decision.frame, MapFrame::kLevel);
  const auto persons = Persons(decision);
  ASSERT_EQ(persons.size(), 1u);
  EXPECT_TRUE(lying_scene::Person().Contains(persons[0].centroid + Eigen::Vector3d(0.3, 0, 0)));
}

TEST(BaselineDetector, WithoutAFloorThereIsNobody) {
  Frame frame = lying_scene::Render(0, 0, With::kPerson);
  std::fill(frame.image.depth.begin(), frame.image.depth.end(), std::uint16_t{0});
  frame.T_robot_camera.reset();
  const Decision decision = Detect(frame);
  EXPECT_EQ(decision.frame, MapFrame::kCamera);
  EXPECT_TRUE(decision.hypotheses.empty());
}

TEST(BaselineDetector, OfNeighboursTheLikelierIsKept) {
  DescribedClusters clusters;
  clusters.frame = MapFrame::kWorld;
  const BaselineModel model = LowIsAPerson();
  clusters.features = FeatureMatrix::Zero(3, model.trees.feature_count);
  clusters.features.row(0).setConstant(1);  // high: no person
  clusters.centroids = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}};
  clusters.boxes.resize(3);
  clusters.point_counts = {10, 20, 30};
  const Decision decision = JudgeClusters(clusters, model, {.min_separation_m = 1.2});
  ASSERT_EQ(decision.hypotheses.size(), 2u);
  EXPECT_EQ(decision.hypotheses[0].cell_count, 20);
  EXPECT_EQ(decision.hypotheses[1].cell_count, 30);
  EXPECT_EQ(JudgeClusters(clusters, model, {.min_separation_m = 0.5}).hypotheses.size(), 3u);
}

TEST(BaselineDetector, RefusesAModelThatDoesNotFit) {
  BaselineModel model = LowIsAPerson();
  model.config.normal_bins = 3;
  EXPECT_THROW(BaselineDetector(model, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
