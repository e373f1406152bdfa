// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/temporary_folder.hpp"
#include "tools/doctor/file_checks.hpp"
#include "tools/doctor/finding.hpp"
#include "tools/doctor/network_checks.hpp"
#include "tools/doctor/program_checks.hpp"

namespace fallen {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<Finding> kFindings{
    {"a", Verdict::kOk, "fine", ""},
    {"b", Verdict::kWarning, "missing", "sudo mend b"},
    {"c", Verdict::kError, "got \"x\xff\", expected y", "sudo mend c"},
};

TEST(FindingTest, PrintsEachWithWhatMendsIt) {
  std::ostringstream out;
  PrintFindings(out, kFindings);
  EXPECT_EQ(out.str(),
            "ok       a: fine\n"
            "warning  b: missing\n"
            "         -> sudo mend b\n"
            "error    c: got \"x\xff\", expected y\n"
            "         -> sudo mend c\n"
            "errors 1 warnings 1\n");
}

TEST(FindingTest, PrintsJsonThatCanBeRead) {
  std::ostringstream out;
  PrintFindingsAsJson(out, kFindings);
  const auto json = nlohmann::json::parse(out.str());
  ASSERT_EQ(json["findings"].size(), 3U);
  EXPECT_EQ(json["findings"][1]["check"], "b");
  EXPECT_EQ(json["findings"][1]["verdict"], "warning");
  EXPECT_EQ(json["findings"][1]["remedy"], "sudo mend b");
  EXPECT_EQ(json["errors"], 1);
  EXPECT_EQ(json["warnings"], 1);
}

TEST(FindingTest, OnlyErrorsMakeTheExitStatus) {
  EXPECT_EQ(ExitStatusOf({}), 0);
  EXPECT_EQ(ExitStatusOf({kFindings[0], kFindings[1]}), 0);
  EXPECT_EQ(ExitStatusOf(kFindings), 1);
}

TEST(GroupOfTest, ReadsAddressAndPort) {
  EXPECT_EQ(GroupOf("udpm://239.1.2.3:99?ttl=1")->address, "239.1.2.3");
  EXPECT_EQ(GroupOf("udpm://239.1.2.3:99?ttl=1")->port, 99);
  EXPECT_EQ(GroupOf("udpm://239.1.2.3")->port, 7667);
  EXPECT_EQ(GroupOf("udpm://")->address, "239.255.76.67");
  EXPECT_EQ(GroupOf("udpm://?ttl=1")->port, 7667);
  EXPECT_FALSE(GroupOf("memq://"));
  EXPECT_FALSE(GroupOf("tcpq://localhost:7700"));
}

TEST(GroupOfTest, RefusesWhatIsNoGroup) {
  for (const char* url :
       {"udpm://10.0.0.1:7667", "udpm://240.0.0.0", "udpm://a.b.c.d:1", "udpm://239.1.2.3:0",
        "udpm://239.1.2.3:70000", "udpm://239.1.2.3:1x", "udpm://239.1.2.3:"})
    EXPECT_THROW(GroupOf(url), std::invalid_argument) << url;
}

TEST(JudgeRouteTest, WantsAnInterfaceThatIsUpAndDoesMulticast) {
  const MulticastGroup group;
  EXPECT_EQ(JudgeRoute(group, {"eth0", true, true}).verdict, Verdict::kOk);
  const Finding none = JudgeRoute(group, {});
  EXPECT_EQ(none.verdict, Verdict::kError);
  EXPECT_EQ(none.remedy,
            "sudo ip link set lo up multicast on && sudo ip route add 224.0.0.0/4 dev lo");
  const Finding down = JudgeRoute(group, {"lo", false, true});
  EXPECT_EQ(down.verdict, Verdict::kError);
  EXPECT_EQ(down.remedy, "sudo ip link set lo up multicast on");
  const Finding mute = JudgeRoute(group, {"wlan0", true, false});
  EXPECT_THAT(mute.text, HasSubstr("does no multicast"));
  EXPECT_EQ(mute.remedy, "sudo ip link set wlan0 up multicast on");
}

constexpr char kGoodUrl[] = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";

TEST(JudgeReceiveBuffersTest, TellsWhatIsTooSmallAndWhatMendsIt) {
  const auto good = JudgeReceiveBuffers(kGoodUrl, 4194304, 4194304, "/x/60.conf");
  EXPECT_EQ(ExitStatusOf(good), 0);
  for (const Finding& finding : good) EXPECT_EQ(finding.verdict, Verdict::kOk) << finding.text;

  const auto usual = JudgeReceiveBuffers(kGoodUrl, 212992, 212992, "/x/60.conf");
  ASSERT_EQ(usual.size(), 3U);
  EXPECT_EQ(usual[0].verdict, Verdict::kOk);
  EXPECT_EQ(usual[1].verdict, Verdict::kError);
  EXPECT_EQ(usual[2].verdict, Verdict::kWarning);
  EXPECT_EQ(usual[1].remedy, "sudo cp '/x/60.conf' /etc/sysctl.d/ && sudo sysctl -p '/x/60.conf'");
  EXPECT_THAT(JudgeReceiveBuffers(kGoodUrl, 1, 1, "")[1].remedy,
              StartsWith("sudo sysctl -w net.core.rmem_max="));

  const auto hidden = JudgeReceiveBuffers(kGoodUrl, std::nullopt, std::nullopt, "");
  EXPECT_EQ(ExitStatusOf(hidden), 0);
}

TEST(JudgeReceiveBuffersTest, WantsAUrlThatAsksForABuffer) {
  const auto first = [](const char* url) {
    return JudgeReceiveBuffers(url, 4194304, 4194304, "")[0];
  };
  EXPECT_EQ(first("udpm://239.255.76.67:7667?ttl=0").verdict, Verdict::kError);
  EXPECT_THAT(first("udpm://239.255.76.67:7667?ttl=0").remedy,
              HasSubstr("\"udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304\""));
  EXPECT_THAT(first("udpm://").remedy, HasSubstr("\"udpm://?recv_buf_size=4194304\""));
  EXPECT_THAT(first("udpm://?recv_buf_size=100&ttl=1").remedy,
              HasSubstr("\"udpm://?recv_buf_size=4194304&ttl=1\""));
}

TEST(CheckNetworkTest, LeavesUrlsAloneThatNeedNoNetwork) {
  const auto findings = CheckNetwork("memq://");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kOk);
  EXPECT_EQ(CheckNetwork("http://x")[0].verdict, Verdict::kError);
  EXPECT_EQ(CheckNetwork("udpm://1.2.3.4:5")[0].verdict, Verdict::kError);
}

