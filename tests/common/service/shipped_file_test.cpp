// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/shipped_file.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

namespace fallen {
namespace {

namespace fs = std::filesystem;

TEST(ShippedFile, IsWhatTheVariableNames) {
  setenv("FALLEN_SHIPPED_FILE_TEST", "/somewhere/else.model", 1);
  EXPECT_EQ(ShippedFilePath("fallen.model", "FALLEN_SHIPPED_FILE_TEST"), "/somewhere/else.model");
  setenv("FALLEN_SHIPPED_FILE_TEST", "", 1);
  EXPECT_NE(ShippedFilePath("fallen.model", "FALLEN_SHIPPED_FILE_TEST"), "");
  unsetenv("FALLEN_SHIPPED_FILE_TEST");
}

TEST(ShippedFile, IsInTheSourceTreeOfABuild) {
  for (const char* name : {"fallen.model", "baseline.model"})
    EXPECT_TRUE(fs::equivalent(ShippedFilePath(name, "FALLEN_SHIPPED_FILE_TEST"),
                               fs::path(FALLEN_SOURCE_DIR) / "models" / name));
}

TEST(ShippedFile, WhereNoneIsTheInstallationIsNamed) {
  const fs::path path = ShippedFilePath("no-such.model", "FALLEN_SHIPPED_FILE_TEST");
  EXPECT_TRUE(path.string().ends_with("share/fallen/models/no-such.model")) << path;
}

}  // namespace
}  // namespace fallen
