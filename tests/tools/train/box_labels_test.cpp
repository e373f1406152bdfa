// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tools/train/cell_training.hpp"
#include "tools/train/observation.hpp"

namespace fallen {
namespace {

/// A recording as users have it: depth images, poses, and a box in labels.yaml.
ObservedRecording ObserveLabelledByBox(bool with_poses) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path(), 2, lying_scene::With::kPerson, with_poses);
  lying_scene::WriteLabels(folder.path(), lying_scene::With::kPerson);
  return ObserveRecording(folder.path(), {}, {}, {.frame_stride = 1, .single_frame_stride = 0});
}

std::vector<const ObservedFrame*> Pointers(const ObservedRecording& recording) {
  std::vector<const ObservedFrame*> frames;
  for (const ObservedFrame& frame : recording.frames) frames.push_back(&frame);
  return frames;
}

// Descriptors of the person's cells as if alone in the world, those that have one.
IronDescriptors::Matrix DescribePerson(const ObservedFrame& frame, NormalSigns signs) {
  std::vector<NdtCell> cells;
  for (std::size_t i = 0; i < frame.labels.size(); ++i)
    if (frame.labels[i] == CellLabel::kPerson) cells.push_back(frame.map.cells[i]);
  auto normals = ComputeNormals(cells);
  if (signs == NormalSigns::kOriented)
    OrientNormals(cells, frame.map.T_map_camera.translation().cast<float>(), normals);
  const IronDescriptors descriptors = ComputeIronDescriptors(cells, normals, {}, {}, signs);
  IronDescriptors::Matrix valid(0, descriptors.values.cols());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!descriptors.valid(i)) continue;
    valid.conservativeResize(valid.rows() + 1, Eigen::NoChange);
    valid.bottomRows(1) = descriptors.values.row(static_cast<Eigen::Index>(i));
  }
  return valid;
}

void ExpectFirst(const IronDescriptors::Matrix& first, const IronDescriptors::Matrix& all) {
  ASSERT_GT(first.rows(), 20);
  ASSERT_LE(first.rows(), all.rows());
  EXPECT_EQ(first, all.topRows(first.rows()));
}

TEST(BoxLabels, AreEnoughToTrainOn) {
  const ObservedRecording recording = ObserveLabelledByBox(true);
  const auto frames = Pointers(recording);
  const CellSamples samples =
      CollectCellSamples(frames, TrainingConfig{}, 1, [](const char*, double) {});
  EXPECT_GT(std::count(samples.labels.begin(), samples.labels.end(), 1), 50);
  EXPECT_GT(std::count(samples.labels.begin(), samples.labels.end(), -1), 50);
  EXPECT_GT(samples.person_descriptors.rows(), 50);
}

TEST(BoxLabels, SayNothingWithoutAPose) {
  const ObservedRecording recording = ObserveLabelledByBox(false);
  ASSERT_EQ(recording.frames.size(), 2u);
  EXPECT_TRUE(recording.frames[0].labels.empty());
}

TEST(IsolatedPositives, LeaveOutTheOtherCellsOfFramesWithAPerson) {
  const ObservedRecording recording = ObserveLabelledByBox(true);
  auto frames = Pointers(recording);
  TrainingConfig config;
  config.sampling.positives = PositiveCells::kIsolated;
  EXPECT_THROW(CollectCellSamples(frames, config, 1, [](const char*, double) {}),
               std::runtime_error);
}

TEST(IsolatedPositives, HaveNothingButThePersonAround) {
  const ObservedRecording with_person = ObserveLabelledByBox(true);
  ObservedFrame empty = with_person.frames[0];  // the same cells, nobody's
  empty.person_box.reset();
  std::fill(empty.labels.begin(), empty.labels.end(), CellLabel::kOther);
  auto frames = Pointers(with_person);
  frames.push_back(&empty);
  TrainingConfig config;
  config.sampling.positives = PositiveCells::kIsolated;
  const CellSamples samples = CollectCellSamples(frames, config, 1, [](const char*, double) {});
  ExpectFirst(DescribePerson(with_person.frames[0], NormalSigns::kArbitrary),
              samples.person_descriptors);
  config.signs = NormalSigns::kOriented;
  const CellSamples oriented = CollectCellSamples(frames, config, 1, [](const char*, double) {});
  ExpectFirst(DescribePerson(with_person.frames[0], NormalSigns::kOriented),
              oriented.person_descriptors);
  EXPECT_NE(oriented.person_descriptors, samples.person_descriptors);
}

}  // namespace
}  // namespace fallen
