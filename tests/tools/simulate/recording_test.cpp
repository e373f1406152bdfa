// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/recording.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/simulate/assets_fixture.hpp"
#include "tools/simulate/distractors.hpp"

namespace fallen::sim {
namespace {

class RecordingTest : public WithAssets {
 protected:
  static std::vector<LogEvent> Record(const Simulation& simulation, int jobs) {
    const TemporaryFolder folder;
    WriteRecording(simulation, folder.path() / "log", jobs, {});
    LogReader reader(folder.path() / "log");
    std::vector<LogEvent> events;
    while (auto event = reader.Next()) events.push_back(std::move(*event));
    EXPECT_TRUE(reader.damage().empty());
    return events;
  }
  static Scenario Short(const std::string& more, const std::vector<std::string>& settings = {}) {
    return ParseScenario("seed: 3\nbody: 12\npose: supine\nroom: 4\nframes: 5\n" + more, "s.yaml",
                         settings);
  }
};

TEST_F(RecordingTest, HoldsPoseTruthAndDepthOfEachFrameInThisOrder) {
  const Simulation simulation(Short("person: true\ncamera: FRONT"), assets());
  const auto events = Record(simulation, 2);
  ASSERT_EQ(events.size(), 15u);
  for (std::size_t i = 0; i < events.size(); i += 3) {
    EXPECT_EQ(events[i].channel, "ROBOT_POSE");
    EXPECT_EQ(events[i + 1].channel, "GROUND_TRUTH_FRONT");
    EXPECT_EQ(events[i + 2].channel, "DEPTH_FRONT");
    const auto pose = DecodeMessage<pose_t>(events[i].data);
    const auto truth = DecodeMessage<ground_truth_t>(events[i + 1].data);
    const auto depth = DecodeMessage<depth_image_t>(events[i + 2].data);
    ASSERT_TRUE(pose && truth && depth) << pose.error << truth.error << depth.error;
    const StampedDepthImage image = FromMessage(*depth.message);
    EXPECT_EQ(image.header.seq, static_cast<std::int64_t>(i / 3));
    EXPECT_EQ(image.header.utime, kEpochUtime + 100000 * static_cast<std::int64_t>(i / 3));
    EXPECT_EQ(image.header.utime, pose.message->utime);
    EXPECT_EQ(image.header.utime, truth.message->header.utime);
  }
}

TEST_F(RecordingTest, IsTheSameForAnyNumberOfThreads) {
  const Simulation a(Short("person: true"), assets()), b(Short("person: true"), assets());
  const auto one = Record(a, 1), three = Record(b, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].data, three[i].data) << i;
}

TEST_F(RecordingTest, DepthPointsOfThePersonLieInThePersonsBox) {
  // Independent of the renderer's own bookkeeping: depth, intrinsics, mounting and pose as a
  // detector gets them must lead to the labelled box.
  const Simulation simulation(Short("person: true\nnoise: false\nplacement: free"), assets());
  const auto events = Record(simulation, 1);
  int inside = 0, all = 0, on_floor = 0, floor = 0;
  for (std::size_t i = 0; i < events.size(); i += 3) {
    const StampedPose pose = FromMessage(*DecodeMessage<pose_t>(events[i].data).message);
    const GroundTruth truth =
        FromMessage(*DecodeMessage<ground_truth_t>(events[i + 1].data).message);
    const StampedDepthImage image =
        FromMessage(*DecodeMessage<depth_image_t>(events[i + 2].data).message);
    EXPECT_EQ(truth.person, "body-12");
    EXPECT_EQ(truth.room, "room-4");
    ASSERT_TRUE(truth.person_box && image.T_robot_camera);
    OrientedBox box = *truth.person_box;
    box.size.array() += 0.01;  // [m], depth in whole millimetres
    const Eigen::Isometry3d T_world_robot =
        Eigen::Translation3d(pose.translation) * pose.rotation * Eigen::Isometry3d::Identity();
    const CameraIntrinsics& k = image.image.intrinsics;
    for (int v = 0; v < k.height; ++v) {
      for (int u = 0; u < k.width; ++u) {
        const auto pixel = static_cast<std::size_t>(v * k.width + u);
        if (image.image.depth[pixel] == 0) continue;
        const Eigen::Vector3d p =
            T_world_robot * *image.T_robot_camera *
            k.Deproject(u, v, image.image.depth[pixel] * image.image.depth_unit_m);
        if (truth.labels[pixel] == truth.person_label()) {
          ++all;
          inside += box.Contains(p);
        } else if (truth.labels[pixel] == 0 && v > k.height * 3 / 4) {
          ++floor;
          on_floor += std::abs(p.z()) < 0.01 || p.z() > 0.05;  // the floor, or a wall
        }
      }
    }
  }
  EXPECT_GT(all, 2000);
  EXPECT_EQ(inside, all);
  EXPECT_EQ(on_floor, floor);
}

TEST_F(RecordingTest, WithoutAPersonNobodyIsLabelled) {
  const auto events = Record(Simulation(Short("person: false"), assets()), 1);
  const GroundTruth truth = FromMessage(*DecodeMessage<ground_truth_t>(events[1].data).message);
  EXPECT_FALSE(truth.person_box);
  EXPECT_EQ(truth.person_label(), 0);
  for (const LabelledObject& object : truth.objects) EXPECT_NE(object.category, kFallenPerson);
}

TEST_F(RecordingTest, WhoGetsUpLiesThereNoMoreAndStandsElsewhere) {
  const std::string times = "person: true\nnoise: false\ndistractors: []\nrate_hz: 10\n";
  const Simulation stays(Short(times), assets());
  const Simulation gets_up(Short(times + "gets_up_after_s: 0.3"), assets());
  const auto events = Record(gets_up, 2);
  for (std::size_t i = 0; i < 5; ++i) {
    const GroundTruth truth =
        FromMessage(*DecodeMessage<ground_truth_t>(events[3 * i + 1].data).message);
    const auto count = [&](const std::string& category) {
      return std::count_if(
          truth.objects.begin(), truth.objects.end(),
          [&](const LabelledObject& object) { return object.category == category; });
    };
    EXPECT_EQ(truth.person_box.has_value(), i < 3) << i;
    EXPECT_EQ(count(kFallenPerson), i < 3 ? 1 : 0) << i;
    EXPECT_EQ(count(kStandingPerson), i < 3 ? 0 : 1) << i;
    EXPECT_EQ(gets_up.VisibleShare(static_cast<int>(i)) > 0, i < 3) << i;
  }
  const OrientedBox lying = gets_up.scene().objects[*gets_up.person_index()].box;
  EXPECT_EQ(lying, stays.scene().objects[*stays.person_index()].box);
  const OrientedBox standing = gets_up.SceneAt(3).objects.back().box;
  EXPECT_GT(standing.size.z(), 1.3);
  EXPECT_GT((standing.center - lying.center).head<2>().norm(), 0.3);
  EXPECT_EQ(&stays.SceneAt(4), &stays.scene());
}

TEST_F(RecordingTest, TheRoomDoesNotDependOnWhoIsInIt) {
  const Simulation with(Short("person: true\ndistractors: []"), assets());
  const Simulation without(Short("person: false\ndistractors: []"), assets());
  ASSERT_EQ(with.scene().objects.size(), without.scene().objects.size() + 1);
  for (std::size_t i = 0; i < without.scene().objects.size(); ++i)
    EXPECT_EQ(with.scene().objects[i].box, without.scene().objects[i].box);
}

TEST_F(RecordingTest, MountingErrorIsInThePictureNotInTheMessage) {
  const Simulation exact(Short("person: true\nnoise: false"), assets());
  const Simulation off(Short("person: true\nnoise: false\nmounting_error_deg: 1"), assets());
  EXPECT_TRUE(exact.told_T_robot_camera().isApprox(off.told_T_robot_camera()));
  EXPECT_NE(exact.TakeFrame(0).image.depth.depth, off.TakeFrame(0).image.depth.depth);
}

TEST_F(RecordingTest, NoiseScaleIsTimesTheSensorsOwnNoise) {
  const auto median_error_mm = [&](const std::string& noise) {
    const std::string scenario = "person: true\nsensor: time_of_flight\n";
    const DepthImage exact =
        Simulation(Short(scenario + "noise: false"), assets()).TakeFrame(0).image.depth;
    const DepthImage noisy = Simulation(Short(scenario + noise), assets()).TakeFrame(0).image.depth;
    std::vector<double> errors;
    for (std::size_t i = 0; i < exact.depth.size(); ++i)
      if (exact.depth[i] > 0 && noisy.depth[i] > 0)
        errors.push_back(std::abs(exact.depth[i] - noisy.depth[i]));
    std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
    return errors[errors.size() / 2];
  };
  const double usual = median_error_mm("noise_scale: 1");
  EXPECT_EQ(usual, median_error_mm("noise: true"));
  EXPECT_GT(median_error_mm("noise_scale: 4"), 2 * usual);
  EXPECT_THROW(Short("noise_scale: -1"), std::exception);
}

TEST_F(RecordingTest, OdometryDriftGrowsFromNothing) {
  const Simulation simulation(Short("person: true\nodometry_drift: 0.1", {"frames=60"}), assets());
  const Frame first = simulation.TakeFrame(0), last = simulation.TakeFrame(59);
  EXPECT_EQ(first.true_pose.x, first.told_pose.x);
  EXPECT_GT(std::hypot(last.true_pose.x - last.told_pose.x, last.true_pose.y - last.told_pose.y),
            0.001);
}

}  // namespace
}  // namespace fallen::sim
