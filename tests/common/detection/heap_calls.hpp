// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

namespace fallen::test {

/// How often this program has asked for memory: operator new, malloc and the rest, also from
/// within libraries. Link heap_calls.cpp. Nothing under a sanitizer, which has the heap for itself.
std::optional<std::size_t> HeapCalls();

}  // namespace fallen::test
