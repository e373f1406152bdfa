// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/recorded_source.hpp"

#include <exception>
#include <set>
#include <stdexcept>

#include "fallen/service/channels.hpp"

namespace fallen {

std::optional<std::string> CameraWithDecisions(const std::filesystem::path& log,
                                               const std::optional<std::string>& camera) {
  const std::string prefix = channels::FallenPersons("");
  std::set<std::string> cameras;
  LogReader reader(log);
  while (const std::optional<LogEvent> event = reader.Next())
    if (event->channel.starts_with(prefix)) cameras.insert(event->channel.substr(prefix.size()));
  if (camera) return cameras.contains(*camera) ? camera : std::nullopt;
  if (cameras.size() != 1) return std::nullopt;
  return *cameras.begin();
}

RecordedSource::RecordedSource(Feed& feed, const std::filesystem::path& log,
                               const std::string& camera, const std::string& name)
    : feed_(feed),
      reader_(log),
      assembler_(camera, [this](const Scene& scene) { feed_.Append(scene); }),
      report_(feed, name, camera) {}

void RecordedSource::Run(const std::atomic<bool>& is_stopping) {
  try {
    while (!is_stopping) {
      const std::optional<LogEvent> event = reader_.Next();
      if (!event) break;
      Take(*event);
      report_.Progress(
          static_cast<double>(reader_.position_bytes()) / static_cast<double>(reader_.size_bytes()),
          unusable_);
    }
    assembler_.Flush();
  } catch (const std::exception& error) {
    unusable_.Add(error.what());
  }
  for (const LogDamage& damage : reader_.damage())
    unusable_.Add("offset " + std::to_string(damage.offset) + ": " + damage.reason);
  report_.End(unusable_);
}

void RecordedSource::Take(const LogEvent& event) {
  try {
    assembler_.Take(event.channel, event.data);
    if (event.channel == channels::kFallAlarm && alarms_.Take(event.data))
      feed_.SetTopic("alarms", alarms_.ToJson());
  } catch (const std::invalid_argument& error) {
    unusable_.Add(event.channel + ": " + error.what());
  }
}

}  // namespace fallen
