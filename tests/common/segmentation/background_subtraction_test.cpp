// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/segmentation/background_subtraction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "flat_cell.hpp"

namespace fallen {
namespace {

NdtMap WorldMap(std::vector<NdtCell> cells) {
  NdtMap map;
  map.frame = MapFrame::kWorld;
  map.cells = std::move(cells);
  return map;
}

// Whether a cell counts as background that lies `distance_m` from a lone environment cell, their
// normals `degrees` apart.
bool IsBackground(double distance_m, double degrees, const BackgroundConfig& config = {}) {
  const double angle = degrees * std::numbers::pi / 180;
  const Eigen::Vector3f tilted(static_cast<float>(std::sin(angle)), 0,
                               static_cast<float>(std::cos(angle)));
  const BackgroundSubtractor subtractor({0.05, {FlatCell({1, 2, 3})}}, config);
  const Eigen::Vector3f mean(1, 2 + static_cast<float>(distance_m), 3);
  const ForegroundMap result = subtractor.Subtract(WorldMap({FlatCell(mean, tilted)}));
  EXPECT_EQ(result.status, BackgroundStatus::kSubtracted);
  return result.is_foreground.at(0) == 0;
}

TEST(BackgroundSubtractor, GrantsBothThresholdsToParallelNormals) {
  EXPECT_TRUE(IsBackground(0.079, 0));
  EXPECT_FALSE(IsBackground(0.081, 0));
  EXPECT_TRUE(IsBackground(0.079, 180));  // a normal has no sign
  EXPECT_FALSE(IsBackground(0.081, 180));
}

TEST(BackgroundSubtractor, GrantsOnlyTheStaticThresholdToPerpendicularNormals) {
  EXPECT_TRUE(IsBackground(0.029, 90));
  EXPECT_FALSE(IsBackground(0.031, 90));
}

TEST(BackgroundSubtractor, GrantsAShareOfTheDynamicThresholdInBetween) {
  EXPECT_TRUE(IsBackground(0.0545, 45));
  EXPECT_FALSE(IsBackground(0.0555, 45));
  EXPECT_TRUE(IsBackground(0.0545, 135));
  const BackgroundConfig config{.static_threshold_m = 0.01, .dynamic_threshold_m = 0.09};
  EXPECT_TRUE(IsBackground(0.0695, 30, config));
  EXPECT_FALSE(IsBackground(0.0705, 30, config));
}

TEST(BackgroundSubtractor, AgreesWithBruteForce) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(0, 1);
  std::normal_distribution<float> normal;
  const auto draw = [&](int count) {
    std::vector<NdtCell> cells;
    for (int i = 0; i < count; ++i)
      cells.push_back(FlatCell({4 * place(random), 4 * place(random) - 2, place(random)},
                               {normal(random), normal(random), normal(random)}));
    return cells;
  };
  const EnvironmentMap environment{0.05, draw(5000)};
  const NdtMap map = WorldMap(draw(3000));
  const std::vector<CellNormal> environment_normals = ComputeNormals(environment.cells);
  const std::vector<CellNormal> normals = ComputeNormals(map.cells);
  const ForegroundMap result = BackgroundSubtractor(environment).Subtract(map);
  ASSERT_EQ(result.is_foreground.size(), map.cells.size());
  EXPECT_EQ(result.map.cells, map.cells);
  int background = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    double nearest_distance = 1e9;
    double threshold = 0;
    for (std::size_t k = 0; k < environment.cells.size(); ++k) {
      const double distance = (map.cells[i].mean - environment.cells[k].mean).norm();
      if (distance >= nearest_distance) continue;
      nearest_distance = distance;
      const double cosine = std::abs(normals[i].normal.dot(environment_normals[k].normal));
      threshold = (1 - 2 * std::acos(std::min(1.0, cosine)) / std::numbers::pi) * 0.05 + 0.03;
    }
    EXPECT_EQ(result.is_foreground[i] == 0, nearest_distance < threshold) << "cell " << i;
    background += result.is_foreground[i] == 0;
  }
  EXPECT_GT(background, 300);
  EXPECT_LT(background, 2700);
}

