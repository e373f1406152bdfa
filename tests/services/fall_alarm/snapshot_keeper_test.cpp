// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/snapshot_keeper.hpp"

#include <gmock/gmock.h>

#include "fallen/messages/log_file.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/synthetic_scene.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using testing_support::kFirstUtime;
using testing_support::MemqLink;

class SnapshotKeeperTest : public testing::Test {
 protected:
  void Send(std::int64_t seq, const std::string& camera) {
    const StampedDepthImage image = testing_support::SceneImage(seq, camera);
    link_.SendMessage("ROBOT_POSE", ToMessage(testing_support::ScenePose(image.header.utime)));
    link_.SendMessage("DEPTH_" + camera, ToMessage(image));
    while (link_.lcm().handleTimeout(0) > 0) {
    }
  }
  static std::int64_t Utime(std::int64_t seq) {
    return testing_support::SceneImage(seq).header.utime;
  }
  std::vector<LogEvent> Events(const AlarmSnapshot& snapshot) {
    const auto file = folder_.Write("snapshot.lcm", {snapshot.log.begin(), snapshot.log.end()});
    LogReader reader(file);
    std::vector<LogEvent> events;
    while (auto event = reader.Next()) events.push_back(*event);
    EXPECT_TRUE(reader.damage().empty());
    return events;
  }

  MemqLink link_;
  TemporaryFolder folder_;
};

TEST_F(SnapshotKeeperTest, GivesTheFrameAskedForAsALog) {
  const SnapshotKeeper keeper(link_.lcm());
  for (std::int64_t seq = 0; seq < 5; ++seq) {
    Send(seq, "FRONT");
    Send(seq, "REAR");
  }
  const auto snapshot = keeper.Take("REAR", Utime(2));
  ASSERT_TRUE(snapshot);
  const auto events = Events(*snapshot);
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].channel, "ROBOT_POSE");
  EXPECT_EQ(events[1].channel, "DEPTH_REAR");
  EXPECT_EQ(events[1].utime, Utime(2));
  EXPECT_EQ(events[1].data, EncodeMessage(ToMessage(testing_support::SceneImage(2, "REAR"))));
}

TEST_F(SnapshotKeeperTest, KnowsNothingOfOtherFrames) {
  const SnapshotKeeper keeper(link_.lcm());
  Send(0, "FRONT");
  EXPECT_FALSE(keeper.Take("FRONT", Utime(1)));
  EXPECT_FALSE(keeper.Take("REAR", Utime(0)));
}

TEST_F(SnapshotKeeperTest, ForgetsTheOldestWhenItIsFull) {
  const std::size_t image_bytes =
      EncodeMessage(ToMessage(testing_support::SceneImage(0, "FRONT"))).size();
  const SnapshotKeeper keeper(link_.lcm(), 4 * image_bytes);
  for (std::int64_t seq = 0; seq < 20; ++seq) Send(seq, "FRONT");
  EXPECT_FALSE(keeper.Take("FRONT", Utime(0)));
  EXPECT_TRUE(keeper.Take("FRONT", Utime(19)));
}

TEST_F(SnapshotKeeperTest, GarbageIsNotWorthKeeping) {
  const SnapshotKeeper keeper(link_.lcm());
  link_.Send("DEPTH_FRONT", {});
  link_.Send("DEPTH_FRONT", {1, 2, 3});
  while (link_.lcm().handleTimeout(0) > 0) {
  }
  EXPECT_FALSE(keeper.Take("FRONT", 0));
}

}  // namespace
}  // namespace fallen
