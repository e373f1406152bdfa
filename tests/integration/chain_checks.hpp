// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/integration/service_chain.hpp"

/// What holds for a chain of services whatever stands before it.
namespace fallen::testing_support {

/// Expects that each stage has published what `tool`, a call of fallen-detect on the same input,
/// makes of it: each message, bit for bit.
void ExpectSameAsTheTool(ServiceChain& chain, std::vector<std::string> tool);

/// Expects of a log of a whole run that any channel of it, played into the one service that reads
/// it, gives what that service published in the run. Starts and stops the services.
/// @param frames  How many there are of each.
void ExpectEachChannelReplays(ServiceChain& chain, const std::filesystem::path& run_log,
                              std::size_t frames);

}  // namespace fallen::testing_support
