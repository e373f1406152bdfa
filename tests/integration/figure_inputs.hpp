// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "tools/bench/bench_sequence.hpp"

/// What the figures are measured on.
namespace fallen::testing_support {

/// Value of an environment variable.
inline std::string Environment(const char* name, const std::string& otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : text;
}

/// The first images of 640 x 480 of FALLEN_RECORDING, a log or an import directory; where it has
/// none, those of a ray-cast room.
inline BenchSequence LargeImages(std::size_t max_count) {
  for (BenchSequence& sequence :
       ChooseSequences(Environment("FALLEN_RECORDING", ""), "", max_count))
    if (sequence.size_name() == "640x480") return sequence;
  throw std::logic_error("no sequence of 640x480");  // there always is one
}

}  // namespace fallen::testing_support
