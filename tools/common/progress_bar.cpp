// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace fallen {
namespace {

constexpr int kBarWidth = 32;                      // characters: fits beside title and note in 80
constexpr std::chrono::milliseconds kRedraw{100};  // smooth to the eye, free to the machine
constexpr double kMinShareForEstimate = 0.01;      // before it, the estimate jumps about
constexpr const char* kEraseLine = "\r\x1b[K";

std::string MinutesAndSeconds(double seconds) {
  const long whole = std::lround(seconds);
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

}  // namespace

ProgressBar::ProgressBar(std::string title)
    : ProgressBar(std::move(title), std::cerr, isatty(STDERR_FILENO) != 0) {}

ProgressBar::ProgressBar(std::string title, std::ostream& out, bool is_terminal)
    : title_(std::move(title)), out_(out), is_terminal_(is_terminal) {}

ProgressBar::~ProgressBar() {
  if (is_drawn_) out_ << '\n' << std::flush;
}

void ProgressBar::Update(double share, const std::string& note) {
  if (!is_terminal_) return;
  const double done = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  const Clock::time_point now = Clock::now();
  if (last_drawn_ && done < 1 && now - *last_drawn_ < kRedraw) return;
  last_drawn_ = now;
  is_drawn_ = true;

  const int filled = static_cast<int>(done * kBarWidth);
  out_ << kEraseLine << title_ << " [" << std::string(filled, '#')
       << std::string(kBarWidth - filled, '.') << "] " << static_cast<int>(done * 100) << " %";
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  if (done >= 1)
    out_ << "  " << MinutesAndSeconds(elapsed_s);
  else if (done >= kMinShareForEstimate)
    out_ << "  " << MinutesAndSeconds(elapsed_s * (1 - done) / done) << " left";
  if (!note.empty()) out_ << "  " << note;
  out_ << std::flush;
}

void ProgressBar::Clear() {
  if (!is_drawn_) return;
  out_ << kEraseLine << std::flush;
  is_drawn_ = false;
  last_drawn_.reset();
}

}  // namespace fallen
