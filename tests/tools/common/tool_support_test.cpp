// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fallen/service/command_line.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

struct Outcome {
  int status = 0;
  std::string out;
  std::string err;
};

Outcome RunWith(std::vector<const char*> arguments, const std::function<int()>& run) {
  auto parser = MakeToolParser("fallen-test", "Does nothing");
  int number = 0;
  parser->add_option("--number", number);
  arguments.insert(arguments.begin(), "fallen-test");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.status = RunTool(*parser, static_cast<int>(arguments.size()), arguments.data(), run);
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

TEST(RunTool, ReturnsTheToolsOwnStatus) {
  EXPECT_EQ(RunWith({"--number", "3"}, [] { return 7; }).status, 7);
}

TEST(RunTool, HelpAndVersionSucceedWithoutRunning) {
  const auto never = []() -> int { throw std::runtime_error("ran"); };
  const Outcome help = RunWith({"--help"}, never);
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, HasSubstr("--number"));
  const Outcome version = RunWith({"--version"}, never);
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, StartsWith("fallen-test "));
}

TEST(RunTool, AWrongCallIsOneLineAndStatusTwo) {
  for (const auto& arguments : std::vector<std::vector<const char*>>{
           {"--nubmer", "3"}, {"--number", "three"}, {"--number"}, {"stray"}}) {
    const Outcome outcome = RunWith(arguments, [] { return 0; });
    EXPECT_EQ(outcome.status, kExitWrongCall);
    EXPECT_THAT(outcome.err, StartsWith("fallen-test: "));
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
}

TEST(ProgressBar, SaysNothingWhereThereIsNoTerminal) {
  std::ostringstream out;
  {
    ProgressBar bar("detect", out, false);
    bar.Update(0.5);
    bar.Clear();
  }
  EXPECT_THAT(out.str(), IsEmpty());
}

TEST(ProgressBar, DrawsShareAndNoteAndEndsTheLine) {
  std::ostringstream out;
  {
    ProgressBar bar("detect", out, true);
    bar.Update(0.5, "frame 12");
    bar.Update(0.51, "frame 13");  // too soon after the last
    bar.Update(7.0, "frame 24");   // clamped
  }
  EXPECT_THAT(out.str(), HasSubstr("50 %"));
  EXPECT_THAT(out.str(), HasSubstr("frame 12"));
  EXPECT_THAT(out.str(), Not(HasSubstr("frame 13")));
  EXPECT_THAT(out.str(), HasSubstr("100 %"));
  EXPECT_EQ(out.str().back(), '\n');
}

}  // namespace
}  // namespace fallen
