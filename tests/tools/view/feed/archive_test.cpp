// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "tests/support/temporary_folder.hpp"
#include "tools/view/feed/file_archive.hpp"
#include "tools/view/feed/memory_archive.hpp"

namespace fallen {
namespace {

using Bytes = FrameArchive::Bytes;

std::shared_ptr<const Bytes> FrameOf(std::size_t size, std::uint8_t value) {
  return std::make_shared<const Bytes>(size, value);
}

TEST(MemoryArchive, ForgetsTheOldestBeyondItsBoundButNeverTheNewest) {
  MemoryArchive archive(250);
  EXPECT_EQ(archive.count(), 0);
  for (std::uint8_t i = 0; i < 10; ++i) archive.Append(FrameOf(100, i));
  EXPECT_EQ(archive.first(), 8);
  EXPECT_EQ(archive.count(), 10);
  EXPECT_EQ(archive.Read(9)->front(), 9);
  archive.Append(FrameOf(1000, 10));
  EXPECT_EQ(archive.first(), 10);
  EXPECT_EQ(archive.Read(10)->size(), 1000u);
}

TEST(FileArchive, GivesEveryFrameBackAndLeavesNoFile) {
  const TemporaryFolder folder;
  FileArchive archive(folder.path());
  for (std::uint8_t i = 0; i < 20; ++i) archive.Append(FrameOf(1000u * i, i));
  EXPECT_EQ(archive.first(), 0);
  EXPECT_EQ(archive.count(), 20);
  for (const std::uint8_t i : std::vector<std::uint8_t>{19, 0, 7})
    EXPECT_EQ(*archive.Read(i), Bytes(1000u * i, i));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FileArchive, SaysWhereItCannotKeepFrames) {
  EXPECT_THROW(FileArchive("/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace fallen
