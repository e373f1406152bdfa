// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/cluster_samples.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"
#include "tools/train/cluster_training.hpp"

namespace fallen {
namespace {

const TrainingProgress kQuiet = [](const char*, double) {};

ClusterSamples SamplesOf(const ObservedFrame& frame) {
  const Model model = PlainModel();
  const ObservedFrame* const frames[] = {&frame};
  return CollectClusterSamples(frames, model.cells, model.clusters, {}, 1, kQuiet);
}

std::int64_t CountPersons(const ClusterSamples& samples) {
  return std::count(samples.labels.begin(), samples.labels.end(), 1);
}

TEST(ClusterSamples, OfAFramesPersonWeighAsOneTogether) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path(), 1, lying_scene::With::kPerson, true);
  lying_scene::WriteLabels(folder.path(), lying_scene::With::kPerson);
  ObservedFrame frame = ObserveRecording(folder.path(), {}, {}, {.frame_stride = 1}).frames.at(0);

  // Clusters beside the person: each weighs one.
  const ClusterSamples labelled = SamplesOf(frame);
  ASSERT_EQ(CountPersons(labelled), 1);
  ASSERT_GT(labelled.labels.size(), 1u);
  EXPECT_EQ(labelled.weights, std::vector<float>(labelled.labels.size(), 1.0F));

  // Were the wall with its parts the person too, all of them would share one weight.
  frame.person_box = OrientedBox{{2, 0, 1}, {10, 10, 4}, 0};
  const ClusterSamples everything = SamplesOf(frame);
  const std::int64_t persons = CountPersons(everything);
  ASSERT_GT(persons, 2);
  EXPECT_EQ(persons, static_cast<std::int64_t>(everything.labels.size()));
  EXPECT_EQ(everything.weights,
            std::vector<float>(everything.labels.size(), 1.0F / static_cast<float>(persons)));

  const ClusterSamples parts[] = {labelled, everything};
  const ClusterSamples joined = JoinSamples(parts);
  ASSERT_EQ(joined.weights.size(), joined.labels.size());
  EXPECT_EQ(joined.weights.front(), labelled.weights.front());
  EXPECT_EQ(joined.weights.back(), everything.weights.back());
}

// One person in ninety parts that look like a thing, and ten in one part each that do not.
TEST(TrainClusterTrees, LearnsFromWeightsNotNumbers) {
  constexpr int kParts = 90, kPersons = 10, kThings = 50;
  ClusterSamples samples;
  samples.features.resize(kParts + kPersons + 2 * kThings, 1);
  const auto add = [&](int count, float feature, std::int8_t label, float weight) {
    for (int i = 0; i < count; ++i) {
      samples.features(static_cast<Eigen::Index>(samples.labels.size()), 0) = feature;
      samples.labels.push_back(label);
      samples.weights.push_back(weight);
    }
  };
  add(kParts, 1, 1, 1.0F / kParts);
  add(kPersons, -1, 1, 1);
  add(kThings, 1, -1, 1);
  add(kThings, -1, -1, 1);
  BoostingConfig config;
  config.rounds = 1;
  config.max_depth = 1;
  const FeatureMatrix like_a_thing = FeatureMatrix::Constant(1, 1, 1);
  const BoostedTrees weighted = TrainClusterTrees(samples, config, 1, kQuiet);
  EXPECT_LT(PredictScores(weighted, like_a_thing)[0], 0);
  EXPECT_GT(PredictScores(weighted, -like_a_thing)[0], 0);
  // A class weighs as much as the other, whatever its weights sum up to.
  for (std::size_t i = 0; i < samples.labels.size(); ++i)
    if (samples.labels[i] > 0) samples.weights[i] *= 1024;
  EXPECT_EQ(TrainClusterTrees(samples, config, 1, kQuiet), weighted);

  samples.weights.assign(samples.labels.size(), 1);
  const BoostedTrees counted = TrainClusterTrees(samples, config, 1, kQuiet);
  EXPECT_GT(PredictScores(counted, like_a_thing)[0], 0);
  EXPECT_LT(PredictScores(counted, -like_a_thing)[0], 0);
}

}  // namespace
}  // namespace fallen
