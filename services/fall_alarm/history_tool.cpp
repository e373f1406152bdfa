// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/history_tool.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "fallen/service/command_line.hpp"
#include "fallen/service/configuration.hpp"
#include "services/fall_alarm/alarm_history.hpp"
#include "services/fall_alarm/alarm_json.hpp"

namespace fallen {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::optional<fs::path> config;
  std::string file;
  bool is_json = false;
  std::string event;
  fs::path folder;
  double keep_days = 0;
};

AlarmHistory Open(const Options& options) {
  const fs::path file = HistoryFile(
      options.file.empty() ? LoadConfiguration(options.config).history.file : options.file);
  if (!fs::exists(file))
    throw std::runtime_error(file.string() + ": no such file, expected a history");
  return AlarmHistory(file);
}

std::string Time(std::int64_t utime) {
  if (utime == 0) return "-";
  const std::time_t seconds = utime / 1'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

int List(const Options& options) {
  const AlarmHistory history = Open(options);
  for (const NumberedAlarm& fall : history.Falls()) {
    if (options.is_json) {
      std::cout << JsonLine(AlarmJson(fall)) << '\n';
      continue;
    }
    const FallAlarm& alarm = fall.alarm;
    std::printf(
        "%s  %-12s raised %s  acknowledged %s  cleared %s  (%.2f, %.2f) m  p %.3f  %d views\n",
        alarm.id.c_str(), std::string(EnumName(alarm.change)).c_str(),
        Time(alarm.raised_utime).c_str(), Time(alarm.acknowledged_utime).c_str(),
        Time(alarm.cleared_utime).c_str(), alarm.position.x(), alarm.position.y(),
        alarm.probability, alarm.views);
  }
  return kExitSuccess;
}

void Write(const fs::path& file, const char* bytes, std::size_t size) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes, static_cast<std::streamsize>(size));
  if (!stream.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

void ExportFall(const AlarmHistory& history, const std::string& id, const fs::path& folder) {
  nlohmann::ordered_json changes = nlohmann::ordered_json::array();
  for (const NumberedAlarm& change : history.Changes(id)) changes.push_back(AlarmJson(change));
  if (changes.empty()) throw std::runtime_error(id + ": no such event in the history");
  fs::create_directories(folder / id);
  const std::string text = JsonLine(changes) + "\n";
  Write(folder / id / "changes.json", text.data(), text.size());
  int n = 0;
  for (const AlarmSnapshot& snapshot : history.Snapshots(id))
    Write(folder / id / ("snapshot-" + std::to_string(n++) + ".lcm"),
          reinterpret_cast<const char*>(snapshot.log.data()), snapshot.log.size());
  std::cout << (folder / id).string() << '\n';
}

int Export(const Options& options) {
  const AlarmHistory history = Open(options);
  if (!options.event.empty()) {
    ExportFall(history, options.event, options.folder);
    return kExitSuccess;
  }
  for (const NumberedAlarm& fall : history.Falls())
    ExportFall(history, fall.alarm.id, options.folder);
  return kExitSuccess;
}

int Purge(const Options& options) {
  AlarmHistory history = Open(options);
  const auto now = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::system_clock::now().time_since_epoch());
  const double age_us = options.keep_days * 86400e6;
  const auto count = history.Purge(now.count() - static_cast<std::int64_t>(age_us));
  std::cout << "purged " << count << '\n';
  return kExitSuccess;
}

}  // namespace

int RunHistoryTool(int argc, const char* const* argv) {
  CLI::App parser;
  Options options;
  AddStandardFlags(parser, "fallen-alarm history",
                   "Lists, exports and purges the history of alarms");
  parser.add_option("--config", options.config, "Configuration (YAML) that names the history");
  parser.add_option("--file", options.file, "History, before that of the configuration");
  parser.require_subcommand(1);
  parser.fallthrough();
  CLI::App* list = parser.add_subcommand("list", "One line a fall");
  list->add_flag("--json", options.is_json, "One JSON object a line");
  CLI::App* exporting =
      parser.add_subcommand("export", "All changes as JSON, and the snapshots as LCM logs");
  exporting->add_option("folder", options.folder, "Gets a folder for each fall")->required();
  exporting->add_option("--event", options.event, "Only this one, by its id");
  CLI::App* purge = parser.add_subcommand(
      "purge", "Removes falls that are cleared, and that the MQTT broker has been told of");
  purge->add_option("--older-than", options.keep_days, "Cleared so many days ago, or more")
      ->required()
      ->check(CLI::NonNegativeNumber);
  return RunCommandLine(parser, argc, argv, [&] {
    if (*list) return List(options);
    if (*exporting) return Export(options);
    return Purge(options);
  });
}

}  // namespace fallen
