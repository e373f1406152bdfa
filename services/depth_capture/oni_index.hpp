// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace fallen {

/// One depth frame of a recording, as its record says.
struct OniIndexEntry {
  std::int64_t time_us = 0;  ///< device clock of the recording; recorders of OpenNI2 start it at 0
  std::int64_t number = 0;   ///< counts from 1

  bool operator==(const OniIndexEntry&) const = default;
};

struct OniIndex {
  std::vector<OniIndexEntry>
      frames;  ///< of the first depth stream, in the file's order; never empty
  /// Where the recording ends. OpenNI2's recorder leaves as much again of nothing behind it.
  std::uint64_t bytes = 0;
};

/// Lists the depth frames of an .oni recording, and makes sure that the recording is whole.
///
/// OpenNI2's player neither tells that a file ends early (it spins until it is closed) nor checks
/// the sizes that a file states, so this walks from record to record first. Reads headers only: an
/// hour at 30 Hz takes well under a second. Layout: OpenNI2's Source/Drivers/OniFile/DataRecords.h;
/// file versions 1.0.0.4 to 1.0.1.0.
/// @throws std::runtime_error "<file>: byte <n>: got ..., expected ...".
OniIndex IndexOniFile(const std::filesystem::path& path);

}  // namespace fallen
