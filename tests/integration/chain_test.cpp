// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "fallen/messages/model_files.hpp"
#include "tests/integration/chain_checks.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/support/log_detection.hpp"
#include "tests/support/synthetic_model.hpp"
#include "tests/support/synthetic_scene.hpp"

namespace fallen::testing_support {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kFrames = 60;  // two seconds
const std::string kPersons = "FALLEN_PERSONS_CAMERA";
const std::string kChainInputs = kStages[0].inputs;

class Chain : public testing::Test {
 protected:
  void UseSyntheticRecording() {
    recording_ = folder_ / "scene.lcm";
    model_ = folder_ / "test.model";
    WriteSceneLog(recording_, kFrames);
    SaveModel(model_, SyntheticModel());
  }

  /// Plays the recording through the four services and compares each message of each stage with the
  /// detector's in this process.
  void ExpectSameAsTheDetector(ServiceChain& chain) {
    const std::filesystem::path expected_log = folder_ / "expected.lcm";
    WriteStageLog(recording_, LoadModel(model_), expected_log);
    const std::size_t frames = BytesInLog(expected_log, kPersons).size();
    ASSERT_GT(frames, 0U);

    chain.StartAll();
    chain.Play(recording_, kChainInputs);
    EXPECT_TRUE(chain.WaitForMessages(kPersons, frames));
    chain.recorder().HandleFor(milliseconds(1200));  // a last status of each
    for (const Stage& stage : kStages) {
      SCOPED_TRACE(stage.service);
      EXPECT_TRUE(chain.recorder().Bytes(stage.output) == BytesInLog(expected_log, stage.output));
      const service_status_t status = chain.recorder().Status(stage.service);
      EXPECT_EQ(status.published, static_cast<std::int64_t>(frames));
      EXPECT_EQ(status.lost_upstream, 0);
      EXPECT_EQ(status.dropped_late, 0);
      EXPECT_EQ(status.dropped_damaged, 0) << status.text;
      EXPECT_LE(status.resident_bytes, kMaxResidentBytes);
      std::printf("%-24s %5.1f MB resident, median %6.2f ms, p99 %6.2f ms\n", stage.service.c_str(),
                  static_cast<double>(status.resident_bytes) / (1 << 20), status.median_ms,
                  status.p99_ms);
    }
  }

