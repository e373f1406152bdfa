// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/label/label_log.hpp"

#include <algorithm>

#include "fallen/detection/map_update.hpp"
#include "fallen/evaluation/frame_outcome.hpp"
#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/import/input_error.hpp"
#include "tools/import/label_file.hpp"

namespace fallen {
namespace {

/// What a stretch of the labels came upon in the log.
struct StretchTally {
  std::vector<std::int64_t> frames;
  int most_cells = 0;
  bool was_located = false;  ///< some frame's map was in the world
};

double SecondsSince(std::int64_t first_utime, std::int64_t utime) {
  return static_cast<double>(utime - first_utime) * 1e-6;
}

const LabelledStretch* StretchAt(const LabelFile& labels, std::int64_t frame, double seconds) {
  for (const LabelledStretch& stretch : labels.stretches)
    if (stretch.Holds(frame, seconds)) return &stretch;
  return nullptr;
}

/// Maps the recording and counts the cells in the boxes.
std::vector<StretchTally> Tally(const LabelOptions& options, const LabelFile& labels,
                                LabelReport& report) {
  const Configuration config = LoadConfiguration(options.detector.config);
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(options.log, options.camera);
  NdtMapper mapper(config.ndt);
  std::vector<StretchTally> tallies(labels.stretches.size());
  ProgressBar bar("check");
  std::int64_t first_utime = 0;
  for (; const std::optional<Frame> frame = recording->Next(); ++report.frames) {
    bar.Update(recording->share_done());
    if (report.frames == 0) first_utime = frame->utime;
    const NdtMap map = UpdateMap(mapper, *frame, config.ground);
    const LabelledStretch* stretch =
        StretchAt(labels, report.frames, SecondsSince(first_utime, frame->utime));
    if (!stretch) continue;
    ++report.labelled;
    StretchTally& tally = tallies[static_cast<std::size_t>(stretch - labels.stretches.data())];
    tally.frames.push_back(report.frames);
    if (!stretch->truth.person_box) continue;
    ++report.with_person;
    if (map.frame != MapFrame::kWorld) continue;
    tally.was_located = true;
    const int cells = CountCellsInBox(map, *stretch->truth.person_box);
    tally.most_cells = std::max(tally.most_cells, cells);
    report.positive += cells >= kMinCellsInBox;
  }
  return tallies;
}

void Check(const LabelFile& labels, const std::vector<StretchTally>& tallies, LabelReport& report) {
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const LabelledStretch& stretch = labels.stretches[i];
    const std::vector<std::int64_t>& frames = tallies[i].frames;
    if (frames.empty())
      throw InputError(labels.path, stretch.line, "a stretch without a frame",
                       "one that the log's frames 0 to " + std::to_string(report.frames - 1) +
                           " reach, and that none before it holds");
    if (stretch.truth.person_box && !tallies[i].was_located)
      throw InputError(labels.path, stretch.line, "a box, but no pose in the log",
                       "poses, to know where in the world the box is");
    if (stretch.truth.person_box && tallies[i].most_cells == 0)
      throw InputError(labels.path, stretch.line, "a box without a cell of the map in any frame",
                       "the person inside it: in metres, in the world of the poses");
    for (const std::int64_t frame : {frames.front(), frames[frames.size() / 2], frames.back()})
      if (report.frames_to_show.empty() || report.frames_to_show.back() != frame)
        report.frames_to_show.push_back(frame);
  }
}

/// Copies all events but for the camera's truth, which is written anew before its depth images.
void Copy(const LabelOptions& options, const std::string& camera, const LabelFile& labels) {
  PartialFile output(options.output);
  LogWriter writer(output.path());
  LogReader reader(options.log);
  const std::string depth = channels::Depth(camera), truth_channel = channels::GroundTruth(camera);
  ProgressBar bar("label");
  std::int64_t number = 0, first_utime = 0;
  while (const std::optional<LogEvent> event = reader.Next()) {
    bar.Update(static_cast<double>(reader.position_bytes()) /
               static_cast<double>(reader.size_bytes()));
    if (event->channel == truth_channel) continue;
    if (event->channel == depth) {
      if (const Decoded<depth_image_t> image = DecodeMessage<depth_image_t>(event->data)) {
        const Header header{image.message->header.utime, image.message->header.seq,
                            image.message->header.sensor_name};
        if (number == 0) first_utime = header.utime;
        if (const auto truth = labels.At(number, SecondsSince(first_utime, header.utime)))
          writer.Write(event->utime, truth_channel, EncodeMessage(ToMessage(header, *truth)));
        ++number;
      }
    }
    writer.Write(event->utime, event->channel, event->data);
  }
  writer.Close();
  output.Commit();
}

}  // namespace

LabelReport LabelLog(const LabelOptions& options) {
  const LabelFile labels = ReadLabelFile(options.truth);
  if (std::filesystem::is_directory(options.log))
    throw InputError(options.log, 0, "a directory",
                     "an LCM log; fallen-import takes labels.yaml from the directory");
  LabelReport report;
  const std::string camera = OpenFrameSource(options.log, options.camera)->camera();
  Check(labels, Tally(options, labels, report), report);
  Copy(options, camera, labels);
  return report;
}

}  // namespace fallen
