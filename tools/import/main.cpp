// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "fallen/service/channels.hpp"
#include "tools/common/camera_option.hpp"
#include "tools/common/tool.hpp"
#include "tools/import/import_log.hpp"

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser("fallen-import",
                                             "Makes an LCM log of a TUM RGB-D style directory: "
                                             "depth.txt, camera.yaml and, where they are, "
                                             "groundtruth.txt and labels.yaml");
  std::filesystem::path directory;
  std::filesystem::path log;
  std::string camera = fallen::channels::kDefaultCamera;
  parser->add_option("directory", directory, "Directory to read")->required();
  parser->add_option("-o,--output", log, "Log to write")->required();
  parser->add_option("--camera", camera, "Camera that the channels are named after")
      ->check(fallen::CheckCameraName)
      ->capture_default_str();

  return fallen::RunTool(*parser, argc, argv, [&] {
    const fallen::ImportReport report = fallen::ImportDirectory(directory, log, camera);
    std::cerr << "frames " << report.frames << " poses " << report.poses << " labelled "
              << report.labelled << std::endl;
    return 0;
  });
}
