// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/support/run_program.hpp"
#include "tests/tools/common/tum_fixture.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(FallenImport, SaysWhatItWrote) {
  const TumFixture fixture;
  const auto log = fixture.path() / "out.lcm";
  const ProgramOutcome outcome =
      RunProgram("fallen-import", {fixture.path().string(), "-o", log.string()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "frames 3 poses 0 labelled 0\n");
  EXPECT_TRUE(std::filesystem::exists(log));
}

TEST(FallenImport, HelpAndVersionSucceed) {
  const ProgramOutcome help = RunProgram("fallen-import", {"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("--output"));
  const ProgramOutcome version = RunProgram("fallen-import", {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, StartsWith("fallen-import "));
}

TEST(FallenImport, AWrongCallOrInputIsOneLineAndStatusTwo) {
  const TumFixture fixture;
  const std::string directory = fixture.path().string();
  const std::string log = directory + "/out.lcm";
  const std::vector<std::vector<std::string>> calls = {
      {},
      {directory},
      {directory, "-o", log, "--fast"},
      {directory, "-o", "/nowhere/out.lcm"},
      {"/nowhere", "-o", log},
      {directory + "/depth", "-o", log},
      {directory, "-o", log, "--camera", "no such/camera"}};
  for (const std::vector<std::string>& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-import", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("fallen-import: "));
    EXPECT_FALSE(std::filesystem::exists(log));
  }
}

}  // namespace
}  // namespace fallen