  TemporaryFolder folder_;
  std::filesystem::path recording_;
  std::filesystem::path model_;
};

TEST_F(Chain, SeparateProcessesAndOneProcessAgreeBitForBit) {
  UseSyntheticRecording();
  ServiceChain chain(model_);
  ExpectSameAsTheDetector(chain);
  ExpectSameAsTheTool(chain, {Program("fallen-detect"), recording_, "--model", model_});
  bool has_hypothesis = false;
  for (const auto& persons : chain.recorder().Messages<fallen_persons_t>(kPersons))
    has_hypothesis = has_hypothesis || persons.count > 0;
  EXPECT_TRUE(has_hypothesis) << "decisions about nothing would agree too easily";
  chain.StopAll();
}

TEST_F(Chain, SeparateProcessesAndOneProcessAgreeOnTheDemoRecording) {
  recording_ = FALLEN_SOURCE_DIR "/recordings/demo.lcm";
  model_ = FALLEN_SOURCE_DIR "/models/fallen.model";
  if (!std::filesystem::exists(recording_) || !std::filesystem::exists(model_))
    GTEST_SKIP() << "recordings/demo.lcm or models/fallen.model is not there";
  ServiceChain chain(model_);
  ExpectSameAsTheDetector(chain);
  ExpectSameAsTheTool(chain, {Program("fallen-detect"), recording_, "--model", model_});
  chain.StopAll();
}

TEST_F(Chain, HoldsTheMapOfAFlatInLittleMemory) {
  // A hundred thousand cells, all over a flat of 12 x 10 m.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  EnvironmentMap flat{0.05, std::vector<NdtCell>(100000), "flat"};
  for (NdtCell& cell : flat.cells) {
    cell.mean = {12 * unit(random), 10 * unit(random), 2.5F * unit(random)};
    cell.covariance = {1e-4F, 0, 0, 1e-4F, 0, 1e-4F};
    cell.point_count = 20;
  }
  SaveEnvironmentMap(folder_ / "flat.map", flat, flat.description);
  recording_ = FALLEN_SOURCE_DIR "/recordings/demo.lcm";
  model_ = FALLEN_SOURCE_DIR "/models/fallen.model";
  const std::size_t frames = BytesInLog(recording_, "DEPTH_CAMERA").size();

  ServiceChain chain(model_);
  for (const Stage& stage : kStages) {
    const bool has_map = stage.service == "background-subtraction";
    chain.Start(stage, has_map ? std::vector<std::string>{"--map", folder_ / "flat.map"}
                               : std::vector<std::string>{});
  }
  chain.Play(recording_, kChainInputs);
  EXPECT_TRUE(chain.WaitForMessages(kPersons, frames));
  chain.recorder().HandleFor(milliseconds(1200));  // a last status of each
  for (const Stage& stage : kStages) {
    const service_status_t status = chain.recorder().Status(stage.service);
    EXPECT_EQ(status.state, service_status_t::RUNNING) << status.text;
    EXPECT_LE(status.resident_bytes, kMaxResidentBytes) << stage.service;
  }
  chain.StopAll();
}

TEST_F(Chain, AnyRecordedChannelReplaysIntoItsServiceWithTheSameResult) {
  UseSyntheticRecording();
  const std::filesystem::path run_log = folder_ / "run.lcm";
  ServiceChain chain(model_);
  chain.StartAll();
  {
    ChildProcess logger = chain.StartLogger(run_log);
    chain.Play(recording_, kChainInputs);
    ASSERT_TRUE(chain.WaitForMessages(kPersons, kFrames));
    chain.recorder().HandleFor(milliseconds(1500));
    EXPECT_EQ(logger.Stop(), 0);
  }
  chain.StopAll();
  ExpectEachChannelReplays(chain, run_log, kFrames);
}

TEST_F(Chain, ServiceThatIsKilledAndStartedAgainHurtsNoOther) {
  UseSyntheticRecording();
  ServiceChain chain(model_);
  chain.StartAll();
  const Stage& victim = kStages[2];
  const std::size_t first_half = kFrames / 2;

  chain.Play(recording_, kChainInputs);
  ASSERT_TRUE(chain.WaitForMessages(kPersons, kFrames));
  chain.process(victim.service).Signal(SIGKILL);
  EXPECT_EQ(chain.process(victim.service).WaitForExit(seconds(10)), 128 + SIGKILL);
  chain.Forget(victim.service);

  // Half a replay without it: those before go on, the one after has nothing to do.
  WriteSceneLog(folder_ / "half.lcm", static_cast<int>(first_half));
  chain.recorder().Clear();
  chain.Play(folder_ / "half.lcm", kChainInputs);
  ASSERT_TRUE(chain.WaitForMessages(kStages[1].output, first_half));
  EXPECT_EQ(chain.recorder().Count(kPersons), 0U);

  chain.Start(victim);
  chain.recorder().Clear();
  chain.Play(recording_, kChainInputs);
  EXPECT_TRUE(chain.WaitForMessages(kPersons, kFrames));
  const std::filesystem::path expected_log = folder_ / "expected.lcm";
  WriteStageLog(recording_, LoadModel(model_), expected_log);
  EXPECT_TRUE(chain.recorder().Bytes(kPersons) == BytesInLog(expected_log, kPersons))
      << "the same frames as if nothing had happened";
  chain.recorder().HandleFor(milliseconds(1200));
  for (const Stage& stage : kStages) {
    SCOPED_TRACE(stage.service);
    EXPECT_EQ(chain.recorder().Status(stage.service).dropped_damaged, 0);
  }
  chain.StopAll();
}

TEST_F(Chain, WorkersShareTheFramesBetweenThem) {
  UseSyntheticRecording();
  const Stage& stage = kStages[2];
  const std::filesystem::path stages = folder_ / "stages.lcm";
  WriteStageLog(recording_, LoadModel(model_), stages);
  ServiceChain chain(model_);
  chain.Start(stage, {"--worker", "0/2"});
  ChildProcess second({Program("fallen-" + stage.service), "--lossless", "--lcm-url", chain.url(),
                       "--model", model_.string(), "--worker", "1/2"},
                      folder_.path());
  chain.recorder().HandleFor(milliseconds(1500));
  chain.Play(stages, stage.inputs);
  EXPECT_TRUE(chain.WaitForMessages(stage.output, kFrames));
  const auto& results = chain.recorder().Bytes(stage.output);
  const auto expected = BytesInLog(stages, stage.output);
  EXPECT_TRUE(std::is_permutation(results.begin(), results.end(), expected.begin(), expected.end()))
      << "every frame once";
  EXPECT_EQ(second.Stop(), 0);
  chain.StopAll();
}

}  // namespace
}  // namespace fallen::testing_support
