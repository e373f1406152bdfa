// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/step_progress.hpp"

#include <iostream>

namespace fallen {

void StepProgress::operator()(const char* step, double share) {
  const std::lock_guard lock(mutex_);
  if (step_ != step) {
    bar_.reset();
    bar_ = std::make_unique<ProgressBar>(step);
    step_ = step;
  }
  bar_->Update(share);
}

void StepProgress::Announce(const std::string& text) {
  const std::lock_guard lock(mutex_);
  bar_.reset();
  step_.clear();
  std::cerr << text << std::endl;
}

}  // namespace fallen
