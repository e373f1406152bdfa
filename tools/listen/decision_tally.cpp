// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/listen/decision_tally.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fallen {

void DecisionTally::AddFrame(const Header& header) { frames_.emplace(header.utime, header.seq); }

void DecisionTally::AddDecision(const Header& header, const Decision& decision) {
  if (!decisions_.emplace(header.utime, header.seq).second) return;
  bool has_person = false;
  for (const PersonHypothesis& hypothesis : decision.hypotheses) {
    if (!hypothesis.is_person) continue;
    has_person = true;
    best_probability_ = std::max(best_probability_, hypothesis.probability);
  }
  if (has_person) ++frames_with_person_;
}

std::int64_t DecisionTally::lost() const {
  return std::count_if(frames_.begin(), frames_.end(),
                       [&](const Key& frame) { return !decisions_.contains(frame); });
}

std::string DecisionTally::Summary() const {
  std::string text = fmt::format("frames {} decisions {} lost {} persons {}", frames(), decisions(),
                                 lost(), frames_with_person_);
  if (damaged_ > 0) text += fmt::format(" damaged {}", damaged_);
  return text;
}

std::string DescribeDecision(const Header& header, const Decision& decision,
                             std::int64_t first_utime) {
  std::string text;
  for (const PersonHypothesis& person : decision.hypotheses) {
    if (!person.is_person) continue;
    text += fmt::format(
        "{}{:7.2f} s  frame {:4d}  fallen person at ({:.2f}, {:.2f}, {:.2f}) m {}"
        "  p {:.3f}  {} cells",
        text.empty() ? "" : "\n", static_cast<double>(header.utime - first_utime) * 1e-6,
        header.seq, person.centroid.x(), person.centroid.y(), person.centroid.z(),
        EnumName(decision.frame), person.probability, person.cell_count);
  }
  return text;
}

std::string DescribeAlarm(const FallAlarm& alarm, std::int64_t first_utime) {
  return fmt::format("{:7.2f} s  ALARM {} {} at ({:.2f}, {:.2f}, {:.2f}) m {}  p {:.3f}  {} views",
                     static_cast<double>(alarm.change_utime - first_utime) * 1e-6, alarm.id,
                     EnumName(alarm.change), alarm.position.x(), alarm.position.y(),
                     alarm.position.z(), EnumName(alarm.frame), alarm.probability, alarm.views);
}

}  // namespace fallen
