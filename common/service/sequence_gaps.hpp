// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>

namespace fallen {

/// Counts the messages that a source has sent and that never came, by gaps in `seq`.
///
/// Messages may arrive out of order (several workers publish on one channel): one that comes within
/// the last 64 fills its gap. A number that was there before, or lies farther back, is a source
/// that started anew, and no gap.
class SequenceGaps {
 public:
  void Add(std::int64_t seq);

  /// Messages missing so far.
  std::int64_t missing() const { return missing_; }

 private:
  static constexpr std::int64_t kWindow = 64;  // 2 s at 30 Hz: no worker is that far behind
  // A jump beyond this is another source, not a loss: an hour at 30 Hz.
  static constexpr std::int64_t kMaxGap = 108000;

  void StartAnew(std::int64_t seq);

  std::optional<std::int64_t> newest_;
  std::bitset<kWindow> seen_;  // bit k: newest_ - k has come, or came before our time
  std::int64_t missing_ = 0;
};

}  // namespace fallen
