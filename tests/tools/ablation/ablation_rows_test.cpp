// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/ablation_rows.hpp"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/ablation/finished_rows.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

std::vector<AblationRow> Rows(const std::string& text) {
  const TemporaryFolder folder;
  return LoadAblationRows(folder.Write("rows.yaml", text), TrainingConfig{});
}

std::string ErrorOf(const std::string& text) {
  try {
    Rows(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

constexpr char kRows[] =
    "training: {boosting: {rounds: 7}}\n"
    "rows:\n"
    "  - name: base\n"
    "  - {name: old map, map: stale}\n"
    "  - {name: rough, segmentation: {smoothing_radius_m: 0}}\n"
    "  - {name: deep, training: {boosting: {max_depth: 6}}}\n"
    "  - {name: sides, oriented_normals: true}\n";

TEST(AblationRows, SayWhatDiffersFromWhatAllShare) {
  const auto rows = Rows(kRows);
  ASSERT_EQ(rows.size(), 5u);
  for (const AblationRow& row : rows) EXPECT_EQ(row.training.boosting.rounds, 7);
  EXPECT_TRUE(rows[0].retrains);
  EXPECT_FALSE(rows[1].retrains);
  EXPECT_EQ(rows[1].map, MapAge::kStale);
  EXPECT_FALSE(rows[2].retrains);
  EXPECT_EQ(rows[2].segmentation.smoothing_radius_m, 0);
  EXPECT_GT(rows[2].training.segmentation.smoothing_radius_m, 0);
  EXPECT_TRUE(rows[3].retrains);
  EXPECT_EQ(rows[3].training.boosting.max_depth, 6);
  EXPECT_NE(rows[3].Settings(), rows[0].Settings());
  EXPECT_EQ(rows[3].training.signs, NormalSigns::kArbitrary);
  EXPECT_TRUE(rows[4].retrains);
  EXPECT_EQ(rows[4].training.signs, NormalSigns::kOriented);
  EXPECT_NE(rows[4].Settings(), rows[0].Settings());
}

TEST(AblationRows, NameTheLineThatIsWrong) {
  EXPECT_THAT(ErrorOf("rows: []\n"), HasSubstr("rows.yaml:1: rows: got none"));
  EXPECT_THAT(ErrorOf("rows:\n  - {name: a, maps: fresh}\n"), HasSubstr("rows.yaml:2: rows.maps"));
  EXPECT_THAT(ErrorOf("rows:\n  - {name: a}\n  - {name: a}\n"),
              HasSubstr("rows.yaml:3: rows: got two"));
  EXPECT_THAT(ErrorOf("rows:\n  - {name: a, training: {observation: {frame_stride: 9}}}\n"),
              HasSubstr("observation"));
  EXPECT_THAT(ErrorOf("rows:\n  - {name: a, training: {boosting: {rounds: 0}}}\n"),
              HasSubstr("rows.yaml:2"));
  EXPECT_THAT(ErrorOf("rows:\n  - {name: a, oriented_normals: true}\n"),
              HasSubstr("rows.yaml:2: rows: got oriented_normals in the first"));
}

TEST(AblationRows, OfTheProjectAreValid) {
  const std::filesystem::path models = std::filesystem::path(FALLEN_SOURCE_DIR) / "models";
  const auto rows =
      LoadAblationRows(models / "ablation.yaml", LoadTrainingConfig(models / "training.yaml"));
  EXPECT_GT(rows.size(), 15u);
}

nlohmann::json Figures(double rate) {
  return {{"miss_rate_at_0.01_fppf", rate},
          {"miss_rate_at_0.1_fppf", rate / 2},
          {"log_average_miss_rate", nullptr},
          {"intervals",
           {{"miss_rate_at_0.01_fppf", {rate - 0.1, rate + 0.1}},
            {"miss_rate_at_0.1_fppf", {0.0, 1.0}},
            {"log_average_miss_rate", {nullptr, nullptr}}}}};
}

TEST(FinishedRows, AreTakenOnlyWithTheSameSettingsAndData) {
  const TemporaryFolder folder;
  const auto rows = Rows(kRows);
  const FinishedRows finished(folder / "rows", "12 recordings");
  EXPECT_FALSE(finished.Find(rows[1]));
  finished.Keep(rows[1], Figures(0.5), {1, 2});
  ASSERT_TRUE(finished.Find(rows[1]));
  EXPECT_EQ(finished.Find(rows[1])->at("figures").at("miss_rate_at_0.01_fppf"), 0.5);
  EXPECT_EQ(finished.Find(rows[1])->at("outcomes"), nlohmann::json({1, 2}));
  EXPECT_FALSE(finished.Find(rows[2]));
  EXPECT_FALSE(FinishedRows(folder / "rows", "13 recordings").Find(rows[1]));
  AblationRow other = rows[1];
  other.segmentation.min_cluster_cells += 1;
  EXPECT_FALSE(finished.Find(other));
}

TEST(FinishedRows, MakeATable) {
  const nlohmann::json difference = {
      {"log_average_miss_rate", {{"difference", -0.02}, {"interval", {-0.05, 0.0125}}}}};
  const std::string table =
      MarkdownTable({{{"name", "base"}, {"figures", Figures(0.25)}},
                     {{"name", "other"}, {"figures", Figures(0.25)}, {"difference", difference}}});
  EXPECT_THAT(table,
              HasSubstr("| base | 0.250 (0.150–0.350) | 0.125 (0.000–1.000) | – (–––) |  |"));
  EXPECT_THAT(table, HasSubstr("| other | 0.250 (0.150–0.350) | 0.125 (0.000–1.000) | – (–––) | "
                               "-0.020 (-0.050 to +0.013) |"));
}

}  // namespace
}  // namespace fallen