TEST(BackgroundSubtractor, WorksFarFromTheOriginAndAmongEqualCells) {
  const Eigen::Vector3f far(900, -700, 3);
  const EnvironmentMap environment{0.05, std::vector<NdtCell>(500, FlatCell(far))};
  const BackgroundSubtractor subtractor(environment);
  const ForegroundMap result = subtractor.Subtract(
      WorldMap({FlatCell(far), FlatCell(far + Eigen::Vector3f(0.07F, 0, 0)),
                FlatCell(far + Eigen::Vector3f(0.09F, 0, 0)), FlatCell({0, 0, 0})}));
  EXPECT_EQ(result.is_foreground, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

TEST(BackgroundSubtractor, LeavesEverythingForegroundWithoutAnEnvironmentOrAPose) {
  const NdtMap map = WorldMap({FlatCell({0, 0, 0}), FlatCell({1, 0, 0})});
  const BackgroundSubtractor without;
  EXPECT_FALSE(without.has_environment());
  ForegroundMap result = without.Subtract(map);
  EXPECT_EQ(result.status, BackgroundStatus::kNoEnvironmentMap);
  EXPECT_EQ(result.is_foreground, (std::vector<std::uint8_t>{1, 1}));

  const BackgroundSubtractor subtractor(EnvironmentMap{0.05, map.cells});
  EXPECT_TRUE(subtractor.has_environment());
  for (const MapFrame frame : {MapFrame::kLevel, MapFrame::kCamera}) {
    NdtMap local = map;
    local.frame = frame;
    result = subtractor.Subtract(local);
    EXPECT_EQ(result.status, BackgroundStatus::kNoPose);
    EXPECT_EQ(result.is_foreground, (std::vector<std::uint8_t>{1, 1}));
  }
}

TEST(BackgroundSubtractor, TakesEmptyMapsAndCanBeMoved) {
  const BackgroundSubtractor empty(EnvironmentMap{0.05, {}});
  EXPECT_TRUE(empty.has_environment());
  EXPECT_EQ(empty.Subtract(WorldMap({FlatCell({0, 0, 0})})).is_foreground,
            std::vector<std::uint8_t>{1});
  BackgroundSubtractor one(EnvironmentMap{0.05, {FlatCell({0, 0, 0})}});
  EXPECT_TRUE(one.Subtract(WorldMap({})).is_foreground.empty());
  const BackgroundSubtractor moved = std::move(one);
  EXPECT_EQ(moved.Subtract(WorldMap({FlatCell({0, 0, 0})})).is_foreground,
            std::vector<std::uint8_t>{0});
}

TEST(BackgroundSubtractor, RejectsBrokenMapsAndSettings) {
  const auto rejects = [](const EnvironmentMap& environment, const BackgroundConfig& config = {}) {
    EXPECT_THROW(BackgroundSubtractor(environment, config), std::invalid_argument);
  };
  EnvironmentMap environment{0.05, {FlatCell({0, 0, 0})}};
  environment.cells[0].mean.y() = std::nanf("");
  rejects(environment);
  environment.cells[0] = FlatCell({0, 0, 0});
  environment.cells[0].covariance[3] = std::numeric_limits<float>::infinity();
  rejects(environment);
  rejects({0, {}});
  rejects({std::nan(""), {}});
  rejects({0.05, {}}, {.static_threshold_m = -0.01});
  rejects({0.05, {}}, {.dynamic_threshold_m = std::nan("")});
  EXPECT_THROW(BackgroundSubtractor({.static_threshold_m = -1}), std::invalid_argument);

  const BackgroundSubtractor subtractor(EnvironmentMap{0.05, {}});
  NdtMap coarse = WorldMap({});
  coarse.cell_size_m = 0.1;
  EXPECT_THROW(subtractor.Subtract(coarse), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
