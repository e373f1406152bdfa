// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/access.hpp"

#include <gmock/gmock.h>

namespace fallen {
namespace {

using testing::HasSubstr;

const AccessRules kOpen{std::nullopt, 8765};
const AccessRules kGuarded{"0123456789abcdef", 8765};

TEST(Judge, WithoutATokenServesThisHostsNamesOnly) {
  for (const char* host : {"localhost:8765", "127.0.0.1:8765", "[::1]:8765", "127.0.0.1"})
    EXPECT_TRUE(Judge({"/", host, "", ""}, kOpen).is_allowed) << host;
  for (const char* host : {"evil.example:8765", "127.evil.example", "", "192.168.1.7:8765"})
    EXPECT_FALSE(Judge({"/", host, "", ""}, kOpen).is_allowed) << host;
}

TEST(Judge, RefusesScriptsOfOtherSites) {
  EXPECT_TRUE(Judge({"/feed", "localhost:8765", "http://localhost:8765", ""}, kOpen).is_allowed);
  for (const char* origin : {"http://evil.example", "null", "http://localhost:9999"})
    EXPECT_FALSE(Judge({"/feed", "localhost:8765", origin, ""}, kOpen).is_allowed) << origin;
  EXPECT_FALSE(
      Judge({"/feed?token=0123456789abcdef", "robot:8765", "http://evil.example", ""}, kGuarded)
          .is_allowed);
}

TEST(Judge, TakesTheTokenFromTheAddressAndThenFromTheCookieThatItSets) {
  const AccessVerdict first = Judge({"/?token=0123456789abcdef", "robot:8765", "", ""}, kGuarded);
  ASSERT_TRUE(first.is_allowed);
  EXPECT_THAT(first.set_cookie, HasSubstr("HttpOnly; SameSite=Strict"));
  const std::string cookie = first.set_cookie.substr(0, first.set_cookie.find(';'));
  EXPECT_TRUE(Judge({"/main.js", "robot:8765", "", cookie}, kGuarded).is_allowed);
  EXPECT_TRUE(
      Judge({"/main.js", "robot:8765", "", "a=b; " + cookie + "; c=d"}, kGuarded).is_allowed);
}

TEST(Judge, RefusesWrongTokensWithOneLine) {
  for (const char* target :
       {"/", "/?token=", "/?token=0123456789abcdee", "/?token=0123456789abcdef0",
        "/?nottoken=0123456789abcdef", "/?token=0123456789abcde"}) {
    const AccessVerdict verdict = Judge({target, "robot:8765", "", ""}, kGuarded);
    EXPECT_FALSE(verdict.is_allowed) << target;
    EXPECT_THAT(verdict.reason, HasSubstr("token"));
    EXPECT_EQ(verdict.reason.find('\n'), std::string::npos);
  }
  EXPECT_FALSE(Judge({"/", "robot", "", "fallen_view_8765=wrong"}, kGuarded).is_allowed);
  EXPECT_FALSE(
      Judge({"/", "localhost", "", "fallen_view_1=0123456789abcdef"}, kGuarded).is_allowed);
}

TEST(MakeToken, IsNeverTheSame) {
  EXPECT_EQ(MakeToken().size(), 32u);
  EXPECT_NE(MakeToken(), MakeToken());
}

}  // namespace
}  // namespace fallen
