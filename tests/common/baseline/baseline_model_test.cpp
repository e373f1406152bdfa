// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/baseline_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

#include "fallen/baseline/layer_features.hpp"

namespace fallen {
namespace {

std::string ErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(BaselineConfig, NamesEachValueThatIsOutOfRange) {
  const std::pair<const char*, std::function<void(BaselineConfig&)>> cases[] = {
      {"max_range_m", [](auto& c) { c.max_range_m = 0; }},
      {"ground_clearance_m", [](auto& c) { c.ground_clearance_m = -1; }},
      {"ground_clearance_per_sq_m", [](auto& c) { c.ground_clearance_per_sq_m = -1; }},
      {"max_height_m", [](auto& c) { c.max_height_m = std::numeric_limits<double>::infinity(); }},
      {"leaf_m", [](auto& c) { c.leaf_m = 0; }},
      {"normal_radius_m", [](auto& c) { c.normal_radius_m = c.leaf_m / 2; }},
      {"cluster_tolerance_m", [](auto& c) { c.cluster_tolerance_m = c.leaf_m / 2; }},
      {"min_cluster_points", [](auto& c) { c.min_cluster_points = 2; }},
      {"layers", [](auto& c) { c.layers = 0; }},
      {"layer_height_m",
       [](auto& c) { c.layer_height_m = std::numeric_limits<double>::quiet_NaN(); }},
      {"normal_bins", [](auto& c) { c.normal_bins = 101; }},
  };
  EXPECT_EQ(ErrorOf([] { BaselineConfig{}.Validate(); }), "");
  for (const auto& [name, spoil] : cases) {
    BaselineConfig config;
    spoil(config);
    EXPECT_THAT(ErrorOf([&] { config.Validate(); }),
                testing::StartsWith(std::string("baseline: ") + name + " is "));
  }
}

TEST(BaselineModel, TreesMustTakeTheFeaturesOfTheConfig) {
  BaselineModel model;
  model.trees.feature_count = LayerFeatureCount(model.config);
  model.trees.roots = {0};
  model.trees.nodes = {{-1, 0, 0, 0.5F}};
  EXPECT_EQ(ErrorOf([&] { model.Validate(); }), "");
  ++model.config.layers;
  EXPECT_THAT(ErrorOf([&] { model.Validate(); }), testing::HasSubstr("features, must be"));
}

}  // namespace
}  // namespace fallen
