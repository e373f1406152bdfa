// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/log_check/report_output.hpp"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace fallen {
namespace {

// Bad messages listed for a channel; a channel of the wrong type would fill screens.
constexpr std::size_t kListedBadMessages = 5;

std::string Types(const ChannelReport& channel) {
  std::string text;
  for (const auto& [type, count] : channel.types) {
    text += (text.empty() ? "" : ", ") + type;
    if (channel.types.size() > 1) text += " (" + std::to_string(count) + ")";
  }
  return text;
}

void WriteTable(std::ostream& out, const LogReport& report) {
  std::size_t name_width = 7;
  std::size_t type_width = 4;
  for (const auto& [name, channel] : report.channels) {
    name_width = std::max(name_width, name.size());
    type_width = std::max(type_width, Types(channel).size());
  }
  const auto names = static_cast<int>(name_width);
  const auto types = static_cast<int>(type_width);
  out << std::left << std::setw(names) << "channel"
      << "  " << std::setw(types) << "type" << std::right << std::setw(10) << "messages"
      << std::setw(10) << "per s" << std::setw(10) << "seconds" << std::setw(12) << "KB"
      << std::setw(9) << "missing" << std::setw(14) << "out of order" << std::setw(6) << "bad"
      << "\n";
  out << std::fixed;
  for (const auto& [name, channel] : report.channels)
    out << std::left << std::setw(names) << name << "  " << std::setw(types) << Types(channel)
        << std::right << std::setw(10) << channel.messages << std::setw(10) << std::setprecision(2)
        << channel.rate_hz() << std::setw(10) << channel.span_s() << std::setw(12)
        << std::setprecision(1) << static_cast<double>(channel.bytes) / 1e3 << std::setw(9)
        << channel.missing << std::setw(14) << channel.out_of_order << std::setw(6)
        << channel.bad.size() << "\n";
}

void WriteProblems(std::ostream& out, const LogReport& report) {
  for (const LogDamage& place : report.damage)
    out << "damage at offset " << place.offset << ", " << place.skipped_bytes
        << " bytes: " << place.reason << "\n";
  for (const auto& [name, channel] : report.channels) {
    for (std::size_t i = 0; i < std::min(channel.bad.size(), kListedBadMessages); ++i)
      out << "bad message at offset " << channel.bad[i].offset << ", " << name << ": "
          << channel.bad[i].reason << "\n";
    if (channel.bad.size() > kListedBadMessages)
      out << "and " << channel.bad.size() - kListedBadMessages << " more bad messages on " << name
          << "\n";
  }
}

}  // namespace

std::string ReportText(const std::string& log, const LogReport& report) {
  std::ostringstream out;
  out << log << ": " << report.size_bytes << " bytes, " << report.events << " events on "
      << report.channels.size() << " channels; " << report.damage.size() << " damaged places ("
      << report.damaged_bytes() << " bytes), " << report.bad_messages() << " bad messages\n";
  if (!report.channels.empty()) WriteTable(out, report);
  WriteProblems(out, report);
  return out.str();
}

std::string ReportJson(const std::string& log, const LogReport& report) {
  nlohmann::ordered_json json;
  json["log"] = log;
  json["clean"] = report.is_clean();
  json["size_bytes"] = report.size_bytes;
  json["events"] = report.events;
  json["channels"] = nlohmann::ordered_json::object();
  for (const auto& [name, channel] : report.channels) {
    nlohmann::ordered_json bad = nlohmann::ordered_json::array();
    for (const BadMessage& message : channel.bad)
      bad.push_back({{"offset", message.offset}, {"reason", message.reason}});
    json["channels"][name] = {{"messages", channel.messages},
                              {"bytes", channel.bytes},
                              {"first_utime", channel.first_utime},
                              {"last_utime", channel.last_utime},
                              {"rate_hz", channel.rate_hz()},
                              {"types", channel.types},
                              {"missing", channel.missing},
                              {"out_of_order", channel.out_of_order},
                              {"bad", bad}};
  }
  json["damage"] = nlohmann::ordered_json::array();
  for (const LogDamage& place : report.damage)
    json["damage"].push_back({{"offset", place.offset},
                              {"skipped_bytes", place.skipped_bytes},
                              {"reason", place.reason}});
  // What a log holds need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace fallen
