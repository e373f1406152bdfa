// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace fallen {

/// Tells host time from a camera's own clock, which starts anywhere and drifts.
///
/// [Olson10] Olson: A passive solution to the sensor synchronization problem. IROS 2010.
///
/// A frame arrives after it was taken: never before, often a little after, at times long after. So
/// the arrival with the least delay says most about the offset between the clocks, and the estimate
/// follows the least delays, not the mean; an older one counts less by what the clocks may have
/// drifted since. The remaining error is the least delay itself (transfer, about a frame over USB
/// 2) and constant. Differs from the paper: times never run backwards, so that frames keep their
/// order.
class DeviceClock {
 public:
  /// Host time of a frame [us since the epoch].
  ///
  /// @param device_us   The frame's time on the camera's clock [us].
  /// @param arrival_us  Arrival on a host clock that is never set [us], e.g. CLOCK_MONOTONIC.
  /// @param to_epoch_us What to add to that host clock for the time since the epoch: may change
  /// when
  ///                    somebody sets the clock, and the times follow at once.
  /// @return At least 1 us after the frame before, but for a clock that was set back by over a
  /// second.
  std::int64_t HostTime(std::int64_t device_us, std::int64_t arrival_us, std::int64_t to_epoch_us);

 private:
  struct Pair {
    std::int64_t device_us;
    std::int64_t arrival_us;
  };
  std::optional<Pair> best_;  // the arrival with the least delay
  std::int64_t last_device_us_ = 0;
  std::optional<std::int64_t> last_result_us_;
};

}  // namespace fallen
