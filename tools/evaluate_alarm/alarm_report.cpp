// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate_alarm/alarm_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fallen {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAimSeconds = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// The value that `share` of the values do not exceed; null if that is never, or there are none.
Json Quantile(std::vector<double> values, double share) {
  if (values.empty()) return nullptr;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const double value = values[std::max<std::size_t>(rank, 1) - 1];
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json Share(double part, double whole) { return whole > 0 ? Json(part / whole) : Json(nullptr); }

double Hours(std::span<const DriveOutcome> drives, bool person_free_only) {
  double seconds = 0;
  for (const DriveOutcome& drive : drives)
    if (!person_free_only || !drive.has_person) seconds += drive.seconds;
  return seconds / 3600;
}

Json Figures(std::span<const DriveOutcome> drives, AlarmOutcome DriveOutcome::*kind) {
  std::vector<double> seconds, views, until_cleared;
  int falls = 0, found = 0, in_time = 0, false_alarms = 0, person_free_false_alarms = 0, left = 0;
  for (const DriveOutcome& drive : drives) {
    const AlarmOutcome& outcome = drive.*kind;
    false_alarms += outcome.false_alarms;
    if (!drive.has_person) person_free_false_alarms += outcome.false_alarms;
    if (drive.person_left) ++left;
    if (outcome.seconds_until_cleared) until_cleared.push_back(*outcome.seconds_until_cleared);
    if (!drive.came_into_view) continue;
    ++falls;
    seconds.push_back(outcome.seconds_until.value_or(kNever));
    if (!outcome.seconds_until) continue;
    ++found;
    if (*outcome.seconds_until <= kAimSeconds) ++in_time;
    views.push_back(outcome.views);
  }
  Json figures = {
      {"found", found},
      {"share_found", Share(found, falls)},
      {"share_within_3_s", Share(in_time, falls)},
      {"median_seconds", Quantile(seconds, 0.5)},
      {"p90_seconds", Quantile(seconds, 0.9)},
      {"median_views", Quantile(views, 0.5)},
      {"false_alarms", false_alarms},
      {"false_alarms_per_hour", Share(false_alarms, Hours(drives, false))},
      {"person_free_false_alarms", person_free_false_alarms},
      {"person_free_false_alarms_per_hour", Share(person_free_false_alarms, Hours(drives, true))}};
  if (kind == &DriveOutcome::alarm) {
    figures["left"] = left;
    figures["cleared"] = until_cleared.size();
    figures["median_seconds_until_cleared"] = Quantile(until_cleared, 0.5);
  }
  return figures;
}

Json OutcomeJson(const AlarmOutcome& outcome) {
  const auto or_null = [](std::optional<double> value) {
    return value ? Json(*value) : Json(nullptr);
  };
  return {{"seconds_until", or_null(outcome.seconds_until)},
          {"views", outcome.views},
          {"false_alarms", outcome.false_alarms},
          {"seconds_until_cleared", or_null(outcome.seconds_until_cleared)}};
}

}  // namespace

Json AlarmFigures(std::span<const DriveOutcome> drives) {
  const auto count = [&](auto&& is_counted) {
    return std::count_if(drives.begin(), drives.end(), is_counted);
  };
  return {
      {"drives", drives.size()},
      {"hours", Hours(drives, false)},
      {"falls", count([](const DriveOutcome& drive) { return drive.came_into_view; })},
      {"person_free_drives", count([](const DriveOutcome& drive) { return !drive.has_person; })},
      {"person_free_hours", Hours(drives, true)},
      {"alarm", Figures(drives, &DriveOutcome::alarm)},
      {"single_frame", Figures(drives, &DriveOutcome::single_frame)}};
}

Json DriveList(std::span<const DriveOutcome> drives) {
  Json list = Json::array();
  for (const DriveOutcome& drive : drives)
    list.push_back({{"log", drive.log},
                    {"seconds", drive.seconds},
                    {"has_person", drive.has_person},
                    {"came_into_view", drive.came_into_view},
                    {"alarm", OutcomeJson(drive.alarm)},
                    {"single_frame", OutcomeJson(drive.single_frame)}});
  return list;
}

}  // namespace fallen
