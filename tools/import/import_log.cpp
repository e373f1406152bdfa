// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/import_log.hpp"

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/import/tum_directory.hpp"

namespace fallen {

ImportReport ImportDirectory(const std::filesystem::path& path, const std::filesystem::path& log,
                             const std::string& camera) {
  const TumDirectory directory = ReadTumDirectory(path);
  PartialFile output(log);
  LogWriter writer(output.path());
  ProgressBar progress("import");
  ImportReport report;
  const std::size_t count = directory.frames.size();
  for (std::size_t i = 0; i < count; ++i) {
    const TumMessages messages = LoadTumFrame(directory, i, camera);
    const Header& header = messages.depth.header;
    if (messages.pose) {
      writer.Write(header.utime, channels::kRobotPose, EncodeMessage(ToMessage(*messages.pose)));
      ++report.poses;
    }
    if (messages.truth) {
      writer.Write(header.utime, channels::GroundTruth(camera),
                   EncodeMessage(ToMessage(header, *messages.truth)));
      ++report.labelled;
    }
    writer.Write(header.utime, channels::Depth(camera), EncodeMessage(ToMessage(messages.depth)));
    ++report.frames;
    progress.Update(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  writer.Close();
  output.Commit();
  return report;
}

}  // namespace fallen
