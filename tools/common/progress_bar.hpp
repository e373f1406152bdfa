// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>

namespace fallen {

/// A progress bar with the time that is left, on a terminal; silent where stderr is none.
class ProgressBar {
 public:
  /// @param title  What is going on, e.g. "detect".
  explicit ProgressBar(std::string title);
  /// For tests: draws to `out` if `is_terminal`.
  ProgressBar(std::string title, std::ostream& out, bool is_terminal);
  /// Ends the line.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws, at most ten times a second.
  /// @param share  Done, [0, 1]; values outside are clamped.
  /// @param note   Behind the bar, e.g. "frame 12".
  void Update(double share, const std::string& note = {});

  /// Takes the bar away, so that something else can be printed; the next Update brings it back.
  void Clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string title_;
  std::ostream& out_;
  bool is_terminal_;
  bool is_drawn_ = false;
  Clock::time_point start_ = Clock::now();
  std::optional<Clock::time_point> last_drawn_;
};

}  // namespace fallen
