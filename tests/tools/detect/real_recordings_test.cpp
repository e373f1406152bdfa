// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.hpp"
#include "tools/detect/detect.hpp"

namespace fallen {
namespace {

struct Real {
  const char* name;
  std::int64_t frames;
};

class RealRecording : public testing::TestWithParam<Real> {};

TEST_P(RealRecording, HasEveryFrameDecided) {
  const std::filesystem::path source = FALLEN_SOURCE_DIR;
  DetectOptions options;
  options.input = source / ".." / "shared" / "real" / GetParam().name;
  options.detector.model = (source / "models" / "fallen.model").string();
  if (!std::filesystem::exists(options.input)) GTEST_SKIP() << options.input << " is not here";
  if (!std::filesystem::exists(options.detector.model)) GTEST_SKIP() << "no model is here";
  const TemporaryFolder folder;
  options.json = (folder.path() / "out.json").string();
  const DetectSummary summary = RunDetect(options);
  EXPECT_EQ(summary.frames, GetParam().frames);
  EXPECT_EQ(summary.decisions, GetParam().frames);
  EXPECT_EQ(summary.damage.count, 0) << summary.damage.example;
  RecordProperty("persons", std::to_string(summary.persons));  // nobody lies there: false alarms
}

INSTANTIATE_TEST_SUITE_P(All, RealRecording,
                         testing::Values(Real{"urfd-fall-01", 98}, Real{"7-scenes-kitchen", 100},
                                         Real{"pcl-office", 4}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace fallen
