// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/camera_option.hpp"
#include "tools/common/tool.hpp"
#include "tools/map/build_map.hpp"
#include "tools/map/map_info.hpp"

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-map",
      "Builds the environment map of a place that is known to be without fallen persons");
  fallen::BuildMapOptions options;
  std::filesystem::path map;
  CLI::Option* info = parser->add_option("--info", map, "Say what a map holds, and build none");
  CLI::Option* inputs = parser->add_option(
      "inputs", options.inputs,
      "Recordings with poses (LCM logs, import directories; labelled persons are "
      "left out), and clouds (.ply, .pcd; z up, the floor at 0), all in one world");
  CLI::Option* output = parser->add_option("-o,--output", options.output, "Map to write");
  inputs->needs(output);
  output->needs(inputs);
  inputs->excludes(info);
  parser->add_option("--config", options.config, "Configuration (YAML); default: all defaults");
  parser->add_option("--camera", options.camera, "Camera of the logs; default: their only one")
      ->check(fallen::CheckCameraName);
  parser->add_option("--cell-size", options.cell_size_m,
                     "Edge of a cell [m]; default: ndt.cell_size_m");
  parser->add_option("--description", options.description,
                     "Text kept in the map; default: the inputs");
  parser->callback([&] {
    if (!*info && !*inputs) throw CLI::RequiredError("inputs");
  });

  return fallen::RunTool(*parser, argc, argv, [&] {
    if (*info) {
      std::cout << fallen::DescribeMapFile(map) << std::flush;
      return 0;
    }
    const fallen::BuildMapReport report = fallen::BuildMap(options);
    std::cerr << "cells " << report.cells << " frames " << report.frames << " without_pose "
              << report.frames_without_pose << " damaged " << report.damaged << " points "
              << report.points << std::endl;
    return 0;
  });
}
