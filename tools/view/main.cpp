// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>
#include <string>

#include "tools/common/tool.hpp"
#include "tools/picture/frame_choice.hpp"
#include "tools/picture/frame_film.hpp"
#include "tools/picture/frame_picture.hpp"
#include "tools/view/serve_page.hpp"
#include "tools/view/view_options.hpp"

namespace {

int ExportFilm(const fallen::ViewOptions& options) {
  fallen::Detector detector = fallen::MakeDetector(options.detector);
  const auto recording = fallen::OpenInput(options);
  const std::int64_t frames =
      SaveFilm(options.export_file, *recording, detector, fallen::NameOf(options.input));
  std::cerr << "film of " << frames << " frames" << std::endl;
  return 0;
}

int ExportPicture(const fallen::ViewOptions& options) {
  fallen::Detector detector = fallen::MakeDetector(options.detector);
  const auto recording = fallen::OpenInput(options);
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
  const std::string kind = options.export_file.extension();
  if (kind == ".mp4") return ExportFilm(options);
  if (kind == ".png") return ExportPicture(options);
  throw std::runtime_error(options.export_file.string() +
                           ": expected a name that ends in .png or .mp4");
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