class FileChecksTest : public ::testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
    return folder_.path() / name;
  }
  TemporaryFolder folder_;
};

TEST_F(FileChecksTest, TellsTheLineOfAWrongKey) {
  const Finding good = CheckConfiguration(Write("good.yaml", "capture: {width: 320}\n")).finding;
  EXPECT_EQ(good.verdict, Verdict::kOk) << good.text;
  const std::string bad = Write("bad.yaml", "capture:\n  width: 320\n  hight: 240\n");
  const CheckedConfiguration checked = CheckConfiguration(bad);
  EXPECT_EQ(checked.finding.verdict, Verdict::kError);
  EXPECT_THAT(checked.finding.text, AllOf(HasSubstr("bad.yaml:3"), HasSubstr("hight")));
  EXPECT_THAT(checked.finding.remedy, HasSubstr("bad.yaml'"));
  EXPECT_EQ(checked.configuration.capture.width, CaptureConfig().width);
  EXPECT_EQ(CheckConfiguration((folder_.path() / "none.yaml").string()).finding.verdict,
            Verdict::kError);
}

TEST_F(FileChecksTest, TellsOfFilesThatAreMissingOrDamaged) {
  Configuration configuration;
  configuration.files.model = folder_.path() / "missing.model";
  configuration.files.environment_map = Write("damaged.map", "this is no map");
  const auto findings = CheckFiles(configuration);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].verdict, Verdict::kError);
  EXPECT_THAT(findings[0].text, HasSubstr("missing.model"));
  EXPECT_THAT(findings[0].remedy, AllOf(StartsWith("fallen-train"), HasSubstr("missing.model'")));
  EXPECT_EQ(findings[1].verdict, Verdict::kError);
  EXPECT_THAT(findings[1].text, HasSubstr("damaged.map"));
  EXPECT_THAT(findings[1].remedy, StartsWith("fallen-map"));
  configuration.files.environment_map.clear();
  configuration.files.model = Write("damaged.model", std::string(100, '\x7f'));
  EXPECT_EQ(CheckFiles(configuration)[0].verdict, Verdict::kError);
  EXPECT_EQ(CheckFiles(configuration)[1].verdict, Verdict::kOk);
}

TEST_F(FileChecksTest, FindsProgramsOnTheSearchPath) {
  const std::string program = Write("lcm-logger", "#!/bin/sh\n");
  Write("lcm.jar", "");
  const std::string path = "/nowhere:" + folder_.path().string();
  const auto not_executable = CheckPrograms(path, folder_.path());
  EXPECT_EQ(not_executable[0].verdict, Verdict::kWarning);
  EXPECT_EQ(not_executable[0].remedy, "sudo apt-get install -y liblcm-bin");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto findings = CheckPrograms(path, folder_.path());
  ASSERT_EQ(findings.size(), 5U);
  EXPECT_EQ(findings[0].verdict, Verdict::kOk);
  EXPECT_EQ(findings[0].text, program);
  EXPECT_EQ(findings[1].verdict, Verdict::kWarning);  // lcm-logplayer
  EXPECT_EQ(findings[2].remedy, "sudo apt-get install -y default-jre-headless");
  EXPECT_EQ(findings[3].verdict, Verdict::kOk);  // lcm.jar
  EXPECT_EQ(findings[4].remedy, "sudo apt-get install -y libjchart2d-java");
  EXPECT_EQ(ExitStatusOf(findings), 0);
}

}  // namespace
}  // namespace fallen
