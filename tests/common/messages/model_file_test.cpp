// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "fallen/classification/cluster_features.hpp"
#include "fallen/messages/container_file.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/messages/model_files.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

constexpr int kUnits = 5;

// A model with all parts, of values that no rounding leaves alone.
Model SampleModel() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Model model;
  model.description = "two recordings, seed 1";
  model.cells.iron.radius_m = 0.45;
  model.cells.iron.distance_bins = 2;
  model.cells.iron.angle_bins = 3;
  model.cells.gate.trees.feature_count = kShapeFeatureCount;
  model.cells.gate.trees.roots = {0};
  model.cells.gate.trees.nodes = {{3, 0.7f, 1, 0}, {-1, 0, 0, 0.4f}, {-1, 0, 0, -0.9f}};
  model.cells.gate.min_score = -0.345;
  model.cells.gate.turned_away_score = -0.123;
  model.cells.trees.feature_count = model.cells.iron.dimension();
  model.cells.trees.roots = {0, 3};
  model.cells.trees.nodes = {
      {2, 0.1f, 1, 0}, {-1, 0, 0, -0.3f}, {-1, 0, 0, 0.7f}, {-1, 0, 0, 0.01f}};
  model.segmentation.min_score = 0.123;
  model.segmentation.cluster_min_points = 5;
  model.segmentation.descriptors_on_foreground_only = true;

  model.clusters.iron = model.cells.iron;
  model.clusters.codebook.resize(kUnits, model.cells.iron.dimension());
  Eigen::MatrixXd root(kUnits, kUnits);
  Eigen::VectorXd mean(kUnits);
  for (int i = 0; i < kUnits; ++i) {
    for (Eigen::Index j = 0; j < model.clusters.codebook.cols(); ++j)
      model.clusters.codebook(i, j) = static_cast<float>(std::abs(normal(random)));
    model.clusters.codebook.row(i).normalize();
    for (int j = 0; j < kUnits; ++j) root(i, j) = normal(random);
    mean[i] = normal(random);
  }
  model.clusters.alpha = 0.65;
  Eigen::MatrixXd covariance = root * root.transpose() + Eigen::MatrixXd::Identity(kUnits, kUnits);
  covariance = (covariance + covariance.transpose()).eval() / 2;
  model.clusters.gaussian = MahalanobisModel(mean, covariance);
  model.clusters.trees.feature_count = ClusterFeatureCount(model.clusters.iron, kUnits);
  model.clusters.trees.roots = {0};
  model.clusters.trees.nodes = {
      {kClusterShapeFeatures + 1, 0.25F, 1, 0}, {-1, 0, 0, -0.5F}, {-1, 0, 0, 0.75F}};
  FeatureNetwork& network = model.clusters.network;
  Eigen::Index inputs = model.clusters.trees.feature_count;
  const auto draw = [&](Eigen::Index rows, Eigen::Index columns) -> FeatureMatrix {
    return FeatureMatrix::NullaryExpr(rows, columns,
                                      [&] { return static_cast<float>(normal(random)); });
  };
  network.mean = draw(1, inputs);
  network.scale = draw(1, inputs);
  for (const Eigen::Index outputs : {4, 1}) {
    network.layers.push_back({draw(inputs, outputs), draw(1, outputs)});
    inputs = outputs;
  }
  model.clusters.network_share = 1.0 / 7;
  model.clusters.calibration.slope = 2.345;
  model.clusters.calibration.intercept = 1.0 / 3;
  model.clusters.calibration.operating_points = {{0.5, 0.1, 0.05}, {0.75, 0.01, 0.2}};
  return model;
}

