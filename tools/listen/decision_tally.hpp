// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/messages/conversions.hpp"

namespace fallen {

/// Keeps count of the frames that went in and the decisions that came out.
///
/// A frame and its decision are joined by the frame's utime and seq. Not thread-safe.
class DecisionTally {
 public:
  void AddFrame(const Header& header);
  void AddDecision(const Header& header, const Decision& decision);
  void AddDamaged() { ++damaged_; }

  std::int64_t frames() const { return static_cast<std::int64_t>(frames_.size()); }
  std::int64_t decisions() const { return static_cast<std::int64_t>(decisions_.size()); }
  /// Frames that nothing was decided about.
  std::int64_t lost() const;
  /// Frames with at least one fallen person.
  std::int64_t frames_with_person() const { return frames_with_person_; }
  double best_probability() const { return best_probability_; }

  /// "frames N decisions N lost N persons N", and what was damaged, if anything was.
  std::string Summary() const;

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  std::set<Key> frames_;
  std::set<Key> decisions_;
  std::int64_t frames_with_person_ = 0;
  std::int64_t damaged_ = 0;
  double best_probability_ = 0;
};

/// One line for people about a decision; empty if nobody lies there.
/// @param first_utime  Time zero of the printed times.
std::string DescribeDecision(const Header& header, const Decision& decision,
                             std::int64_t first_utime);

/// One line for people about a change of an alarm.
/// @param first_utime  Time zero of the printed times.
std::string DescribeAlarm(const FallAlarm& alarm, std::int64_t first_utime);

}  // namespace fallen
