// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/sequence_gaps.hpp"

namespace fallen {

void SequenceGaps::StartAnew(std::int64_t seq) {
  newest_ = seq;
  seen_.set();  // what was before the first message is not missed
}

void SequenceGaps::Add(std::int64_t seq) {
  if (!newest_) return StartAnew(seq);
  // In unsigned arithmetic: the numbers come from outside, and their difference may overflow.
  const auto ahead = static_cast<std::int64_t>(static_cast<std::uint64_t>(seq) -
                                               static_cast<std::uint64_t>(*newest_));
  if (ahead > kMaxGap || ahead <= -kWindow) return StartAnew(seq);
  if (ahead > 0) {
    missing_ += ahead - 1;
    seen_ <<= static_cast<std::size_t>(ahead < kWindow ? ahead : kWindow);
    seen_.set(0);
    newest_ = seq;
    return;
  }
  const auto back = static_cast<std::size_t>(-ahead);
  if (seen_.test(back)) return StartAnew(seq);
  seen_.set(back);
  --missing_;
}

}  // namespace fallen