void ExpectEqual(const Model& a, const Model& b) {
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.cells.cell_size_m, b.cells.cell_size_m);
  EXPECT_EQ(a.cells.iron, b.cells.iron);
  EXPECT_EQ(a.cells.gate.trees, b.cells.gate.trees);
  EXPECT_EQ(a.cells.gate.min_score, b.cells.gate.min_score);
  EXPECT_EQ(a.cells.gate.turned_away_score, b.cells.gate.turned_away_score);
  EXPECT_EQ(a.cells.features, b.cells.features);
  EXPECT_EQ(a.cells.trees, b.cells.trees);
  EXPECT_EQ(a.segmentation, b.segmentation);
  EXPECT_EQ(a.clusters.iron, b.clusters.iron);
  EXPECT_EQ(a.clusters.codebook, b.clusters.codebook);
  EXPECT_EQ(a.clusters.alpha, b.clusters.alpha);
  EXPECT_EQ(a.clusters.gaussian.mean(), b.clusters.gaussian.mean());
  EXPECT_EQ(a.clusters.gaussian.covariance(), b.clusters.gaussian.covariance());
  EXPECT_EQ(a.clusters.trees, b.clusters.trees);
  EXPECT_EQ(a.clusters.network, b.clusters.network);
  EXPECT_EQ(a.clusters.network_share, b.clusters.network_share);
  EXPECT_EQ(a.clusters.calibration, b.clusters.calibration);
}

TEST(ModelConversion, RoundTripIsExact) {
  ExpectEqual(FromMessage(ToMessage(SampleModel())), SampleModel());
}

TEST(ModelConversion, RefusesEachBadField) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(model_t&)>> cases[] = {
      {"description", [](auto& m) { m.description = "\x03"; }},
      {"cell_size_m", [](auto& m) { m.cell_size_m = 0; }},
      {"iron.radius_m", [=](auto& m) { m.iron.radius_m = kNan; }},
      {"gate_trees.node_count", [](auto& m) { m.gate_trees.node_left.pop_back(); }},
      {"cell_gate", [](auto& m) { m.gate_trees.feature_count = 11; }},
      {"boosted_trees", [](auto& m) { m.gate_trees.node_feature[0] = 10; }},
      {"cell_gate: min_score", [](auto& m) { m.gate_min_score = -1.1; }},
      {"cell_gate: min_score", [=](auto& m) { m.gate_min_score = kNan; }},
      {"turned_away_score", [](auto& m) { m.gate_turned_away_score = 1.1; }},
      {"features", [](auto& m) { m.features = 2; }},
      {"features", [](auto& m) { m.features = -1; }},
      {"tree_count", [](auto& m) { m.cell_trees.tree_count = 3; }},
      {"node_count", [](auto& m) { m.cell_trees.node_value.pop_back(); }},
      {"boosted_trees", [](auto& m) { m.cell_trees.node_left[0] = 0; }},
      {"boosted_trees", [](auto& m) { m.cell_trees.node_left[0] = 1 << 30; }},
      {"boosted_trees", [](auto& m) { m.cell_trees.root[0] = -1; }},
      {"boosted_trees", [=](auto& m) { m.cell_trees.node_value[1] = static_cast<float>(kNan); }},
      {"min_score", [](auto& m) { m.min_score = 7; }},
      {"descriptors_on_foreground_only", [](auto& m) { m.descriptors_on_foreground_only = 2; }},
      {"unit_count", [](auto& m) { m.unit_count = 0; }},
      {"unit_count", [](auto& m) { m.unit_count = 1 << 20; }},
      {"dimension", [](auto& m) { m.dimension = 11; }},
      {"codebook", [](auto& m) { m.codebook.pop_back(); }},
      {"codebook", [](auto& m) { m.codebook[1].pop_back(); }},
      {"codebook", [=](auto& m) { m.codebook[1][2] = static_cast<float>(kNan); }},
      {"codebook", [](auto& m) { m.codebook[1][2] = 3; }},
      {"alpha", [](auto& m) { m.alpha = 2; }},
      {"gaussian_mean", [](auto& m) { m.gaussian_mean.pop_back(); }},
      {"mean", [=](auto& m) { m.gaussian_mean[0] = kNan; }},
      {"covariance", [](auto& m) { m.gaussian_covariance[2].pop_back(); }},
      {"covariance", [](auto& m) { m.gaussian_covariance[2][1] += 1; }},
      {"covariance", [](auto& m) { m.gaussian_covariance[2][2] = -1; }},
      {"cluster_trees.tree_count", [](auto& m) { m.cluster_trees.tree_count = 2; }},
      {"features", [](auto& m) { m.cluster_trees.feature_count = 900; }},
      {"boosted_trees", [](auto& m) { m.cluster_trees.root[0] = 9; }},
      {"cluster_network.feature_count", [](auto& m) { m.cluster_network.feature_count = 3; }},
      {"cluster_network.feature_count", [](auto& m) { m.cluster_network.scale.pop_back(); }},
      {"cluster_network.layer_count", [](auto& m) { m.cluster_network.layer_count = 1; }},
      {"output_count", [](auto& m) { m.cluster_network.layers[0].output_count = 5; }},
      {"weight's rows", [](auto& m) { m.cluster_network.layers[0].input_count = -1; }},
      {"weight", [](auto& m) { m.cluster_network.layers[0].weight[2].pop_back(); }},
      {"output_count", [](auto& m) { m.cluster_network.layers[0].output_count = -1; }},
      {"feature_network",
       [](auto& m) { m.cluster_network.layers.pop_back(), m.cluster_network.layer_count = 1; }},
      {"mean", [=](auto& m) { m.cluster_network.mean[1] = static_cast<float>(kNan); }},
      {"network_share", [](auto& m) { m.network_share = 1.1; }},
      {"network_share", [=](auto& m) { m.network_share = kNan; }},
      {"slope", [](auto& m) { m.calibration_slope = -1; }},
      {"intercept", [=](auto& m) { m.calibration_intercept = kNan; }},
      {"operating_point_count", [](auto& m) { m.operating_point_count = 3; }},
      {"miss_rate", [](auto& m) { m.operating_point_miss_rate[0] = -1; }},
      {"operating point", [](auto& m) { m.operating_point_min_probability[0] = 0.9; }},
  };
  for (const auto& [what, spoil] : cases) {
    model_t message = ToMessage(SampleModel());
    spoil(message);
    try {
      FromMessage(message);
      ADD_FAILURE() << what << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(),
                  testing::AnyOf(testing::HasSubstr(what), testing::HasSubstr("finite")))
          << what;
    }
  }
}

