// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/feed.hpp"

#include <gtest/gtest.h>

#include "tools/view/feed/memory_archive.hpp"

namespace fallen {
namespace {

using nlohmann::json;

Scene SceneAt(std::int64_t utime) {
  Scene scene;
  scene.header.utime = utime;
  return scene;
}

json Parse(const Feed::Message& message) {
  EXPECT_TRUE(message.bytes && message.is_text);
  return json::parse(message.bytes->begin(), message.bytes->end());
}

std::unique_ptr<Feed> MakeFeed(std::size_t max_bytes = 1 << 20, std::size_t max_entries = 100) {
  return std::make_unique<Feed>(std::make_unique<MemoryArchive>(max_bytes), max_entries);
}

TEST(Feed, TellsEachTimelineEntryOnce) {
  const auto feed = MakeFeed();
  std::int64_t since = 0;
  EXPECT_FALSE(feed->TimelineSince(since).bytes);
  feed->Append(SceneAt(10));
  feed->Append(SceneAt(20));
  const json both = Parse(feed->TimelineSince(since));
  EXPECT_EQ(both["first"], 0);
  EXPECT_EQ(both["entries"].size(), 2u);
  EXPECT_EQ(since, 2);
  EXPECT_FALSE(feed->TimelineSince(since).bytes);
  feed->Append(SceneAt(30));
  const json third = Parse(feed->TimelineSince(since));
  EXPECT_EQ(third["first"], 2);
  EXPECT_EQ(third["entries"][0][0], 30);
}

TEST(Feed, ForgetsOldEntriesAndSaysSo) {
  const auto feed = MakeFeed(1 << 20, 3);
  for (int i = 0; i < 5; ++i) feed->Append(SceneAt(i));
  std::int64_t since = 0;
  const json timeline = Parse(feed->TimelineSince(since));
  EXPECT_EQ(timeline["first"], 2);
  EXPECT_EQ(timeline["oldest"], 2);
  EXPECT_EQ(timeline["entries"].size(), 3u);
}

TEST(Feed, StartsANewTimelineWhenTimeRunsBackwards) {
  const auto feed = MakeFeed();
  feed->Append(SceneAt(1000));
  feed->Append(SceneAt(5));
  std::int64_t since = 0;
  const json timeline = Parse(feed->TimelineSince(since));
  EXPECT_EQ(timeline["first"], 1);
  EXPECT_EQ(timeline["entries"].size(), 1u);
}

TEST(Feed, GivesTheNearestFrameThatIsKept) {
  const auto feed = MakeFeed(1);
  for (int i = 0; i < 3; ++i) feed->Append(SceneAt(i));
  EXPECT_EQ(feed->frames().first, 2);
  EXPECT_EQ(feed->frames().count, 3);
  const auto newest = feed->Frame(2).bytes;
  EXPECT_EQ(feed->Frame(-5).bytes, newest);
  EXPECT_EQ(feed->Frame(99).bytes, newest);
}

TEST(Feed, TellsOnlyTheNewestOfEachTopic) {
  const auto feed = MakeFeed();
  EXPECT_FALSE(feed->NextTopic(0).message.bytes);
  feed->SetTopic("source", "old");
  feed->SetTopic("services", 1);
  feed->SetTopic("source", "new");
  const Feed::Topic first = feed->NextTopic(0);
  EXPECT_EQ(Parse(first.message)["name"], "services");
  const Feed::Topic second = feed->NextTopic(first.version);
  EXPECT_EQ(Parse(second.message)["value"], "new");
  EXPECT_FALSE(feed->NextTopic(second.version).message.bytes);
}

TEST(Feed, TellsOfEveryChange) {
  const auto feed = MakeFeed();
  int changes = 0;
  feed->OnChange([&] { ++changes; });
  feed->Append(SceneAt(1));
  feed->SetTopic("source", "x");
  EXPECT_EQ(changes, 2);
}

}  // namespace
}  // namespace fallen
