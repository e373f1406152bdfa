// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <csignal>

namespace fallen {

/// SIGINT and SIGTERM as a question instead of an interruption.
///
/// Blocks both in the calling thread and in all threads that it starts afterwards, so that no
/// system call anywhere is cut short: construct it first in main, before LCM starts its thread.
class StopSignal {
 public:
  StopSignal();

  /// True once one has arrived; each arrival is told only once.
  bool Arrived();

 private:
  sigset_t signals_;
};

}  // namespace fallen
