// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/partial_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

TEST(PartialFile, AppearsOnlyOnceCommitted) {
  const TemporaryFolder folder;
  const auto target = folder.Write("log", "old");
  PartialFile file(target);
  std::ofstream(file.path()) << "new";
  EXPECT_EQ(ReadText(target), "old");
  file.Commit();
  EXPECT_EQ(ReadText(target), "new");
}

TEST(PartialFile, LeavesNothingBehindWithoutCommit) {
  const TemporaryFolder folder;
  {
    const PartialFile file(folder.path() / "log");
    std::ofstream(file.path()) << "half";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(PartialFile, WritesToADeviceDirectly) {
  PartialFile file("/dev/null");
  EXPECT_EQ(file.path(), "/dev/null");
  file.Commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(PartialFile, RefusesATargetThatCannotBe) {
  const TemporaryFolder folder;
  EXPECT_THROW(PartialFile(folder.path() / "missing" / "log"), std::runtime_error);
  EXPECT_THROW(PartialFile{folder.path()}, std::runtime_error);
}

}  // namespace
}  // namespace fallen
