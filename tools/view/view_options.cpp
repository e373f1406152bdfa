// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/view_options.hpp"

#include <CLI/CLI.hpp>

#include "fallen/service/configuration.hpp"
#include "tools/common/camera_option.hpp"
#include "tools/picture/frame_choice.hpp"

namespace fallen {
namespace {

std::string CheckFrameChoice(const std::string& text) {
  try {
    ParseFrameChoice(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

std::unique_ptr<FrameSource> OpenInput(const ViewOptions& options) {
  return OpenFrameSource(options.input, options.camera,
                         LoadConfiguration(options.detector.config).capture.T_robot_camera());
}

std::string NameOf(const std::filesystem::path& input) {
  return (input.has_filename() ? input : input.parent_path()).filename().string();
}

void AddViewOptions(CLI::App& parser, ViewOptions& options) {
  parser.add_option("input", options.input,
                    "LCM log, .oni file or directory (see fallen-import); without: live from LCM");
  parser
      .add_option("--camera", options.camera,
                  "Camera; default: a log's only one, else the "
                  "configuration's")
      ->check(CheckCameraName);
  parser.add_option("--lcm-url", options.lcm_url, "LCM URL; default: the configuration's");
  parser.add_flag("--detect", options.detects_anew,
                  "Run the detector over a log, though it holds what was decided");
  AddDetectorOptions(parser, options.detector);
  parser.add_option("--export", options.export_file,
                    "Write a picture (.png) or a film (.mp4) instead");
  parser
      .add_option("--frame", options.frame,
                  "For a picture: number of the frame from 0, or best: the highest probability")
      ->check(CheckFrameChoice)
      ->capture_default_str();
  parser
      .add_option("--address", options.server.address,
                  "Where the page is served; an address that others reach wants a token")
      ->capture_default_str();
  parser.add_option("--port", options.server.port, "0: any that is free")->capture_default_str();
  parser.add_option(
      "--token-file", options.token_file,
      "File with the token in its first line; default: a new one, where one is wanted");
  parser.add_option("--page", options.page,
                    "Folder of the page's files; default: the shipped ones");
}

}  // namespace fallen
