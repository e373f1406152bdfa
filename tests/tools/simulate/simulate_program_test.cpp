// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(FallenSimulate, HelpAndVersionSucceed) {
  const ProgramOutcome help = RunProgram("fallen-simulate", {"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("--output"));
  const ProgramOutcome version = RunProgram("fallen-simulate", {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, StartsWith("fallen-simulate "));
}

TEST(FallenSimulate, DescribesWithoutAssets) {
  const TemporaryFolder folder;
  const auto scenario = folder.Write("s.yaml", "seed: 7\n");
  const ProgramOutcome outcome = RunProgram(
      "fallen-simulate", {scenario.string(), "--describe", "--frames", "9", "--set", "pose=prone"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"frames\":9"));
  EXPECT_THAT(outcome.out, HasSubstr("\"pose\":\"prone\""));
}

TEST(FallenSimulate, AWrongCallOrInputIsOneLineAndStatusTwo) {
  const TemporaryFolder folder;
  const std::string good = folder.Write("s.yaml", "seed: 7\n").string();
  const std::string bad = folder.Write("bad.yaml", "seed: 7\nposture: prone\n").string();
  const std::string log = (folder.path() / "out.lcm").string();
  const std::vector<std::vector<std::string>> calls = {{},
                                                       {good},
                                                       {good, "-o", log, "--fast"},
                                                       {good, "-o", log, "--assets", "/nowhere"},
                                                       {good, "-o", log, "--set", "frames=-1"},
                                                       {good, "-o", log, "--set", "frames"},
                                                       {good, "-o", log, "--jobs", "0"},
                                                       {bad, "-o", log},
                                                       {"/nowhere.yaml", "-o", log},
                                                       {folder.path().string(), "-o", log}};
  for (const std::vector<std::string>& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-simulate", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("fallen-simulate: "));
    EXPECT_FALSE(std::filesystem::exists(log));
  }
}

TEST(FallenSimulate, NamesTheLineOfAnUnknownKey) {
  const TemporaryFolder folder;
  const std::string bad = folder.Write("bad.yaml", "seed: 7\nposture: prone\n").string();
  EXPECT_THAT(RunProgram("fallen-simulate", {bad, "--describe"}).err,
              HasSubstr("bad.yaml:2: posture"));
}

}  // namespace
}  // namespace fallen
