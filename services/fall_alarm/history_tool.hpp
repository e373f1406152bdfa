// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace fallen {

/// `fallen-alarm history list|export|purge`: looks at a history and tidies it up, while the service
/// runs or not.
/// @param argv  The command line from "history" on.
/// @return Exit status.
int RunHistoryTool(int argc, const char* const* argv);

}  // namespace fallen
