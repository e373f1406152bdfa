// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/alarm_config.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

void Require(bool is_right, const char* name, double value, const char* expected) {
  if (is_right && std::isfinite(value)) return;
  throw std::invalid_argument(std::string("alarm: ") + name + " is " + std::to_string(value) +
                              ", must be " + expected);
}

}  // namespace

void AlarmConfig::Validate() const {
  Require(neutral_probability > 0 && neutral_probability < 1, "neutral_probability",
          neutral_probability, "in (0, 1)");
  Require(max_log_odds > 0, "max_log_odds", max_log_odds, "> 0");
  Require(missing_log_odds < 0, "missing_log_odds", missing_log_odds, "< 0");
  Require(min_visible_share > 0 && min_visible_share <= 1, "min_visible_share", min_visible_share,
          "in (0, 1]");
  Require(visibility_margin_m >= 0, "visibility_margin_m", visibility_margin_m, ">= 0");
  Require(view_angle_deg > 0 && view_angle_deg <= 180, "view_angle_deg", view_angle_deg,
          "in (0, 180]");
  Require(view_distance_ratio > 1, "view_distance_ratio", view_distance_ratio, "> 1");
  Require(settle_s > 0, "settle_s", settle_s, "> 0");
  Require(memory_s > 0, "memory_s", memory_s, "> 0");
  Require(match_distance_m > 0, "match_distance_m", match_distance_m, "> 0");
  Require(true, "raise_log_odds", raise_log_odds, "finite");
  Require(on_delay_s >= 0, "on_delay_s", on_delay_s, ">= 0");
  Require(clear_log_odds < raise_log_odds, "clear_log_odds", clear_log_odds,
          "less than raise_log_odds");
  Require(off_delay_s >= 0, "off_delay_s", off_delay_s, ">= 0");
  Require(update_interval_s >= 0, "update_interval_s", update_interval_s, ">= 0");
  Require(forget_s > 0, "forget_s", forget_s, "> 0");
}

}  // namespace fallen
