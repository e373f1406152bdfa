// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/page_files.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

TEST(PageFiles, ServesItsFolderAndNothingElse) {
  const TemporaryFolder folder;
  folder.Write("page/index.html", "<p>page</p>");
  folder.Write("page/three/three.module.min.js", "export {};");
  folder.Write("page/notes.txt", "not of a type that pages have");
  folder.Write("secret.html", "secret");
  const PageFiles files(folder.path() / "page");
  ASSERT_TRUE(files.Find("/"));
  EXPECT_EQ(files.Find("/")->content, "<p>page</p>");
  EXPECT_EQ(files.Find("/three/three.module.min.js")->type, "text/javascript; charset=utf-8");
  for (const char* path : {"", "/notes.txt", "/../secret.html", "/three", "/three/../index.html"})
    EXPECT_FALSE(files.Find(path)) << path;
}

TEST(PageFiles, SaysWhatIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THROW(PageFiles{folder.path()}, std::runtime_error);
  folder.Write("index.html", "");
  try {
    PageFiles{folder.path()};
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("three/three.module.min.js"));
  }
}

}  // namespace
}  // namespace fallen
