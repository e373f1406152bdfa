// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>
#include <numbers>

#include "tools/common/tool.hpp"
#include "tools/compose/compose_log.hpp"

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-compose",
      "Sets the points of a lying person onto free floor in the frames of a recording without one, "
      "and writes a log with ground truth: for evaluation");
  fallen::ComposeOptions options;
  std::vector<double> turns_deg = {-45, 0, 45};
  std::string up = "-y";
  parser
      ->add_option("PERSON", options.person, "Points of a lying person and nothing else (PCD, PLY)")
      ->required();
  parser->add_option("SCENE", options.scene, "Log, .oni file or directory (see fallen-import)")
      ->required();
  parser->add_option("-o,--output", options.log, "Log to write")->required();
  parser->add_option("--up", up, "Up in the cloud: -y (a camera's optical frame) or z")
      ->check(CLI::IsMember({"-y", "z"}))
      ->capture_default_str();
  parser
      ->add_option("--floor-cut", options.floor_cut_m,
                   "Height up to which the person was cut away with the floor [m]: the surface is "
                   "continued down to it; 0: the lowest points touched the floor")
      ->check(CLI::Range(0.0, 0.2))
      ->capture_default_str();
  parser->add_option("--frames", options.frames, "Frames of the scene to use, evenly spread")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  parser->add_option("--places", options.places, "Places in each frame at most; one image a place")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  parser
      ->add_option("--turn", turns_deg,
                   "Turn the person by these angles [deg] from the aspect that the cloud was taken "
                   "from; a cloud of one view has no back, so beyond 60 it looks hollow")
      ->delimiter(',')
      ->capture_default_str();
  parser->add_option("--min-distance", options.search.min_distance_m, "Nearest place [m]")
      ->check(CLI::Range(0.3, 20.0))
      ->capture_default_str();
  parser->add_option("--max-distance", options.search.max_distance_m, "Farthest place [m]")
      ->check(CLI::Range(0.3, 20.0))
      ->capture_default_str();
  parser
      ->add_option(
          "--disparity-step", options.composition.disparity_step_px,
          "Steps of the sensor [px of a 640 px wide image]; 0: finer than the image's unit")
      ->check(CLI::Range(0.0, 2.0))
      ->capture_default_str();
  parser
      ->add_option("--noise", options.composition.noise_scale,
                   "Times the noise of a structured-light camera that the person gets, as the "
                   "scene has its own; 0: none")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  parser->add_option("--seed", options.seed, "Of the choice of places and of the noise")
      ->capture_default_str();

  return fallen::RunTool(*parser, argc, argv, [&] {
    options.up = up == "z" ? fallen::CloudUp::kZ : fallen::CloudUp::kMinusY;
    options.search.turns_rad.clear();
    for (const double turn : turns_deg)
      options.search.turns_rad.push_back(turn * std::numbers::pi / 180);
    const fallen::ComposeReport report = fallen::ComposeLog(options);
    std::cerr << "frames " << report.used_frames << " without floor " << report.without_floor
              << " without place " << report.without_place << " images " << report.images
              << std::endl;
    return 0;
  });
}
