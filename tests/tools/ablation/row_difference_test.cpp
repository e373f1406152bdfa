// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/ablation/row_difference.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tools/evaluate/evaluation_report.hpp"

namespace fallen {
namespace {

// Recordings of ten frames with a person each; in recording i the first `found(i)` are found, and
// the strongest false hypothesis is weaker than any of them.
template <class Found>
std::vector<SequenceOutcome> Drives(int count, const Found& found) {
  std::vector<SequenceOutcome> drives(count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 10; ++k) {
      FrameOutcome frame{true, std::nullopt, {0.1 + 0.001 * i}};
      if (k < found(i)) frame.hit_score = 0.9 - 0.01 * k;
      drives[i].frames.push_back(frame);
    }
  return drives;
}

double Rate(const nlohmann::json& difference, const char* key, const char* what) {
  return difference.at(key).at(what).get<double>();
}

TEST(RowDifference, OfARowFromItselfIsNothing) {
  const auto drives = OutcomesJson(Drives(8, [](int i) { return i; }));
  const auto difference = DifferenceJson(drives, drives, {});
  for (const char* key :
       {"miss_rate_at_0.01_fppf", "miss_rate_at_0.1_fppf", "log_average_miss_rate"}) {
    EXPECT_EQ(Rate(difference, key, "difference"), 0);
    EXPECT_EQ(difference.at(key).at("interval"), nlohmann::json({0.0, 0.0}));
  }
}

TEST(RowDifference, IsThatOfTheFiguresAndCertainWhereEachDriveGains) {
  const auto first = Drives(8, [](int i) { return i; });
  const auto better = Drives(8, [](int i) { return i + 2; });
  const auto difference = DifferenceJson(OutcomesJson(first), OutcomesJson(better), {});
  const auto of_first = FiguresJson(first, 0.5, {}), of_better = FiguresJson(better, 0.5, {});
  for (const char* key :
       {"miss_rate_at_0.01_fppf", "miss_rate_at_0.1_fppf", "log_average_miss_rate"})
    EXPECT_NEAR(Rate(difference, key, "difference"),
                of_better.at(key).get<double>() - of_first.at(key).get<double>(), 1e-12);
  // Two frames of ten more in every drive, whichever are drawn, though the drives differ much.
  const auto& interval = difference.at("miss_rate_at_0.1_fppf").at("interval");
  EXPECT_NEAR(interval.at(0).get<double>(), -0.2, 1e-9);
  EXPECT_NEAR(interval.at(1).get<double>(), -0.2, 1e-9);
  const auto& alone = of_first.at("intervals").at("miss_rate_at_0.1_fppf");
  EXPECT_GT(alone.at(1).get<double>() - alone.at(0).get<double>(), 0.2);
}

TEST(RowDifference, IsUncertainWhereFewDrivesDecide) {
  const auto first = OutcomesJson(Drives(8, [](int) { return 5; }));
  const auto one_changed = OutcomesJson(Drives(8, [](int i) { return i == 3 ? 10 : 5; }));
  const auto difference = DifferenceJson(first, one_changed, {});
  const auto& interval = difference.at("miss_rate_at_0.1_fppf").at("interval");
  EXPECT_NEAR(Rate(difference, "miss_rate_at_0.1_fppf", "difference"), -0.0625, 1e-9);
  EXPECT_EQ(interval.at(1).get<double>(), 0);
  EXPECT_LT(interval.at(0).get<double>(), -0.1);
}

TEST(RowDifference, RefusesRowsOfOtherFrames) {
  const auto drives = Drives(3, [](int) { return 5; });
  auto fewer = drives;
  fewer[1].frames.pop_back();
  EXPECT_THROW(DifferenceJson(OutcomesJson(drives), OutcomesJson(fewer), {}),
               std::invalid_argument);
  fewer.pop_back();
  EXPECT_THROW(DifferenceJson(OutcomesJson(drives), OutcomesJson(fewer), {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace fallen
