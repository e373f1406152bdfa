// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace fallen {

/// For CLI11's `check`: "" if `name` can be part of a channel, else what is wrong with it.
std::string CheckCameraName(const std::string& name);

}  // namespace fallen
