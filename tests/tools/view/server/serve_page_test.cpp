// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// The program as a whole, over sockets and without a browser; tests/tools/view/page has the
// browser.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/run_program.hpp"
#include "tests/tools/view/server/http_request.hpp"
#include "tests/tools/view/server/viewer.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kQuietLcm = {"--lcm-url", "memq://"};

TEST(FallenViewPage, ServesItsFilesOnLoopbackAndEndsCleanly) {
  Viewer viewer(kQuietLcm);
  const int port = viewer.port();
  EXPECT_EQ(viewer.address(), "http://127.0.0.1:" + std::to_string(port) + "/");
  const std::string page = HttpGet(port, "/", "Host: localhost\r\n");
  EXPECT_THAT(page, HasSubstr("200 OK"));
  EXPECT_THAT(page, HasSubstr("<p>page</p>"));
  EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(HttpGet(port, "/etc/passwd", "Host: localhost\r\n"), HasSubstr("404"));
  EXPECT_THAT(HttpGet(port, "/", "Host: evil.example\r\n"), HasSubstr("403"));
  EXPECT_EQ(viewer.process().Stop(), 0);
}

TEST(FallenViewPage, WantsTheTokenWhereOthersReachIt) {
  std::vector<std::string> arguments = kQuietLcm;
  arguments.insert(arguments.end(), {"--address", "0.0.0.0"});
  Viewer viewer(arguments);
  const std::string host = "Host: robot\r\n";
  const std::string query = viewer.address().substr(viewer.address().find('?'));
  EXPECT_THAT(HttpGet(viewer.port(), "/" + query, host), HasSubstr("200 OK"));
  EXPECT_THAT(HttpGet(viewer.port(), "/?token=wrong", host), HasSubstr("401"));
  EXPECT_THAT(HttpGet(viewer.port(), "/index.html", host), HasSubstr("401"));
  EXPECT_THAT(viewer.process().StandardError(), HasSubstr("refused 127.0.0.1: token: got one"));
}

TEST(FallenViewPage, SurvivesWhatIsNoRequest) {
  Viewer viewer(kQuietLcm);
  SendBytes(viewer.port(), std::string("\x16\x03\x01\x02\x00garbage\r\n\r\n"));
  SendBytes(viewer.port(), "GET / HTTP/1.1\r\n" + std::string(100'000, 'x'));
  EXPECT_THAT(HttpGet(viewer.port(), "/", "Host: localhost\r\n"), HasSubstr("200 OK"));
}

TEST(FallenViewPage, AWrongCallIsOneLineAndStatusTwo) {
  const TemporaryFolder folder;
  Viewer::WritePage(folder.path() / "page");
  const std::string page = (folder.path() / "page").string();
  Viewer other(kQuietLcm);
  std::ofstream(folder.path() / "short") << "abc\n";
  const std::vector<std::vector<std::string>> calls = {
      {"--lcm-url", "memq://", "--page", page, "--port", std::to_string(other.port())},
      {"--lcm-url", "memq://", "--page", (folder.path() / "nothing").string()},
      {"--lcm-url", "memq://", "--page", page, "--address", "robot.local"},
      {"--lcm-url", "memq://", "--page", page, "--token-file", (folder.path() / "short").string()},
      {"--lcm-url", "memq://", "--page", page, "--token-file", "/nowhere"},
      {"/nowhere.lcm", "--page", page, "--port", "0"},
      {"--export", "picture.png"}};
  for (const auto& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-view", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
  }
}

}  // namespace
}  // namespace fallen
