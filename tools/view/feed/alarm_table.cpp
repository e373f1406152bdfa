// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/alarm_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "fallen/messages/guarded_decoding.hpp"

namespace fallen {
namespace {

/// Falls that the page can list; the rest is in the history of fallen-alarm.
constexpr std::size_t kMaxAlarms = 100;

}  // namespace

bool AlarmTable::Take(std::span<const std::uint8_t> bytes) {
  const Decoded<fall_alarm_t> decoded = DecodeMessage<fall_alarm_t>(bytes);
  if (!decoded) throw std::invalid_argument(decoded.error);
  NumberedAlarm news = FromMessage(*decoded.message);
  const auto known = std::find_if(alarms_.begin(), alarms_.end(), [&](const NumberedAlarm& old) {
    return old.alarm.id == news.alarm.id && old.robot == news.robot;
  });
  if (known != alarms_.end()) {
    if (news.alarm.revision <= known->alarm.revision) return false;
    *known = std::move(news);
    return true;
  }
  alarms_.push_front(std::move(news));
  if (alarms_.size() > kMaxAlarms) alarms_.pop_back();
  return true;
}

nlohmann::json AlarmTable::ToJson() const {
  nlohmann::json table = nlohmann::json::array();
  for (const auto& numbered : alarms_) {
    const FallAlarm& alarm = numbered.alarm;
    const Eigen::Vector3d& p = alarm.position;
    table.push_back({{"id", alarm.id},
                     {"robot", numbered.robot},
                     {"camera", alarm.camera},
                     {"change", EnumName(alarm.change)},
                     {"raised_utime", alarm.raised_utime},
                     {"acknowledged_utime", alarm.acknowledged_utime},
                     {"acknowledged_by", alarm.acknowledged_by},
                     {"cleared_utime", alarm.cleared_utime},
                     {"cleared_by", alarm.cleared_by},
                     {"frame", EnumName(alarm.frame)},
                     {"position", {p.x(), p.y(), p.z()}},
                     {"probability", alarm.probability},
                     {"views", alarm.views},
                     {"frames", alarm.frames}});
  }
  return table;
}

}  // namespace fallen
