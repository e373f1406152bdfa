// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "tools/common/tool.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/view/picture/frame_choice.hpp"
#include "tools/view/picture/frame_picture.hpp"
#include "tools/view/serve_page.hpp"
#include "tools/view/view_options.hpp"

namespace {

int ExportPicture(const fallen::ViewOptions& options) {
  fallen::Detector detector = fallen::MakeDetector(options.detector);
  const auto recording = fallen::OpenFrameSource(options.input, options.camera);
  const fallen::ViewedFrame viewed = FindFrame(
      *recording, detector, fallen::ParseFrameChoice(options.frame), fallen::NameOf(options.input));
  SaveFramePicture(options.export_file, viewed);
  std::cerr << "frame " << viewed.index << ": " << DescribeFrame(viewed) << std::endl;
  return 0;
}

int View(const fallen::ViewOptions& options) {
  if (options.export_file.empty()) return fallen::ServePage(options);
  if (options.input.empty())
    throw std::runtime_error("--export: got no input, expected a recording to make a picture of");
  return ExportPicture(options);
}

}  // namespace

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-view",
      "Shows what the detector sees as a page in the browser, live or from a recording, and makes "
      "pictures of it");
  fallen::ViewOptions options;
  AddViewOptions(*parser, options);
  return fallen::RunTool(*parser, argc, argv, [&] { return View(options); });
}
