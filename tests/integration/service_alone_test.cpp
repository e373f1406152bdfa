// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/channels.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/support/log_detection.hpp"
#include "tests/support/synthetic_model.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen::testing_support {
namespace {

constexpr int kFrames = 30;  // one second

/// Each service by itself, fed with its input channels of a log by lcm-logplayer.
class ServiceAlone : public testing::TestWithParam<Stage> {};

TEST_P(ServiceAlone, AnswersAsTheLibraryDoesBitForBitAndReportsIt) {
  const Stage& stage = GetParam();
  const TemporaryFolder folder;
  const Model model = SyntheticModel();
  SaveModel(folder / "test.model", model);
  WriteSceneLog(folder / "input.lcm", kFrames);
  WriteStageLog(folder / "input.lcm", model, folder / "stages.lcm");
  const auto expected = BytesInLog(folder / "stages.lcm", stage.output);
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(kFrames));

  ServiceChain chain(folder / "test.model");
  chain.Start(stage);
  const service_status_t before = chain.recorder().Status(stage.service);
  EXPECT_EQ(before.service, stage.service);
  EXPECT_EQ(before.header.sensor_name, "CAMERA");
  EXPECT_EQ(before.received, 0);
  EXPECT_EQ(before.pid, chain.process(stage.service).pid());

  chain.Play(folder / "stages.lcm", stage.inputs);
  EXPECT_TRUE(chain.WaitForMessages(stage.output, expected.size()));
  chain.recorder().HandleFor(std::chrono::milliseconds(1200));  // a status after the last result
  EXPECT_EQ(chain.recorder().Bytes(stage.output), expected);

  const service_status_t after = chain.recorder().Status(stage.service);
  EXPECT_EQ(after.received, kFrames);
  EXPECT_EQ(after.published, kFrames);
  EXPECT_EQ(after.dropped_late, 0);
  EXPECT_EQ(after.dropped_damaged, 0) << after.text;
  EXPECT_EQ(after.lost_upstream, 0);
  EXPECT_EQ(after.header.utime, kFirstUtime + (kFrames - 1) * kFrameInterval_us);
  EXPECT_GT(after.median_ms, 0);
  EXPECT_GE(after.p99_ms, after.median_ms);
  EXPECT_GT(after.rate_hz, 0);
  EXPECT_GT(after.resident_bytes, 0);
  RecordProperty("resident_megabytes", static_cast<int>(after.resident_bytes >> 20));
  EXPECT_LE(after.resident_bytes, kMaxResidentBytes);
  const bool has_no_map = stage.service == "background-subtraction";
  EXPECT_EQ(after.state, has_no_map ? service_status_t::DEGRADED : service_status_t::RUNNING);
  EXPECT_EQ(after.text, has_no_map ? "no environment map: everything is foreground" : "");

  chain.process(stage.service).Signal(SIGTERM);
  EXPECT_EQ(chain.process(stage.service).WaitForExit(std::chrono::seconds(10)), 0);
  chain.recorder().HandleFor(std::chrono::milliseconds(200));
  EXPECT_EQ(chain.recorder().Status(stage.service).state, service_status_t::STOPPING);
}

TEST_P(ServiceAlone, SurvivesGarbageOnEveryInputAndCountsIt) {
  const Stage& stage = GetParam();
  const TemporaryFolder folder;
  SaveModel(folder / "test.model", SyntheticModel());
  ServiceChain chain(folder / "test.model");
  chain.Start(stage);
  const std::vector<std::uint8_t> garbage(2000, 0xFF);
  for (const char* channel :
       {"DEPTH_CAMERA", "ROBOT_POSE", "NDT_MAP_CAMERA", "FOREGROUND_CAMERA", "CLUSTERS_CAMERA"})
    for (const unsigned size : {0U, 1U, 8U, 100U, 2000U})
      chain.recorder().lcm().publish(channel, garbage.data(), size);
  const int inputs = stage.service == "ndt-mapping" ? 2 : 1;
  const bool has_counted = chain.recorder().HandleUntil(
      [&] { return chain.recorder().Status(stage.service).dropped_damaged == 5 * inputs; },
      std::chrono::seconds(10));
  EXPECT_TRUE(has_counted);
  chain.StopAll();
}

TEST_P(ServiceAlone, InterruptEndsItCleanlyToo) {
  const Stage& stage = GetParam();
  const TemporaryFolder folder;
  SaveModel(folder / "test.model", SyntheticModel());
  ServiceChain chain(folder / "test.model");
  chain.Start(stage);
  chain.process(stage.service).Signal(SIGINT);
  EXPECT_EQ(chain.process(stage.service).WaitForExit(std::chrono::seconds(10)), 0);
}

std::string ServiceName(const testing::TestParamInfo<Stage>& info) {
  return channels::Status(info.param.service).substr(7);
}
INSTANTIATE_TEST_SUITE_P(Services, ServiceAlone, testing::ValuesIn(kStages), ServiceName);

}  // namespace
}  // namespace fallen::testing_support
