// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace fallen {

/// Who and where: what recordings are split by. Empty means nobody, or unknown.
struct RecordingOrigin {
  std::string log;
  std::string person;
  std::string room;
};

/// Indices into the recordings, ascending.
struct RecordingSplit {
  std::vector<std::size_t> training;
  std::vector<std::size_t> validation;
};

/// Splits recordings so that no person and no room is on both sides.
///
/// Recordings that share a person or a room belong together; whole groups go to validation, in an
/// order drawn from `seed`, until it holds about `validation_share` of the recordings. A recording
/// whose room is unknown is a group of its own.
/// @throws std::invalid_argument if `validation_share` is not in (0, 1), or all recordings hang
/// together, so that no such split exists.
RecordingSplit SplitByPersonAndRoom(const std::vector<RecordingOrigin>& recordings,
                                    double validation_share, std::uint64_t seed);

/// Checks a split that somebody else chose.
/// @throws std::invalid_argument naming the person or room that is on both sides.
void RequireDisjoint(const std::vector<RecordingOrigin>& training,
                     const std::vector<RecordingOrigin>& validation);

}  // namespace fallen
