// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/camera_option.hpp"
#include "tools/common/detector_setup.hpp"
#include "tools/common/tool.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/view/frame_choice.hpp"
#include "tools/view/frame_picture.hpp"

namespace {

std::string CheckFrameChoice(const std::string& text) {
  try {
    fallen::ParseFrameChoice(text);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Name of a recording for people: its last part.
std::string NameOf(const std::filesystem::path& input) {
  return (input.has_filename() ? input : input.parent_path()).filename().string();
}

}  // namespace

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-view",
      "Makes a picture of a frame: the depth image beside the NDT map, with what was found in it");
  std::filesystem::path input;
  std::filesystem::path png;
  std::string frame = "best";
  std::optional<std::string> camera;
  fallen::DetectorOptions detector_options;
  parser->add_option("input", input, "LCM log, .oni file or directory (see fallen-import)")
      ->required();
  parser->add_option("--export", png, "Picture to write (PNG)")->required();
  parser
      ->add_option("--frame", frame, "Number of the frame from 0, or best: the highest probability")
      ->check(CheckFrameChoice)
      ->capture_default_str();
  parser->add_option("--camera", camera, "Camera of a log; default: its only one")
      ->check(fallen::CheckCameraName);
  AddDetectorOptions(*parser, detector_options);

  return fallen::RunTool(*parser, argc, argv, [&] {
    fallen::Detector detector = fallen::MakeDetector(detector_options);
    const auto recording = fallen::OpenFrameSource(input, camera);
    const fallen::ViewedFrame viewed =
        FindFrame(*recording, detector, fallen::ParseFrameChoice(frame), NameOf(input));
    SaveFramePicture(png, viewed);
    std::cerr << "frame " << viewed.index << ": " << DescribeFrame(viewed) << std::endl;
    return 0;
  });
}