TEST(ModelConversion, WritingRefusesPartsThatDoNotFit) {
  Model model = SampleModel();
  model.clusters.iron.radius_m = 0.5;
  EXPECT_THROW(ToMessage(model), std::invalid_argument);
  model = SampleModel();
  model.clusters.codebook.conservativeResize(kUnits - 1, Eigen::NoChange);
  EXPECT_THROW(ToMessage(model), std::invalid_argument);
  model = SampleModel();
  model.cells.signs = NormalSigns::kOriented;  // model_t has no place for it
  EXPECT_THROW(ToMessage(model), std::invalid_argument);
}

TEST(ModelFile, GivesBackWhatWasSavedAndNamesWhatIsWrong) {
  const auto path = std::filesystem::path(testing::TempDir()) / "model_file_test.model";
  SaveModel(path, SampleModel());
  ExpectEqual(LoadModel(path), SampleModel());

  const auto error_of = [&] {
    try {
      LoadModel(path);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  SaveEnvironmentMap(path, {0.05, {}}, "");
  EXPECT_EQ(
      error_of(),
      path.string() + ": first bytes: got \"FALLENEM\", expected \"FALLENMD\" of a model file");
  model_t message = ToMessage(SampleModel());
  message.features = 9;
  WriteContainer(path, {"FALLENMD", "", 4}, EncodeMessage(message));
  EXPECT_EQ(error_of(), path.string() + ": model_t.features: got 9, expected 0 to 1");
  WriteContainer(path, {"FALLENMD", "", 3}, EncodeMessage(message));
  EXPECT_EQ(error_of(), path.string() + ": version: got 3, expected 4");
  std::filesystem::remove(path);
  EXPECT_EQ(error_of(), path.string() + ": cannot open: No such file or directory");
}

}  // namespace
}  // namespace fallen
