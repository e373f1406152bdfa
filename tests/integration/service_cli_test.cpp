// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/channels.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/synthetic_model.hpp"

namespace fallen::testing_support {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// A model file begins with eight characters and a big-endian version of four bytes.
constexpr std::size_t kLastVersionByte = 11;

class ServiceCommandLine : public testing::TestWithParam<Stage> {
 protected:
  ServiceCommandLine() : url_(EnterPrivateNetwork()), name_("fallen-" + GetParam().service) {}

  ProgramOutcome Call(const std::vector<std::string>& arguments) {
    return RunProgram(name_, arguments);
  }

  /// Expects exit status 2 and one line on stderr with the program's name; returns the rest of it.
  std::string Complaint(const std::vector<std::string>& arguments) {
    const ProgramOutcome outcome = Call(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::string& error = outcome.err;
    EXPECT_TRUE(IsOneLine(error)) << error;
    EXPECT_THAT(error, StartsWith(name_ + ": "));
    return error.substr(std::min(error.size(), name_.size() + 2));
  }

  std::string Write(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return (folder_ / name).string();
  }

  std::string url_;
  std::string name_;
  TemporaryFolder folder_;
};

/// Services that load a model.
class ModelCommandLine : public ServiceCommandLine {};
/// Services that load an environment map.
class MapCommandLine : public ServiceCommandLine {};

TEST_P(ServiceCommandLine, HelpNamesTheCommonFlags) {
  const ProgramOutcome outcome = Call({"--help"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("--config"), HasSubstr("--lcm-url"), HasSubstr("--camera"),
                    HasSubstr("--lossless"), HasSubstr("--version")));
  EXPECT_EQ(outcome.err, "");
}

TEST_P(ServiceCommandLine, VersionIsOneLine) {
  const ProgramOutcome outcome = Call({"--version"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, testing::MatchesRegex(name_ + " [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_P(ServiceCommandLine, WrongFlagsAreOneLine) {
  EXPECT_EQ(Complaint({"--camra", "X"}), "--camra: unknown option, see --help\n");
  EXPECT_EQ(Complaint({"surplus"}), "surplus: unexpected argument, see --help\n");
  EXPECT_THAT(Complaint({"--camera"}), HasSubstr("--camera"));
  EXPECT_THAT(Complaint({"--camera", ".*"}), HasSubstr("camera is '.*'"));
  EXPECT_THAT(Complaint({"--lcm-url", "udp://1.2.3.4:5"}), HasSubstr("udp://1.2.3.4:5"));
}

TEST_P(ServiceCommandLine, WithoutAMulticastRouteItPointsToTheDoctor) {
  if (RunCommand({"unshare", "--net", "true"}).status != 0)
    GTEST_SKIP() << "network name spaces are not allowed here";
  const ProgramOutcome outcome = RunCommand({"unshare", "--net", Program(name_)});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err,
              testing::EndsWith("is there a multicast route? (fallen-doctor tells)\n"));
}

TEST_P(ServiceCommandLine, WrongConfigurationNamesFileAndLine) {
  const std::string file = Write("wrong.yaml", "ndt:\n  min_points: 5\n  min_pionts: 6\n");
  EXPECT_THAT(Complaint({"--config", file}), StartsWith(file + ":3: ndt.min_pionts: unknown key"));
  const std::string range = Write("range.yaml", "ndt:\n  cell_size_m: -1\n");
  EXPECT_THAT(Complaint({"--config", range}), StartsWith(range + ":2: "));
  EXPECT_THAT(Complaint({"--config", "/nowhere.yaml"}), HasSubstr("/nowhere.yaml"));
}

TEST_P(ServiceCommandLine, StatelessServicesTakeAWorkersShare) {
  if (GetParam().service == "ndt-mapping") {
    EXPECT_EQ(Complaint({"--worker", "0/2"}), "--worker: unknown option, see --help\n");
    return;
  }
  EXPECT_THAT(Complaint({"--worker", "2/2"}), HasSubstr("--worker: got '2/2', expected k/n"));
}

TEST_P(ModelCommandLine, UnusableModelIsOneLine) {
  EXPECT_THAT(Complaint({"--model", "/nowhere.model"}), HasSubstr("/nowhere.model"));
  const std::string garbage = Write("garbage.model", "this is no model at all, but some text");
  EXPECT_THAT(Complaint({"--model", garbage}), HasSubstr(garbage));
  EXPECT_THAT(Complaint({"--model", Write("empty.model", "")}), HasSubstr("empty.model"));

  SaveModel(folder_ / "good.model", SyntheticModel());
  std::ifstream file(folder_ / "good.model", std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(file), {}};
  std::string damaged = good;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  EXPECT_THAT(Complaint({"--model", Write("damaged.model", damaged)}), HasSubstr("damaged.model"));
  EXPECT_THAT(Complaint({"--model", Write("half.model", good.substr(0, good.size() / 2))}),
              HasSubstr("half.model"));

  std::string newer = good;
  newer[kLastVersionByte] = 99;
  EXPECT_THAT(Complaint({"--model", Write("newer.model", newer)}),
              HasSubstr("newer.model: version: got 99, expected "));
}

TEST_P(ModelCommandLine, ModelOfAnotherCellSizeIsOneLine) {
  SaveModel(folder_ / "coarse.model", SyntheticModel(0.1));
  EXPECT_THAT(Complaint({"--model", (folder_ / "coarse.model").string()}),
              HasSubstr("coarse.model: cell_size_m: got 0.1, expected 0.05"));
  // Named by the configuration instead of the flag, relative to it.
  const std::string file = Write("model.yaml", "files:\n  model: coarse.model\n");
  EXPECT_THAT(Complaint({"--config", file}), HasSubstr("coarse.model: cell_size_m: got 0.1"));
}

TEST_P(MapCommandLine, EnvironmentMapThatDoesNotFitIsOneLine) {
  EXPECT_THAT(Complaint({"--map", "/nowhere.map"}), HasSubstr("/nowhere.map"));
  NdtCell cell;
  cell.covariance = {1e-4F, 0, 0, 1e-4F, 0, 1e-6F};
  cell.point_count = 5;
  SaveEnvironmentMap(folder_ / "coarse.map", {0.1, {cell}}, "test");
  EXPECT_THAT(Complaint({"--map", (folder_ / "coarse.map").string()}),
              HasSubstr("coarse.map: cell_size_m: got 0.1, expected 0.05"));
  SaveModel(folder_ / "a.model", SyntheticModel());
  EXPECT_THAT(Complaint({"--map", (folder_ / "a.model").string()}), HasSubstr("a.model"));
}

std::string ServiceName(const testing::TestParamInfo<Stage>& info) {
  return channels::Status(info.param.service).substr(7);
}
INSTANTIATE_TEST_SUITE_P(Services, ServiceCommandLine, testing::ValuesIn(kStages), ServiceName);
INSTANTIATE_TEST_SUITE_P(Services, ModelCommandLine, testing::Values(kStages[2], kStages[3]),
                         ServiceName);
INSTANTIATE_TEST_SUITE_P(Services, MapCommandLine, testing::Values(kStages[1]), ServiceName);

}  // namespace
}  // namespace fallen::testing_support
