// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/command_line.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "fallen/service/channels.hpp"
#include "fallen/service/stage_loop.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

class CommandLine : public testing::Test {
 protected:
  CommandLine() {
    AddStandardFlags(app_, "fallen-example", "Does nothing, well");
    app_.add_option("--camera", camera_);
  }
  int Run(
      std::vector<const char*> arguments, const std::function<int()>& run = [] { return 7; }) {
    arguments.insert(arguments.begin(), "fallen-example");
    CaptureStderr();
    CaptureStdout();
    const int status =
        RunCommandLine(app_, static_cast<int>(arguments.size()), arguments.data(), run);
    stdout_ = GetCapturedStdout();
    stderr_ = GetCapturedStderr();
    return status;
  }

  CLI::App app_;
  std::string camera_;
  std::string stdout_;
  std::string stderr_;
};

TEST_F(CommandLine, RightCallReturnsTheProgramsOwnStatus) {
  EXPECT_EQ(Run({"--camera", "FRONT"}), 7);
  EXPECT_EQ(camera_, "FRONT");
  EXPECT_EQ(stderr_, "");
}

TEST_F(CommandLine, HelpAndVersionGoToStdoutWithSuccess) {
  EXPECT_EQ(Run({"--help"}), kExitSuccess);
  EXPECT_THAT(stdout_, HasSubstr("--camera"));
  EXPECT_EQ(Run({"--version"}), kExitSuccess);
  EXPECT_THAT(stdout_, testing::MatchesRegex("fallen-example [0-9]+\\.[0-9]+\\.[0-9]+\n"));
  EXPECT_EQ(stderr_, "");
}

TEST_F(CommandLine, AnExceptionIsOneLine) {
  const auto fail = []() -> int { throw std::runtime_error("a.png: got\ntwo lines"); };
  EXPECT_EQ(Run({}, fail), kExitWrongCall);
  EXPECT_EQ(stderr_, "fallen-example: a.png: got two lines\n");
}

TEST_F(CommandLine, UnknownOptionIsOneLine) {
  EXPECT_EQ(Run({"--camra", "FRONT"}), kExitWrongCall);
  EXPECT_EQ(stderr_, "fallen-example: --camra: unknown option, see --help\n");
}

TEST_F(CommandLine, UnexpectedArgumentIsOneLine) {
  EXPECT_EQ(Run({"FRONT"}), kExitWrongCall);
  EXPECT_EQ(stderr_, "fallen-example: FRONT: unexpected argument, see --help\n");
}

TEST_F(CommandLine, MissingValueIsOneLine) {
  EXPECT_EQ(Run({"--camera"}), kExitWrongCall);
  EXPECT_THAT(stderr_, testing::MatchesRegex("fallen-example: --camera[^\n]*\n"));
}

TEST(WorkerShare, ReadsShareAndRefusesNonsense) {
  const WorkerShare share = WorkerShare::Parse("1/3");
  EXPECT_EQ(share.index, 1);
  EXPECT_EQ(share.count, 3);
  for (const char* wrong : {"", "1", "3/3", "-1/3", "0/0", "1/3x", "a/b", "1/"})
    EXPECT_THROW(WorkerShare::Parse(wrong), std::invalid_argument) << wrong;
}

TEST(WorkerShare, WorkersShareAllFramesWithoutOverlap) {
  for (std::int64_t seq = -7; seq < 20; ++seq) {
    int takers = 0;
    for (int k = 0; k < 3; ++k) takers += WorkerShare{k, 3}.Takes(seq);
    EXPECT_EQ(takers, 1) << seq;
  }
}

TEST(Channels, StatusChannelComesFromTheService) {
  EXPECT_EQ(channels::Status("ndt-mapping"), "STATUS_NDT_MAPPING");
}

TEST(Channels, CameraMustFitIntoAChannelAndBeNoPattern) {
  EXPECT_TRUE(channels::IsValidCamera("Front_2-left"));
  for (const std::string& wrong : {std::string(), std::string(".*"), std::string("A B"),
                                   std::string(channels::kMaxCameraLength + 1, 'A')})
    EXPECT_FALSE(channels::IsValidCamera(wrong)) << wrong;
}

}  // namespace
}  // namespace fallen
