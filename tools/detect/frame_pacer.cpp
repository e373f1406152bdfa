// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/frame_pacer.hpp"

#include <thread>
#include <utility>

namespace fallen {
namespace {

/// Longer gaps in a recording, and clocks that run back, are not waited through.
constexpr double kMaxGapUs = 10e6;
/// Taken in their place: 30 frames per second.
constexpr double kUsualGapUs = 1e6 / 30;

FramePacer::Clock::duration Gap(std::int64_t from_utime, std::int64_t to_utime) {
  const double gap_us = static_cast<double>(to_utime) - static_cast<double>(from_utime);
  const bool is_plausible = gap_us >= 0 && gap_us <= kMaxGapUs;
  return std::chrono::duration_cast<FramePacer::Clock::duration>(
      std::chrono::duration<double, std::micro>(is_plausible ? gap_us : kUsualGapUs));
}

}  // namespace

FramePacer::FramePacer(std::function<std::optional<Frame>()> next)
    : FramePacer(Source{std::move(next), [] { return Clock::now(); },
                        [](Clock::time_point time) { std::this_thread::sleep_until(time); }}) {}

FramePacer::FramePacer(Source source) : source_(std::move(source)) {}

std::optional<FramePacer::Timed> FramePacer::Fetch() {
  std::optional<Frame> frame = source_.next();
  if (!frame) return std::nullopt;
  const Clock::time_point due =
      previous_ ? previous_->due + Gap(previous_->utime, frame->utime) : source_.now();
  previous_ = Previous{frame->utime, due};
  return Timed{std::move(*frame), due};
}

std::optional<Frame> FramePacer::Next() {
  std::optional<Timed> current = pending_ ? std::exchange(pending_, std::nullopt) : Fetch();
  if (!current) return std::nullopt;
  while ((pending_ = Fetch()) && pending_->due <= source_.now()) {
    current = std::exchange(pending_, std::nullopt);
    ++dropped_;
  }
  source_.sleep_until(current->due);
  return std::move(current->frame);
}

}  // namespace fallen
