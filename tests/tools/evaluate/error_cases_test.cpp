// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/error_cases.hpp"

#include <gmock/gmock.h>

#include "fallen/evaluation/frame_outcome.hpp"
#include "fallen/messages/model_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/common/plain_model.hpp"
#include "tools/evaluate/error_report.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kEnoughCells = 150;

OrientedBox BoxAt(double x, double y) { return {{x, y, 0.15}, {1.8, 0.6, 0.3}, 0}; }

Decision Clusters(const std::vector<std::pair<Eigen::Vector3d, double>>& clusters) {
  Decision decision;
  decision.frame = MapFrame::kWorld;
  decision.min_probability = 0.5;
  for (const auto& [centroid, probability] : clusters) {
    PersonHypothesis& hypothesis = decision.hypotheses.emplace_back();
    hypothesis.centroid = centroid;
    hypothesis.probability = probability;
  }
  return decision;
}

GroundTruth PersonAt(double x, double y) {
  GroundTruth truth;
  truth.person_box = BoxAt(x, y);
  return truth;
}

TEST(ErrorCases, APersonIsOneCaseOverAllFrames) {
  CaseCollector collector("a.lcm");
  collector.Add(0, Clusters({}), PersonAt(2, 0), kMinCellsInBox - 1);  // not present
  collector.Add(1, Clusters({}), PersonAt(2, 0), kEnoughCells);
  collector.Add(2, Clusters({{{2, 0, 0.1}, 0.3}}), PersonAt(2, 0), 2 * kEnoughCells);
  collector.Add(3, Clusters({{{2, 0, 0.1}, 0.7}}), PersonAt(2.01, 0), 3 * kEnoughCells);
  const auto cases = collector.cases();
  ASSERT_EQ(cases.size(), 1u);
  EXPECT_TRUE(cases[0].is_miss);
  EXPECT_EQ(cases[0].probability, 0.7);
  EXPECT_EQ(cases[0].frames, 3);
  EXPECT_EQ(cases[0].at_fault, 2);
  EXPECT_EQ(cases[0].frame, 2);  // missed, and seen best
  EXPECT_EQ(cases[0].kind, "fallen_person");
}

TEST(ErrorCases, AFalseAlarmIsOneCaseHoweverItWanders) {
  GroundTruth truth;
  truth.objects.push_back({"furniture", "sofa", 1, {{1, 1, 0.4}, {2, 1, 0.8}, 0}});
  truth.objects.push_back({"dog", "dog", 2, {{1, 0.3, 0.2}, {0.8, 0.3, 0.4}, 0}});
  CaseCollector collector("a.lcm");
  collector.Add(0, Clusters({{{1.1, 0.35, 0.2}, 0.4}, {{4, 4, 0.2}, 0.6}}), truth, 0);
  collector.Add(1, Clusters({{{0.9, 0.3, 0.2}, 0.8}}), truth, 0);
  collector.Add(2, Clusters({{{1.3, 0.3, 0.2}, 0.5}}), truth, 0);
  const auto cases = collector.cases();
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_FALSE(cases[0].is_miss);
  EXPECT_EQ(cases[0].kind, "dog");
  EXPECT_EQ(cases[0].probability, 0.8);
  EXPECT_EQ(cases[0].frame, 1);
  EXPECT_EQ(cases[0].frames, 3);
  EXPECT_EQ(cases[0].at_fault, 2);
  EXPECT_EQ(cases[1].kind, "unlabelled");
}

TEST(ErrorCases, BesideAPersonIsSaidSo) {
  CaseCollector collector("a.lcm");
  collector.Add(0, Clusters({{{2, 0.5, 0.2}, 0.9}}), PersonAt(2, 0), kEnoughCells);
  const auto cases = collector.cases();
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[1].kind, "beside_fallen_person");
}

ErrorCase Case(bool is_miss, double probability, std::int64_t at_fault, const std::string& log) {
  ErrorCase error;
  error.is_miss = is_miss;
  error.probability = probability;
  error.at_fault = at_fault;
  error.log = log;
  return error;
}

TEST(ErrorCases, TheWorstComeFirst) {
  const WorstCases worst =
      PickWorstCases({Case(true, 0.3, 4, "b"), Case(true, 0, 1, "a"), Case(true, 0.9, 0, "found"),
                      Case(true, 0, 2, "c"), Case(false, 0.6, 1, "x"), Case(false, 0.9, 1, "y"),
                      Case(false, 0.2, 0, "below")},
                     2);
  ASSERT_EQ(worst.misses.size(), 2u);
  EXPECT_EQ(worst.misses[0].log, "c");
  EXPECT_EQ(worst.misses[1].log, "a");
  ASSERT_EQ(worst.false_alarms.size(), 2u);
  EXPECT_EQ(worst.false_alarms[0].log, "y");
}

TEST(ErrorPage, ShowsEachCaseAndNothingFromElsewhere) {
  ErrorCase error = Case(true, 0.25, 3, "/some/where/a<b.lcm");
  error.kind = "fallen_person";
  error.frames = 5;
  const std::string page = ErrorPage({{error}, {}}, {1, 40, 0.77});
  EXPECT_THAT(page, HasSubstr("miss-01.png"));
  EXPECT_THAT(page, HasSubstr("a&lt;b.lcm"));
  EXPECT_THAT(page, HasSubstr("3 of 5 frames missed"));
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(page, HasSubstr("None."));
  EXPECT_THAT(page, Not(HasSubstr("http")));
}

TEST(FallenEvaluate, WritesAReport) {
  const TemporaryFolder folder;
  const std::filesystem::path recording = folder / "drive";
  lying_scene::WriteDirectory(recording, 2, lying_scene::With::kNobody, true);
  folder.Write("drive/labels.yaml", "person: {present: false}\n");
  SaveModel(folder / "plain.model", PlainModel());
  const std::filesystem::path report = folder / "report";
  const ProgramOutcome outcome = RunProgram(
      "fallen-evaluate", {recording.string(), "--model", (folder / "plain.model").string(),
                          "--report", report.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto cases = nlohmann::json::parse(ReadText(report / "cases.json"));
  EXPECT_TRUE(cases.at("misses").empty());
  ASSERT_FALSE(cases.at("false_alarms").empty());  // the wall
  const auto& first = cases.at("false_alarms").at(0);
  for (const char* key : {"recording", "frame", "place", "p", "kind"})
    EXPECT_TRUE(first.contains(key)) << key;
  EXPECT_THAT(ReadText(report / first.at("picture").get<std::string>()),
              testing::StartsWith("\x89PNG"));
  EXPECT_THAT(ReadText(report / "index.html"), HasSubstr("false-alarm-01.png"));
}

TEST(FallenEvaluate, MeasuresThePaperBesideTheDetector) {
  const TemporaryFolder folder;
  const std::filesystem::path recording = folder / "drive";
  lying_scene::WriteDirectory(recording, 2, lying_scene::With::kNobody, true);
  folder.Write("drive/labels.yaml", "person: {present: false}\n");
  const std::filesystem::path json = folder / "figures.json";
  const ProgramOutcome outcome = RunProgram(
      "fallen-evaluate", {recording.string(), "--preset", "paper", "--json", json.string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto figures = nlohmann::json::parse(ReadText(json));
  EXPECT_EQ(figures.at("detector").at("frames"), 2);
  EXPECT_EQ(figures.at("compared").at("paper").at("frames"), 2);
  const ProgramOutcome wrong =
      RunProgram("fallen-evaluate", {recording.string(), "--preset", "papers"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(IsOneLine(wrong.err)) << wrong.err;
}

}  // namespace
}  // namespace fallen
