// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/evaluation_report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fallen {
namespace {

DetectionErrorTradeoff SomeCurve() {
  std::vector<FrameOutcome> outcomes;
  for (int i = 0; i < 100; ++i) {
    const double score = 0.2 + 0.007 * i;
    outcomes.push_back({true, score, {}});
    outcomes.push_back({false, std::nullopt, {score - 0.3}});
  }
  return ComputeTradeoff(outcomes);
}

TEST(EvaluationReport, HasTheDocumentedFields) {
  const nlohmann::json figures = FiguresJson(SomeCurve(), 0.5);
  EXPECT_EQ(figures.at("frames"), 200);
  EXPECT_EQ(figures.at("positives"), 100);
  for (const char* key :
       {"miss_rate_at_0.01_fppf", "miss_rate_at_0.1_fppf", "log_average_miss_rate"})
    EXPECT_TRUE(figures.at(key).is_number()) << key;
  const nlohmann::json& chosen = figures.at("at_default_threshold");
  EXPECT_EQ(chosen.at("true_positives").get<int>() + chosen.at("misses").get<int>(), 100);
  EXPECT_EQ(chosen.at("true_positives"), 57);
  EXPECT_EQ(chosen.at("false_positives"), 14);
}

TEST(EvaluationReport, RatesWithoutPositivesAreNull) {
  const nlohmann::json figures =
      FiguresJson(ComputeTradeoff(std::vector<FrameOutcome>{{false, std::nullopt, {0.5}}}), 0.4);
  EXPECT_EQ(figures.dump().find("nan"), std::string::npos);
  EXPECT_NE(figures.dump().find("\"miss_rate_at_0.01_fppf\":null"), std::string::npos);
}

SequenceOutcome Drive(std::vector<std::string> kinds, double false_score) {
  SequenceOutcome drive;
  drive.kinds = std::move(kinds);
  drive.frames = {{true, 0.9, {}}, {false, std::nullopt, {false_score}}};
  return drive;
}

TEST(EvaluationReport, CountsWhatEachKindIsTakenFor) {
  const auto kinds =
      KindsJson({Drive({"cat", "dog"}, 0.8), Drive({"dog"}, 0.1), Drive({}, 0.9)}, 0.5);
  EXPECT_EQ(kinds.size(), 2u);
  EXPECT_EQ(kinds.at("dog").at("sequences"), 2);
  EXPECT_EQ(kinds.at("dog").at("frames"), 4);
  EXPECT_EQ(kinds.at("dog").at("false_positives_per_frame"), 0.25);
  EXPECT_EQ(kinds.at("cat").at("flagged_frames"), 0.5);
}

TEST(EvaluationReport, IntervalsHoldTheFigures) {
  std::vector<SequenceOutcome> drives;
  for (int i = 0; i < 40; ++i) drives.push_back(Drive({}, i % 4 == 0 ? 0.8 : 0.1));
  const auto figures = FiguresJson(drives, 0.5, BootstrapConfig{});
  EXPECT_EQ(figures.at("frames"), 80);
  const double rate = figures.at("at_default_threshold").at("false_positives_per_frame");
  const auto& interval =
      figures.at("intervals").at("at_default_threshold").at("false_positives_per_frame");
  EXPECT_DOUBLE_EQ(rate, 0.125);
  // Binomial over drives: 0.5 sqrt(0.25 * 0.75 / 40) = 0.034, 1.96 of it 0.067.
  EXPECT_NEAR(interval.at(0).get<double>(), 0.125 - 0.067, 0.02);
  EXPECT_NEAR(interval.at(1).get<double>(), 0.125 + 0.067, 0.02);
}

TEST(EvaluationReport, DrawsACurve) {
  if (std::system("command -v gnuplot >/dev/null") != 0) GTEST_SKIP() << "gnuplot is not there";
  const auto path = std::filesystem::path(testing::TempDir()) / "fallen's curve.svg";
  PlotCurves({{"detector", SomeCurve()}}, path);
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_NE(text.str().find("false positives per frame"), std::string::npos);
  EXPECT_NE(text.str().find("detector"), std::string::npos);
  std::filesystem::remove(path);
  EXPECT_THROW(PlotCurves({{"detector", SomeCurve()}}, "/nowhere/curve.svg"), std::runtime_error);
}

}  // namespace
}  // namespace fallen
