// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace fallen::testing_support {

/// Gives this process, and those that it starts, a network of its own with multicast on its
/// loopback. Where the system does not allow that, an own port stands in. Call it before any thread
/// starts.
/// @return LCM URL for the test.
std::string EnterPrivateNetwork();

}  // namespace fallen::testing_support
