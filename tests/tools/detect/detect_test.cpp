// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/detect.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/messages/model_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"
#include "tools/detect/stage_medians.hpp"
#include "tools/import/import_log.hpp"

namespace fallen {
namespace {

using lying_scene::With;
using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr int kFrames = 4;

/// A recording directory of a person, its log, a model and a configuration, in a folder.
class DetectTest : public testing::Test {
 protected:
  DetectTest() {
    lying_scene::WriteDirectory(path("room"), kFrames, With::kPerson, true);
    ImportDirectory(path("room"), path("room.lcm"), "CAMERA");
    SaveModel(path("plain.model"), PlainModel());
    folder_.Write("config.yaml", "ndt:\n  max_range_m: 3.2\n");
  }

  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  DetectOptions Options(const std::string& input, const std::string& json_name) const {
    DetectOptions options;
    options.input = path(input);
    options.detector.config = path("config.yaml");
    options.detector.model = path("plain.model").string();
    options.json = path(json_name).string();
    return options;
  }

  /// Lines of a file, without the times, which differ from run to run.
  std::vector<json> ReadLines(const std::string& name) const {
    std::ifstream in(path(name));
    std::vector<json> lines;
    for (std::string line; std::getline(in, line);) {
      lines.push_back(json::parse(line));
      EXPECT_EQ(lines.back()["milliseconds"].size(), 7u);
      lines.back().erase("milliseconds");
    }
    return lines;
  }

