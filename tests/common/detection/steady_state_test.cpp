// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

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

// Nobody is found, so that every stage runs on the person's cells up to the groups of them.
DetectorConfig NoClusterIsLargeEnough(bool accumulate) {
  DetectorConfig config;
  config.ground.method = GroundMethod::kMounting;
  config.ndt.accumulate = accumulate;
  config.segmentation.min_cluster_cells = std::numeric_limits<int>::max();
  return config;
}

BackgroundSubtractor EmptyRoom(const DetectorConfig& config) {
  NdtMapper mapper(config.ndt);
  EnvironmentMap environment;
  environment.cells =
      UpdateMap(mapper, lying_scene::Render(0, 0, lying_scene::With::kNobody), config.ground).cells;
  return BackgroundSubtractor(environment, config.background);
}

void ExpectNoHeapCallInTheSteadyState(const DetectorConfig& config,
                                      BackgroundSubtractor background) {
  if (!test::HeapCalls()) GTEST_SKIP() << "the sanitizer has the heap for itself";
  std::vector<Frame> frames = Drive();
  Detector detector(PlainModel(), config, std::move(background));
  FrameResult result;
  std::int64_t utime = 0;
  const auto drive = [&] {
    for (Frame& frame : frames) {
      frame.utime = utime += kPeriod_us;
      detector.Detect(frame, result);
    }
  };
  for (int round = 0; round < kWarmUpRounds; ++round) drive();
  const std::size_t before = *test::HeapCalls();
  for (int round = 0; round < kCountedRounds; ++round) drive();
  EXPECT_EQ(*test::HeapCalls() - before, 0u);
  EXPECT_GT(result.segmented.cells.size(), 50u) << "there is something to see";
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
  ExpectNoHeapCallInTheSteadyState(NoClusterIsLargeEnough(false), BackgroundSubtractor());
}

TEST(SteadyState, TakesNoMemoryWithAccumulationAndBackgroundSubtraction) {
  const DetectorConfig config = NoClusterIsLargeEnough(true);
  ExpectNoHeapCallInTheSteadyState(config, EmptyRoom(config));
}

}  // namespace
}  // namespace fallen
