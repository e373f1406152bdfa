// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "tools/common/progress_bar.hpp"

namespace fallen {

/// A progress bar for each step of a long piece of work, whichever thread reports.
class StepProgress {
 public:
  /// @param step   Another one than before begins a new bar.
  /// @param share  Of the step that is done, [0, 1].
  void operator()(const char* step, double share);

  /// Says something between two bars, on stderr.
  void Announce(const std::string& text);

 private:
  std::mutex mutex_;
  std::string step_;
  std::unique_ptr<ProgressBar> bar_;
};

}  // namespace fallen