  TemporaryFolder folder_;
};

TEST_F(DetectTest, FindsThePersonInEveryFrame) {
  const DetectSummary summary = RunDetect(Options("room.lcm", "out.json"));
  EXPECT_EQ(SummaryLine(summary), "frames 4 decisions 4 persons 4 damaged 0");
  EXPECT_GT(summary.median_milliseconds.total, 0);
  const std::vector<json> lines = ReadLines("out.json");
  ASSERT_EQ(lines.size(), 4u);
  for (int i = 0; i < kFrames; ++i) {
    EXPECT_EQ(lines[i]["frame"], i);
    EXPECT_EQ(lines[i]["utime"], 1'000'000 + 100'000 * i);
    const auto place = lines[i]["persons"].at(0)["centroid"].get<std::vector<double>>();
    EXPECT_TRUE(lying_scene::Person().Contains(Eigen::Vector3d(place.data())));
  }
}

TEST_F(DetectTest, ADirectoryAndItsLogGiveTheSamePersons) {
  RunDetect(Options("room.lcm", "log.json"));
  RunDetect(Options("room", "directory.json"));
  EXPECT_EQ(ReadLines("log.json"), ReadLines("directory.json"));
}

TEST_F(DetectTest, TheOutputHoldsEveryStagesMessagesOfEveryFrame) {
  DetectOptions options = Options("room.lcm", "out.json");
  options.output = path("out.lcm");
  RunDetect(options);

  std::map<std::string, int> counts;
  std::vector<json> from_log;
  LogReader reader(path("out.lcm"));
  while (const std::optional<LogEvent> event = reader.Next()) {
    ++counts[event->channel];
    if (event->channel != "FALLEN_PERSONS_CAMERA") continue;
    const Decoded<fallen_persons_t> message = DecodeMessage<fallen_persons_t>(event->data);
    ASSERT_TRUE(message) << message.error;
    EXPECT_EQ(message.message->header.utime, event->utime);
    from_log.push_back(
        json::parse(FrameJson(event->utime, message.message->header.seq,
                              FromMessage(*message.message), {}, ListedPersons::kAccepted)));
    from_log.back().erase("milliseconds");
  }
  EXPECT_EQ(counts, (std::map<std::string, int>{{"NDT_MAP_CAMERA", kFrames},
                                                {"FOREGROUND_CAMERA", kFrames},
                                                {"CLUSTERS_CAMERA", kFrames},
                                                {"FALLEN_PERSONS_CAMERA", kFrames}}));
  EXPECT_EQ(from_log, ReadLines("out.json"));
}

TEST_F(DetectTest, EachStageReplayedFromItsMessageGivesTheNextMessage) {
  DetectOptions options = Options("room.lcm", "out.json");
  options.output = path("out.lcm");
  RunDetect(options);

  const Model model = PlainModel();
  std::map<std::string, std::vector<std::uint8_t>> last;
  LogReader reader(path("out.lcm"));
  while (const std::optional<LogEvent> event = reader.Next()) {
    const auto header = [&](const auto& message) { return FromMessage(message.header); };
    if (event->channel == "FOREGROUND_CAMERA") {
      const ndt_map_t map = *DecodeMessage<ndt_map_t>(last["NDT_MAP_CAMERA"]).message;
      const ForegroundMap foreground = BackgroundSubtractor().Subtract(NdtMapFromMessage(map));
      EXPECT_EQ(EncodeMessage(ToMessage(header(map), foreground)), event->data);
    }
    if (event->channel == "CLUSTERS_CAMERA") {
      const ndt_map_t map = *DecodeMessage<ndt_map_t>(last["FOREGROUND_CAMERA"]).message;
      const SegmentedMap segmented =
          SegmentCells(ForegroundFromMessage(map), model.cells, model.segmentation);
      EXPECT_EQ(EncodeMessage(ToMessage(header(map), segmented)), event->data);
    }
    if (event->channel == "FALLEN_PERSONS_CAMERA") {
      const clusters_t clusters = *DecodeMessage<clusters_t>(last["CLUSTERS_CAMERA"]).message;
      const Decision decision = ClassifyClusters(FromMessage(clusters), model.clusters);
      EXPECT_EQ(EncodeMessage(ToMessage(header(clusters), decision)), event->data);
    }
    last[event->channel] = event->data;
  }
}

TEST_F(DetectTest, DamageIsCountedAndNeverFatal) {
  std::string bytes = ReadText(path("room.lcm"));
  bytes.insert(bytes.size() / 2, std::string(1000, 'x'));
  std::ofstream(path("damaged.lcm"), std::ios::binary) << bytes;
  const DetectSummary summary = RunDetect(Options("damaged.lcm", "out.json"));
  EXPECT_GE(summary.damage.count, 1);
  EXPECT_GE(summary.decisions, kFrames - 1);
  EXPECT_EQ(summary.decisions, summary.frames);
}

TEST_F(DetectTest, AnEnvironmentMapTakesTheKnownAway) {
  // The map of the room holds what the first frame shows: then nothing is left to be found.
  Detector detector = MakeDetector(Options("room.lcm", "-").detector);
  const FrameResult result = detector.Detect(lying_scene::Render(0, 0, With::kPerson));
  SaveEnvironmentMap(path("room.map"), {0.05, result.foreground.map.cells}, "test");
  DetectOptions options = Options("room.lcm", "out.json");
  options.detector.environment_map = path("room.map").string();
  EXPECT_EQ(RunDetect(options).persons, 0);
}

TEST_F(DetectTest, TheProgramPrintsLinesAndTheSummary) {
  const ProgramOutcome outcome = RunProgram(
      "fallen-detect", {path("room.lcm").string(), "--model", path("plain.model").string(),
                        "--config", path("config.yaml").string(), "--all-candidates"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, StartsWith(R"({"utime":1000000,"frame":0,"persons":[{)"));
  EXPECT_THAT(outcome.out, HasSubstr(R"("accepted":true)"));
  EXPECT_THAT(outcome.err, EndsWith("frames 4 decisions 4 persons 4 damaged 0\n"));
}

TEST_F(DetectTest, AWrongCallOrInputIsOneLineAndStatusTwo) {
  const std::string log = path("room.lcm").string();
  const std::string model = path("plain.model").string();
  folder_.Write("typo.yaml", "ndt:\n  max_rnage_m: 3\n");
  folder_.Write("coarse.yaml", "ndt:\n  cell_size_m: 0.1\n");
  LogWriter(path("no_depth.lcm")).Write(0, "OTHER", {1, 2, 3});
  const std::vector<std::vector<std::string>> calls = {
      {},
      {log, "--model", model, "--lossless", "--realtime"},
      {log, "--model", model, "--fast"},
      {log, "--model", log},
      {log, "--model", path("missing.model").string()},
      {log, "--model", model, "--map", model},
      {log, "--model", model, "--camera", "BACK"},
      {log, "--model", model, "--config", path("typo.yaml").string()},
      {log, "--model", model, "--config", path("coarse.yaml").string()},
      {log, "--model", model, "--json", "/nowhere/out.json"},
      {log, "--model", model, "--output", "/nowhere/out.lcm"},
      {path("no_depth.lcm").string(), "--model", model},
      {path("missing.lcm").string(), "--model", model}};
  for (const std::vector<std::string>& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-detect", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("fallen-detect: "));
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(RunProgram("fallen-detect", calls[7]).err, HasSubstr("typo.yaml:2: ndt.max_rnage_m"));
}

TEST(MedianTimes, TakesTheMiddleOfEachStage) {
  StageTimes a;
  a.ground = 1;
  a.total = 30;
  StageTimes b;
  b.ground = 5;
  b.total = 10;
  StageTimes c;
  c.ground = 2;
  c.total = 20;
  const StageTimes medians = MedianTimes({a, b, c});
  EXPECT_EQ(medians.ground, 2);
  EXPECT_EQ(medians.total, 20);
  EXPECT_EQ(MedianTimes({}).total, 0);
  EXPECT_EQ(DescribeTimes(medians),
            "ground 2.0 ndt 0.0 background 0.0 iron 0.0 cells 0.0 clusters 0.0 total 20.0");
}

}  // namespace
}  // namespace fallen
