// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/depth_capture/device_clock.hpp"

namespace fallen {
namespace {

/// How fast two quartz clocks may drift apart: 100 ppm, twice what cheap ones are specified for.
constexpr double kMaxDrift = 1e-4;
/// Silence after which the camera's clock may have been restarted unnoticed [us].
constexpr std::int64_t kMaxGapUs = 5'000'000;
/// A host clock that was set back farther than this is followed, though times then run backwards
/// [us].
constexpr std::int64_t kMaxHoldUs = 1'000'000;

}  // namespace

std::int64_t DeviceClock::HostTime(std::int64_t device_us, std::int64_t arrival_us,
                                   std::int64_t to_epoch_us) {
  const bool starts_anew =
      !best_ || device_us <= last_device_us_ || device_us - last_device_us_ > kMaxGapUs;
  last_device_us_ = device_us;
  // [Olson10] Alg. 1, with p the device's and q the host's time: is this arrival's delay smaller
  // than that of the best, of which the drift since then may have been a part?
  if (starts_anew) {
    best_ = {device_us, arrival_us};
  } else {
    const auto since_best_us = static_cast<double>(device_us - best_->device_us);
    const auto delay = static_cast<double>(arrival_us - device_us);
    const auto best_delay = static_cast<double>(best_->arrival_us - best_->device_us);
    if (delay <= best_delay + kMaxDrift * since_best_us) best_ = {device_us, arrival_us};
  }
  std::int64_t result_us = device_us + (best_->arrival_us - best_->device_us) + to_epoch_us;
  if (last_result_us_ && result_us <= *last_result_us_ &&
      *last_result_us_ - result_us <= kMaxHoldUs)
    result_us = *last_result_us_ + 1;
  last_result_us_ = result_us;
  return result_us;
}

}  // namespace fallen
