// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr char kDoctor[] = FALLEN_BIN_DIR "/fallen-doctor";

/// How this user may make a network of his own, or "".
std::string Unshare() {
  for (const char* command : {"unshare -n", "unshare -rn"})
    if (RunShell(std::string(command) + " true 2>/dev/null").status == 0) return command;
  return "";
}

/// Runs `script` in a fresh network name space: nothing but a loopback that is down.
ProgramOutcome RunInFreshNetwork(const std::string& script) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "script") << script;
  return RunShell(Unshare() + " sh " + (folder.path() / "script").string());
}

/// The finding about `check` in the JSON that the doctor printed.
json FindingOf(const std::string& output, const std::string& check) {
  const json report = json::parse(output);
  for (const json& finding : report["findings"])
    if (finding["check"] == check) return finding;
  ADD_FAILURE() << "no finding about " << check << " in " << output;
  return {};
}

std::string WithoutSudo(std::string command) {
  for (std::size_t at; (at = command.find("sudo ")) != std::string::npos;) command.erase(at, 5);
  return command;
}

class DoctorInNetworkTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (Unshare().empty()) GTEST_SKIP() << "network name spaces are not allowed here";
    if (RunShell("ip link >/dev/null 2>&1").status != 0) GTEST_SKIP() << "ip (iproute2) is missing";
  }
};

TEST_F(DoctorInNetworkTest, FindsThatThereIsNoRouteAndItsRemedyMendsIt) {
  const ProgramOutcome before = RunInFreshNetwork(std::string(kDoctor) + " --json 2>/dev/null");
  EXPECT_EQ(before.status, 1);
  const json route = FindingOf(before.out, "multicast route");
  EXPECT_EQ(route["verdict"], "error");
  EXPECT_EQ(FindingOf(before.out, "LCM loopback")["verdict"], "error");
  const ProgramOutcome after =
      RunInFreshNetwork(WithoutSudo(route["remedy"]) + "\n" + kDoctor + " --json 2>/dev/null");
  EXPECT_EQ(FindingOf(after.out, "multicast route")["verdict"], "ok");
  const json loopback = FindingOf(after.out, "LCM loopback");
  // The limit of buffers is the whole machine's: it cannot be mended in here.
  std::ifstream limit("/proc/sys/net/core/rmem_max");
  long bytes = 0;
  if (limit >> bytes && bytes >= 4194304) {
    EXPECT_EQ(loopback["verdict"], "ok") << loopback;
    EXPECT_THAT(loopback["text"].get<std::string>(), HasSubstr("10 of 10 messages of 614500"));
  } else {
    EXPECT_THAT(loopback["remedy"].get<std::string>(), HasSubstr("rmem_max"));
  }
}

TEST_F(DoctorInNetworkTest, FindsALoopbackThatDoesNoMulticast) {
  const std::string set_up = "ip link set lo up multicast off && ip route add 224.0.0.0/4 dev lo\n";
  const ProgramOutcome before = RunInFreshNetwork(set_up + kDoctor + " --json 2>/dev/null");
  const json route = FindingOf(before.out, "multicast route");
  EXPECT_EQ(route["verdict"], "error");
  EXPECT_EQ(route["remedy"], "sudo ip link set lo up multicast on");
  const ProgramOutcome after = RunInFreshNetwork(set_up + WithoutSudo(route["remedy"]) + "\n" +
                                                 kDoctor + " --json 2>/dev/null");
  EXPECT_EQ(FindingOf(after.out, "multicast route")["verdict"], "ok");
}

TEST_F(DoctorInNetworkTest, FindsThatABufferIsTooSmall) {
  const ProgramOutcome result = RunInFreshNetwork(
      "ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo\n" + std::string(kDoctor) +
      " --json --lcm-url 'udpm://239.255.76.67:7667?ttl=0' 2>/dev/null");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(FindingOf(result.out, "LCM URL")["verdict"], "error");
}

TEST(DoctorProgramTest, SaysWhatItFoundForPeople) {
  const ProgramOutcome result = RunShell(std::string(kDoctor) + " --lcm-url memq:// 2>/dev/null");
  EXPECT_THAT(result.out, HasSubstr("configuration: the defaults"));
  EXPECT_THAT(result.out, HasSubstr("\nerrors "));
}

TEST(DoctorProgramTest, SaysThatAModelIsDamaged) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "bad.model") << "no model at all";
  std::ofstream(folder.path() / "config.yaml") << "files: {model: bad.model}\n";
  const ProgramOutcome result =
      RunShell(std::string(kDoctor) + " --json --lcm-url memq:// --config " +
               (folder.path() / "config.yaml").string());
  EXPECT_EQ(result.status, 1);
  const json model = FindingOf(result.out, "model");
  EXPECT_EQ(model["verdict"], "error");
  EXPECT_THAT(model["text"].get<std::string>(), HasSubstr("bad.model"));
}

TEST(DoctorProgramTest, SaysThatAConfigurationIsWrong) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "config.yaml") << "service:\n  lcm_ulr: x\n";
  const ProgramOutcome result =
      RunShell(std::string(kDoctor) + " --json --lcm-url memq:// --config " +
               (folder.path() / "config.yaml").string());
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(FindingOf(result.out, "configuration")["text"].get<std::string>(),
              HasSubstr("config.yaml:2"));
}

#ifdef FALLEN_OPENNI2_DIR
TEST(DoctorProgramTest, TellsTheCamerasAndTheirModes) {
  const std::string with_camera = "LD_LIBRARY_PATH=" FALLEN_OPENNI2_DIR " ";
  const ProgramOutcome result =
      RunShell(with_camera + kDoctor + " --json --lcm-url memq:// 2>/dev/null");
  EXPECT_EQ(FindingOf(result.out, "OpenNI2")["verdict"], "ok");
  const json camera = FindingOf(result.out, "camera");
  EXPECT_EQ(camera["verdict"], "ok");
  EXPECT_THAT(camera["text"].get<std::string>(), HasSubstr("virtual://0"));
  EXPECT_THAT(camera["text"].get<std::string>(), HasSubstr("640x480 30 Hz 1mm"));
  const ProgramOutcome none = RunShell("FALLEN_VIRTUAL_CAMERA_COUNT=0 " + with_camera + kDoctor +
                                       " --json --lcm-url memq:// 2>/dev/null");
  EXPECT_EQ(FindingOf(none.out, "camera")["verdict"], "warning");
}
#endif

TEST(DoctorProgramTest, RefusesAWrongCallInOneLine) {
  for (const char* arguments : {"--nonsense", "extra", "--config"}) {
    const ProgramOutcome result =
        RunShell(std::string(kDoctor) + " " + arguments + " 2>&1 >/dev/null");
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_TRUE(IsOneLine(result.out)) << result.out;
    EXPECT_THAT(result.out, ::testing::StartsWith("fallen-doctor: "));
  }
  EXPECT_EQ(RunShell(std::string(kDoctor) + " --help").status, 0);
  EXPECT_THAT(RunShell(std::string(kDoctor) + " --version").out,
              ::testing::StartsWith("fallen-doctor "));
}

}  // namespace
}  // namespace fallen
