// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/chain_checks.hpp"

#include <gtest/gtest.h>

#include "fallen/service/channels.hpp"
#include "tests/support/log_detection.hpp"
#include "tests/support/run_program.hpp"

namespace fallen::testing_support {

void ExpectSameAsTheTool(ServiceChain& chain, std::vector<std::string> tool) {
  const std::filesystem::path results = chain.folder() / "detect.lcm";
  tool.insert(tool.end(), {"--json", chain.folder() / "persons.json", "--output", results});
  const ProgramOutcome outcome = RunCommand(tool);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const Stage& stage : kStages) {
    const auto expected = BytesInLog(results, stage.output);
    EXPECT_FALSE(expected.empty());
    EXPECT_TRUE(chain.recorder().Bytes(stage.output) == expected) << stage.service;
  }
}

void ExpectEachChannelReplays(ServiceChain& chain, const std::filesystem::path& run_log,
                              std::size_t frames) {
  for (const Stage& stage : kStages) {
    SCOPED_TRACE(stage.service);
    const auto recorded = BytesInLog(run_log, stage.output);
    ASSERT_EQ(recorded.size(), frames);
    EXPECT_FALSE(BytesInLog(run_log, channels::Status(stage.service)).empty());
    chain.recorder().Clear();
    chain.Start(stage);
    chain.Play(run_log, stage.inputs);
    EXPECT_TRUE(chain.WaitForMessages(stage.output, recorded.size()))
        << chain.recorder().Count(stage.output) << " of " << recorded.size() << "\n"
        << chain.process(stage.service).StandardError();
    EXPECT_TRUE(chain.recorder().Bytes(stage.output) == recorded);
    chain.StopAll();
  }
}

}  // namespace fallen::testing_support
