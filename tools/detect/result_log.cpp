// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/result_log.hpp"

#include <utility>

#include "fallen/service/channels.hpp"

namespace fallen {

ResultLog::ResultLog(const std::filesystem::path& log, std::string camera)
    : file_(log), writer_(file_.path()), camera_(std::move(camera)) {}

void ResultLog::Write(const Frame& frame, const FrameResult& result,
                      const std::vector<NumberedAlarm>& alarms) {
  const Header header{frame.utime, frame.seq, frame.sensor_name};
  const auto write = [&](const std::string& channel, const auto& message) {
    writer_.Write(frame.utime, channel, EncodeMessage(message));
  };
  write(channels::NdtMap(camera_), ToMessage(header, result.foreground.map));
  write(channels::Foreground(camera_), ToMessage(header, result.foreground));
  write(channels::Clusters(camera_), ToMessage(header, result.segmented));
  write(channels::FallenPersons(camera_), ToMessage(header, result.decision));
  for (const NumberedAlarm& alarm : alarms) write(channels::kFallAlarm, ToMessage(alarm));
}

void ResultLog::Close() {
  writer_.Close();
  file_.Commit();
}

}  // namespace fallen
