// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "fallen/classification/cluster_features.hpp"
#include "fallen/detection/detector.hpp"
#include "heap_calls.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"

namespace fallen {
namespace {

constexpr int kWarmUpRounds = 8;
constexpr int kCountedRounds = 3;
constexpr std::int64_t kPeriod_us = 100000;

// A robot that drives 6 cm forth and back before somebody who lies there.
std::vector<Frame> Drive() {
  std::vector<Frame> frames;
  for (const double x : {0.0, 0.02, 0.04, 0.06, 0.04, 0.02})
    frames.push_back(lying_scene::Render(0, x, lying_scene::With::kPerson));
  return frames;
}

DetectorConfig MountedCamera(bool accumulate) {
  DetectorConfig config;
  config.ground.method = GroundMethod::kMounting;
  config.ndt.accumulate = accumulate;
  return config;
}

BackgroundSubtractor EmptyRoom(const DetectorConfig& config) {
  NdtMapper mapper(config.ndt);
  EnvironmentMap environment;
  environment.cells =
      UpdateMap(mapper, lying_scene::Render(0, 0, lying_scene::With::kNobody), config.ground).cells;
  return BackgroundSubtractor(environment, config.background);
}

// Judges clusters by trees and a network, and so their parts too, as the shipped model does.
Model ModelThatJudgesParts() {
  Model model = PlainModel();
  model.clusters.trees.feature_count =
      ClusterFeatureCount(model.clusters.iron, model.clusters.codebook.rows());
  model.clusters.trees.roots = {0};
  model.clusters.trees.nodes = {{0, 4, 1, 0}, {-1, 0, 0, 0.5F}, {-1, 0, 0, 1}};
  FeatureNetwork& network = model.clusters.network;
  const int features = model.clusters.trees.feature_count;
  network.mean.setZero(features);
  network.scale.setOnes(features);
  network.layers = {{FeatureMatrix::Constant(features, 128, 0.01F), Eigen::RowVectorXf::Zero(128)},
                    {FeatureMatrix::Constant(128, 1, 0.01F), Eigen::RowVectorXf::Zero(1)}};
  model.clusters.network_share = 0.1;
  return model;
}

void ExpectNoHeapCallInTheSteadyState(const DetectorConfig& config, BackgroundSubtractor background,
                                      Model model) {
  if (!test::HeapCalls()) GTEST_SKIP() << "the sanitizer has the heap for itself";
  std::vector<Frame> frames = Drive();
  Detector detector(std::move(model), config, std::move(background));
  FrameResult result;
  std::int64_t utime = 0;
  const auto drive = [&] {
    std::size_t hypotheses = 0;
    for (Frame& frame : frames) {
      frame.utime = utime += kPeriod_us;
      detector.Detect(frame, result);
      hypotheses += result.decision.hypotheses.size();
    }
    return hypotheses;
  };
  for (int round = 0; round < kWarmUpRounds; ++round) drive();
  const std::size_t before = *test::HeapCalls();
  std::size_t hypotheses = 0;
  for (int round = 0; round < kCountedRounds; ++round) hypotheses += drive();
  EXPECT_EQ(*test::HeapCalls() - before, 0u);
  EXPECT_GE(hypotheses, kCountedRounds * frames.size()) << "clusters are made and judged";
  ASSERT_FALSE(result.segmented.clusters.empty());
  EXPECT_GE(result.segmented.clusters[0].cells.size(), 80u) << "large enough for parts";
}

TEST(SteadyState, HeapCallsAreCounted) {
  if (!test::HeapCalls()) GTEST_SKIP() << "the sanitizer has the heap for itself";
  const std::size_t before = *test::HeapCalls();
  EXPECT_EQ(std::make_unique<std::vector<int>>(7)->size(), 7u);
  EXPECT_GE(*test::HeapCalls() - before, 2u);
  const std::size_t before_eigen = *test::HeapCalls();
  EXPECT_EQ(IronDescriptors::Matrix(3, 4).size(), 12);
  EXPECT_GE(*test::HeapCalls() - before_eigen, 1u);
}

TEST(SteadyState, TakesNoMemoryWithAFreshMapEveryFrame) {
  const DetectorConfig config = MountedCamera(false);
  ExpectNoHeapCallInTheSteadyState(config, BackgroundSubtractor(), ModelThatJudgesParts());
  ExpectNoHeapCallInTheSteadyState(config, BackgroundSubtractor(), PlainModel());
}

TEST(SteadyState, TakesNoMemoryWithAccumulationAndBackgroundSubtraction) {
  const DetectorConfig config = MountedCamera(true);
  ExpectNoHeapCallInTheSteadyState(config, EmptyRoom(config), ModelThatJudgesParts());
}

}  // namespace
}  // namespace fallen
