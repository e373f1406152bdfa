// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace fallen::samples {

/// Bytes that this program has asked `operator new` for. Link allocation_counter.cpp.
std::size_t AllocatedBytes();

}  // namespace fallen::samples
