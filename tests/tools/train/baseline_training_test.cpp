// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/baseline_training.hpp"

#include <gtest/gtest.h>

#include <random>

#include "fallen/baseline/layer_features.hpp"
#include "fallen/evaluation/frame_outcome.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"

namespace fallen {
namespace {

using lying_scene::With;

constexpr int kFrames = 20;
const OrientedBox kBox{{0, 0, 0.2}, {2, 1, 0.4}, 0};

// Frames with a cluster in the box, whose column 5 is at least 1, and one elsewhere, whose is at
// most 0; the other columns are noise.
BaselineRecording SeparableRecording(const BaselineConfig& config, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value;
  BaselineRecording recording;
  for (int i = 0; i < kFrames; ++i) {
    BaselineFrame& frame = recording.frames.emplace_back();
    frame.person_box = kBox;
    frame.cells_in_box = kMinCellsInBox;
    frame.clusters.frame = MapFrame::kWorld;
    frame.clusters.features =
        FeatureMatrix::NullaryExpr(2, LayerFeatureCount(config), [&] { return value(random); });
    frame.clusters.features(0, 5) += 1;
    frame.clusters.features(1, 5) -= 1;
    frame.clusters.centroids = {{0.3, 0.2, 0.1}, {4, 4, 0.1}};
    frame.clusters.boxes.resize(2);
    frame.clusters.point_counts = {100, 100};
  }
  return recording;
}

TrainedBaseline TrainOnSeparable(const BaselineTrainingConfig& config, int jobs) {
  return TrainBaseline({SeparableRecording(config.baseline, 1)},
                       {SeparableRecording(config.baseline, 2)}, config, jobs,
                       [](const char*, double) {});
}

TEST(BaselineTraining, LearnsWhatTellsPersonsApart) {
  BaselineTrainingConfig config;
  config.boosting.rounds = 20;
  const TrainedBaseline trained = TrainOnSeparable(config, 1);
  EXPECT_EQ(trained.model.config, config.baseline);
  for (const BaselineFrame& frame : SeparableRecording(config.baseline, 3).frames) {
    const Decision decision = JudgeClusters(frame.clusters, trained.model, {});
    ASSERT_EQ(decision.hypotheses.size(), 2u);
    EXPECT_EQ(decision.hypotheses[0].centroid, frame.clusters.centroids[0]);
    EXPECT_TRUE(decision.hypotheses[0].is_person);
    EXPECT_FALSE(decision.hypotheses[1].is_person);
  }
  const nlohmann::json& figures = trained.report.at("validation_figures");
  EXPECT_EQ(figures.at("positives"), kFrames);
  EXPECT_EQ(figures.at("miss_rate_at_0.01_fppf"), 0);
  EXPECT_EQ(trained.report.at("training").at("person_clusters"), kFrames);
  EXPECT_EQ(trained.report.at("training").at("other_clusters"), kFrames);
}

TEST(BaselineTraining, DoesNotDependOnTheThreads) {
  BaselineTrainingConfig config;
  config.boosting.rounds = 5;
  const BaselineModel one = TrainOnSeparable(config, 1).model;
  const BaselineModel two = TrainOnSeparable(config, 2).model;
  EXPECT_EQ(one.trees, two.trees);
  EXPECT_EQ(one.calibration, two.calibration);
}

TEST(BaselineTraining, RefusesRecordingsOfOneKind) {
  BaselineTrainingConfig config;
  BaselineRecording nobody = SeparableRecording(config.baseline, 1);
  for (BaselineFrame& frame : nobody.frames) frame.person_box.reset();
  EXPECT_THROW(TrainBaseline({nobody}, {nobody}, config, 1, [](const char*, double) {}),
               std::runtime_error);
}

TEST(BaselineTrainingConfig, NamesTheLineOfAnUnknownKey) {
  const TemporaryFolder folder;
  const auto file = folder.Write("baseline.yaml", "baseline:\n  leaf_m: 0.02\n  leaves: 3\n");
  try {
    LoadBaselineTrainingConfig(file);
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(":3: baseline"), std::string::npos) << error.what();
  }
}

TEST(BaselineObservation, CutsLabelledFramesIntoClusters) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path(), 5, With::kPerson, true);
  lying_scene::WriteLabels(folder.path(), With::kPerson);
  BaselineObservation observation;
  observation.frame_stride = 2;
  const BaselineRecording recording = ObserveForBaseline(folder.path(), observation);
  ASSERT_EQ(recording.frames.size(), 3u);
  for (const BaselineFrame& frame : recording.frames) {
    ASSERT_TRUE(frame.person_box);
    EXPECT_GE(frame.cells_in_box, kMinCellsInBox);
    int hits = 0;
    for (const Eigen::Vector3d& centroid : frame.clusters.centroids)
      hits += frame.person_box->Contains(centroid) ? 1 : 0;
    EXPECT_EQ(hits, 1);
    EXPECT_EQ(frame.clusters.features.rows(),
              static_cast<Eigen::Index>(frame.clusters.centroids.size()));
  }
  observation.counts_cells = false;
  EXPECT_EQ(ObserveForBaseline(folder.path(), observation).frames[0].cells_in_box, 0);
}

TEST(BaselineObservation, WithoutAPoseNobodyCanTellWhereTheBoxIs) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path(), 2, With::kPerson, false);
  lying_scene::WriteLabels(folder.path(), With::kPerson);
  EXPECT_THROW(ObserveForBaseline(folder.path(), {}), std::runtime_error);
}

}  // namespace
}  // namespace fallen
