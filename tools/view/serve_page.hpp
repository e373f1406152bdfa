// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/view/view_options.hpp"

namespace fallen {

/// Shows a recording, or what comes over LCM, as a page until a signal comes; prints its address.
/// @return Exit status. @throws std::runtime_error in one line for what cannot be opened or found.
int ServePage(const ViewOptions& options);

}  // namespace fallen
