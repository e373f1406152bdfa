// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace fallen {

/// How decisions about frames become alarms. Times are those of the messages, and count only while
/// the place is seen.
struct AlarmConfig {
  // What a frame says about a place.
  double neutral_probability = 0.5;  ///< p(fallen) that speaks neither way, (0, 1)
  double max_log_odds = 4;           ///< no frame says more, either way, > 0
  double missing_log_odds = -1.5;    ///< of a place that is seen without any cluster there, < 0
  /// Share of a place's box that must be seen for a frame to say anything about it, (0, 1].
  double min_visible_share = 0.2;
  /// A ray that ends this much before a place still sees it [m], >= 0: the person itself is in its
  /// way.
  double visibility_margin_m = 0.35;

  // What frames say together.
  /// Viewpoints nearer to each other than this, seen from the place, see the same thing [deg], > 0.
  double view_angle_deg = 15;
  double view_distance_ratio = 1.3;  ///< ... and whose distances differ by less than this, > 1
  double settle_s = 0.5;  ///< time until a viewpoint has said two thirds of what it can say, > 0
  double memory_s = 6;    ///< time until two thirds of what other viewpoints said is forgotten, > 0

  // Which clusters are the same person.
  double match_distance_m = 0.8;  ///< along the floor, > 0: two persons nearer than this are one

  // When the alarm goes up and down: log-odds of all evidence, for so long.
  double raise_log_odds = 2;
  double on_delay_s = 0.6;    ///< >= 0
  double clear_log_odds = 0;  ///< < raise_log_odds
  double off_delay_s = 1;     ///< >= 0
  /// Least time between two updates of an alarm [s], >= 0.
  double update_interval_s = 1;
  /// A place without an alarm is forgotten when it has not been seen for so long [s], > 0.
  double forget_s = 30;

  /// @throws std::invalid_argument for the first value out of range.
  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("neutral_probability", neutral_probability);
    visit("max_log_odds", max_log_odds);
    visit("missing_log_odds", missing_log_odds);
    visit("min_visible_share", min_visible_share);
    visit("visibility_margin_m", visibility_margin_m);
    visit("view_angle_deg", view_angle_deg);
    visit("view_distance_ratio", view_distance_ratio);
    visit("settle_s", settle_s);
    visit("memory_s", memory_s);
    visit("match_distance_m", match_distance_m);
    visit("raise_log_odds", raise_log_odds);
    visit("on_delay_s", on_delay_s);
    visit("clear_log_odds", clear_log_odds);
    visit("off_delay_s", off_delay_s);
    visit("update_interval_s", update_interval_s);
    visit("forget_s", forget_s);
  }
};

}  // namespace fallen
