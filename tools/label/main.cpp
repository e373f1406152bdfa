// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "tools/common/camera_option.hpp"
#include "tools/common/tool.hpp"
#include "tools/evaluate/case_pictures.hpp"
#include "tools/label/label_log.hpp"

namespace {

using namespace fallen;

void DrawPreview(const LabelOptions& options, const std::vector<std::int64_t>& frames,
                 const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::vector<CasePicture> pictures;
  for (const std::int64_t frame : frames)
    pictures.push_back(
        {options.output.string(), frame, folder / ("frame-" + std::to_string(frame) + ".png")});
  DrawCases(pictures, options.detector, 1);
}

}  // namespace

int main(int argc, char** argv) {
  LabelOptions options;
  std::optional<std::filesystem::path> preview;
  const auto parser = MakeToolParser(
      "fallen-label",
      "Writes a person's labels into a copy of a log, for fallen-train and fallen-evaluate");
  parser->add_option("RECORDING", options.log, "LCM log with robot poses")->required();
  parser->add_option("--truth", options.truth, "labels.yaml: see models/README.md")->required();
  parser->add_option("-o,--output", options.output, "Log to write")->required();
  parser->add_option("--camera", options.camera, "Camera that is labelled; default: the only one")
      ->check(CheckCameraName);
  parser->add_option("--preview", preview,
                     "Folder for pictures of the first, middle and last frame of each stretch");
  AddDetectorOptions(*parser, options.detector);
  return RunTool(*parser, argc, argv, [&] {
    const LabelReport report = LabelLog(options);
    if (preview) DrawPreview(options, report.frames_to_show, *preview);
    std::cerr << "frames " << report.frames << " labelled " << report.labelled << " with_person "
              << report.with_person << " positive " << report.positive << std::endl;
    return 0;
  });
}
