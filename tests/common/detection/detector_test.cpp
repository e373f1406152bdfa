// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/detection/detector.hpp"

#include <gmock/gmock.h>

#include <optional>
#include <stdexcept>

#include "tests/support/simd_levels.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"

namespace fallen {
namespace {

using lying_scene::Render;
using lying_scene::With;

Detector PlainDetector(const DetectorConfig& config = {}) {
  return Detector(PlainModel(), config, BackgroundSubtractor());
}

/// The wall is no person: what is left of it is above this height.
DetectorConfig BelowTheWall() {
  DetectorConfig config;
  config.ndt.max_range_m = 3.2;
  return config;
}

TEST(Detector, FindsTheBlockOfALyingPersonWhereItIs) {
  Detector detector = PlainDetector(BelowTheWall());
  const FrameResult result = detector.Detect(Render(0, 0, With::kPerson));
  EXPECT_EQ(result.decision.frame, MapFrame::kWorld);
  ASSERT_EQ(result.decision.hypotheses.size(), 1u);
  const PersonHypothesis& person = result.decision.hypotheses.front();
  EXPECT_TRUE(person.is_person);
  EXPECT_TRUE(lying_scene::Person().Contains(person.centroid)) << person.centroid.transpose();
}

TEST(Detector, FindsNobodyInAnEmptyRoom) {
  Detector detector = PlainDetector(BelowTheWall());
  EXPECT_TRUE(detector.Detect(Render(0, 0, With::kNobody)).decision.hypotheses.empty());
}

TEST(Detector, DecidesEveryFrameAlsoWithoutAFloorOrAnyDepth) {
  Detector detector = PlainDetector();
  Frame blind = Render(0, 0, With::kPerson);
  std::fill(blind.image.depth.begin(), blind.image.depth.end(), std::uint16_t{0});
  const FrameResult nothing = detector.Detect(blind);
  EXPECT_TRUE(nothing.foreground.map.cells.empty());
  EXPECT_TRUE(nothing.decision.hypotheses.empty());

  Frame wall = blind;
  wall.T_robot_camera.reset();
  wall.T_world_robot.reset();
  std::fill(wall.image.depth.begin(), wall.image.depth.end(), std::uint16_t{1500});
  const FrameResult no_floor = detector.Detect(wall);
  EXPECT_FALSE(no_floor.foreground.map.ground.ok());
  EXPECT_EQ(no_floor.decision.frame, MapFrame::kCamera);
}

TEST(Detector, GivesTheSameDecisionsForTheSameFrames) {
  Detector first = PlainDetector();
  Detector second = PlainDetector();
  for (int i = 0; i < 3; ++i) {
    const Frame frame = Render(100000 * i, 0.02 * i, With::kPerson);
    const FrameResult a = first.Detect(frame);
    const FrameResult b = second.Detect(frame);
    EXPECT_EQ(a.foreground.map.cells, b.foreground.map.cells);
    EXPECT_EQ(a.segmented.cells, b.segmented.cells);
    EXPECT_EQ(a.decision, b.decision);
  }
}

TEST(Detector, GivesTheSameBitsAtEverySimdLevel) {
  std::optional<FrameResult> portable;
  test::AtEverySimdLevel([&](SimdLevel level) {
    Detector detector = PlainDetector(BelowTheWall());
    detector.Detect(Render(0, 0, With::kPerson));
    const FrameResult result = detector.Detect(Render(100000, 0.02, With::kPerson));
    if (level == SimdLevel::kPortable) portable = result;
    ASSERT_FALSE(result.segmented.clusters.empty());
    EXPECT_EQ(result.foreground.map.cells, portable->foreground.map.cells);
    EXPECT_EQ(result.segmented.cells, portable->segmented.cells);
    EXPECT_EQ(result.segmented.clusters[0].descriptors,
              portable->segmented.clusters[0].descriptors);
    EXPECT_EQ(result.decision, portable->decision);
  });
}

TEST(Detector, StagesComposedByHandGiveTheSameDecision) {
  const DetectorConfig config = BelowTheWall();
  const Model model = PlainModel();
  const Frame frame = Render(0, 0, With::kPerson);
  NdtMapper mapper(config.ndt);
  const NdtMap map = UpdateMap(mapper, frame, config.ground);
  const ForegroundMap foreground = BackgroundSubtractor().Subtract(map);
  const SegmentedMap segmented = SegmentCells(foreground, model.cells, config.segmentation);
  const Decision decision = ClassifyClusters(segmented, model.clusters, config.classification);

  Detector detector = PlainDetector(config);
  EXPECT_EQ(detector.Detect(frame).decision, decision);
}

TEST(Detector, TimesAddUpToTheTotal) {
  Detector detector = PlainDetector();
  const StageTimes times = detector.Detect(Render(0, 0, With::kPerson)).milliseconds;
  const double sum =
      times.ground + times.ndt + times.background + times.iron + times.cells + times.clusters;
  EXPECT_GT(times.ndt, 0);
  EXPECT_LE(sum, times.total * 1.001);
}

TEST(Detector, RefusesAMalformedImageAndGoesOn) {
  Detector detector = PlainDetector(BelowTheWall());
  Frame broken = Render(0, 0, With::kPerson);
  broken.image.depth.pop_back();
  EXPECT_THROW(detector.Detect(broken), std::invalid_argument);
  EXPECT_EQ(detector.Detect(Render(0, 0, With::kPerson)).decision.hypotheses.size(), 1u);
}

TEST(Detector, RefusesPartsThatDoNotFit) {
  DetectorConfig config;
  config.ndt.cell_size_m = 0.1;
  EXPECT_THROW(PlainDetector(config), std::invalid_argument) << "the model has cells of 5 cm";

  EnvironmentMap coarse;
  coarse.cell_size_m = 0.1;
  EXPECT_THROW(Detector(PlainModel(), {}, BackgroundSubtractor(coarse)), std::invalid_argument);

  Model mixed = PlainModel();
  mixed.clusters.iron.radius_m = 0.4;
  EXPECT_THROW(mixed.Validate(), std::invalid_argument);
  EXPECT_THROW(Detector(mixed, {}, BackgroundSubtractor()), std::invalid_argument);

  config = {};
  config.segmentation.cluster_epsilon_m = -1;
  EXPECT_THROW(PlainDetector(config), std::invalid_argument);
}

TEST(UpdateMap, IsInTheWorldOnlyWithPoseAndMounting) {
  const Frame whole = Render(0, 0.3, With::kPerson);
  NdtMapper mapper;
  StageTimes times;
  const NdtMap world = UpdateMap(mapper, whole, {}, &times);
  EXPECT_EQ(world.frame, MapFrame::kWorld);
  EXPECT_TRUE(world.T_map_camera.isApprox(lying_scene::CameraPose(0.3), 1e-12));
  EXPECT_EQ(world.view, MakeCameraView(whole.image));
  EXPECT_GT(times.ground, 0);
  EXPECT_GT(times.ndt, 0);

  Frame without_mounting = whole;
  without_mounting.T_robot_camera.reset();
  NdtMapper other;
  const NdtMap level = UpdateMap(other, without_mounting, {});
  EXPECT_EQ(level.frame, MapFrame::kLevel) << "the floor is found in the image";
  EXPECT_NEAR(level.T_map_camera.translation().z(), lying_scene::kCameraHeightM, 0.02);
}

}  // namespace
}  // namespace fallen
