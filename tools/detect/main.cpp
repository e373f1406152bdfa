// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/camera_option.hpp"
#include "tools/common/tool.hpp"
#include "tools/detect/detect.hpp"
#include "tools/detect/stage_medians.hpp"

namespace {

void AddOptions(CLI::App& parser, fallen::DetectOptions& options, bool& all_candidates,
                bool& lossless) {
  parser.add_option("input", options.input, "LCM log, .oni file or directory (see fallen-import)")
      ->required();
  parser.add_option("--camera", options.camera, "Camera of a log; default: its only one")
      ->check(fallen::CheckCameraName);
  AddDetectorOptions(parser, options.detector);
  parser.add_option("--json", options.json, "File for one line of JSON a frame; -: stdout")
      ->capture_default_str();
  parser.add_option("--output", options.output,
                    "LCM log for the messages that the services would publish");
  parser.add_flag("--all-candidates", all_candidates,
                  "List every cluster, with \"accepted\" to tell persons from the others");
  parser.add_flag("--alarms", options.alarms,
                  "Fuse the decisions into alarms as fallen-alarm does: lines list what changes, "
                  "--output gets FALL_ALARM");
  CLI::Option* realtime =
      parser.add_flag("--realtime", options.realtime,
                      "At the recording's pace; frames that come too late are dropped and counted");
  parser.add_flag("--lossless", lossless, "Every frame, in order (the default)")
      ->excludes(realtime);
  parser.footer(
      "Positions are metres in the world where poses are known, else in a frame on the floor below "
      "the camera (x ahead, z up), else in the camera's.");
}

}  // namespace

int main(int argc, char** argv) {
  const auto parser =
      fallen::MakeToolParser("fallen-detect", "Finds persons lying on the ground in a recording");
  fallen::DetectOptions options;
  bool all_candidates = false;
  bool lossless = false;
  AddOptions(*parser, options, all_candidates, lossless);

  return fallen::RunTool(*parser, argc, argv, [&] {
    if (all_candidates) options.listed = fallen::ListedPersons::kAll;
    const fallen::DetectSummary summary = fallen::RunDetect(options);
    if (summary.damage.count > 0)
      std::cerr << "damage, for example: " << summary.damage.example << '\n';
    std::cerr << "median ms: " << fallen::DescribeTimes(summary.median_milliseconds) << '\n'
              << fallen::SummaryLine(summary) << std::endl;
    return 0;
  });
}
