// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/detect.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

#include "fallen/service/configuration.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/detect/frame_alarms.hpp"
#include "tools/detect/frame_pacer.hpp"
#include "tools/detect/result_log.hpp"
#include "tools/detect/stage_medians.hpp"

namespace fallen {
namespace {

/// Lines of JSON, to a file that appears once it is complete or to stdout.
class LineWriter {
 public:
  explicit LineWriter(const std::string& target) {
    if (target == "-") return;
    file_ = std::make_unique<PartialFile>(target);
    stream_.open(file_->path());
    if (!stream_) throw std::runtime_error(target + ": cannot be written");
  }
  void Write(const std::string& line) { out() << line << '\n' << std::flush; }
  void Close() {
    if (!out()) throw std::runtime_error("json output: cannot be written to the end");
    if (!file_) return;
    stream_.close();
    file_->Commit();
  }
  bool is_stdout() const { return !file_; }

 private:
  std::ostream& out() { return file_ ? static_cast<std::ostream&>(stream_) : std::cout; }
  std::unique_ptr<PartialFile> file_;
  std::ofstream stream_;
};

std::int64_t CountAccepted(const Decision& decision) {
  return std::count_if(decision.hypotheses.begin(), decision.hypotheses.end(),
                       [](const PersonHypothesis& person) { return person.is_person; });
}

/// Decision about `frame`; nothing, and one more in `damage`, for one that makes no sense.
std::optional<FrameResult> Decide(Detector& detector, const Frame& frame, std::int64_t index,
                                  Damage& damage) {
  try {
    return detector.Detect(frame);
  } catch (const std::invalid_argument& error) {
    damage.Add("frame " + std::to_string(index) + ": " + error.what());
    return std::nullopt;
  }
}

std::string Note(const DetectSummary& summary) {
  return "frame " + std::to_string(summary.frames) + ", persons " + std::to_string(summary.persons);
}

}  // namespace

DetectSummary RunDetect(const DetectOptions& options) {
  Detector detector = MakeDetector(options.detector);
  const Configuration configuration = LoadConfiguration(options.detector.config);
  const std::unique_ptr<FrameSource> recording =
      OpenFrameSource(options.input, options.camera, configuration.capture.T_robot_camera());
  std::optional<FrameAlarms> alarms;
  if (options.alarms) alarms.emplace(configuration);
  LineWriter lines(options.json);
  std::unique_ptr<ResultLog> log;
  if (options.output) log = std::make_unique<ResultLog>(*options.output, recording->camera());

  FramePacer pacer([&] { return recording->Next(); });
  const auto next = [&] { return options.realtime ? pacer.Next() : recording->Next(); };

  DetectSummary summary;
  Damage unusable;
  std::vector<StageTimes> times;
  ProgressBar progress("detect");
  while (const std::optional<Frame> frame = next()) {
    const std::int64_t index = summary.frames++ + pacer.dropped();
    const std::optional<FrameResult> result = Decide(detector, *frame, index, unusable);
    if (result) {
      ++summary.decisions;
      summary.persons += CountAccepted(result->decision);
      times.push_back(result->milliseconds);
      if (lines.is_stdout()) progress.Clear();
      std::optional<std::vector<NumberedAlarm>> changes;
      if (alarms) changes = alarms->Add(*frame, result->decision);
      lines.Write(FrameJson(frame->utime, index, result->decision, result->milliseconds,
                            options.listed, changes));
      if (log) log->Write(*frame, *result, changes.value_or(std::vector<NumberedAlarm>{}));
    }
    progress.Update(recording->share_done(), Note(summary));
  }
  summary.dropped = pacer.dropped();
  summary.frames += summary.dropped;
  summary.damage = recording->damage();
  if (unusable.count > 0) summary.damage.example = unusable.example;
  summary.damage.count += unusable.count;
  summary.median_milliseconds = MedianTimes(times);
  if (alarms) summary.alarms = alarms->Summary();
  if (summary.frames == 0)
    throw std::runtime_error(options.input.string() + ": got no depth image that can be used (" +
                             summary.damage.example + "), expected at least one");
  lines.Close();
  if (log) log->Close();
  return summary;
}

std::string SummaryLine(const DetectSummary& summary) {
  std::string line = "frames " + std::to_string(summary.frames) + " decisions " +
                     std::to_string(summary.decisions) + " persons " +
                     std::to_string(summary.persons) + " damaged " +
                     std::to_string(summary.damage.count);
  if (summary.dropped > 0) line += " dropped " + std::to_string(summary.dropped);
  if (!summary.alarms.empty()) line += " " + summary.alarms;
  return line;
}

}  // namespace fallen
