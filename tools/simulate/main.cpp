// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"
#include "tools/simulate/preview.hpp"
#include "tools/simulate/recording.hpp"
#include "tools/simulate/recording_report.hpp"

namespace {

struct Arguments {
  std::filesystem::path scenario;
  std::optional<std::filesystem::path> output, preview, report, assets;
  std::vector<std::string> settings;
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bool describe = false;
};

int Run(const Arguments& arguments) {
  using namespace fallen::sim;
  const bool simulate = arguments.output || arguments.preview || arguments.report;
  if (!simulate && !arguments.describe)
    throw std::invalid_argument(
        "got nothing to do, expected --output, --preview, --report or --describe");
  const Scenario scenario = LoadScenario(arguments.scenario, arguments.settings);
  if (arguments.describe) std::cout << DescribeScenario(scenario) << std::endl;
  if (!simulate) return 0;
  const Assets assets = LoadAssets(AssetsFolder(arguments.assets));
  const Simulation simulation(scenario, assets);
  constexpr int kPreviewFrames = 4;
  if (arguments.preview)
    WritePng(*arguments.preview,
             DrawPreview(simulation, std::min(kPreviewFrames, scenario.frames)));
  if (arguments.report) {
    fallen::PartialFile report(*arguments.report);
    std::ofstream stream(report.path());
    if (!(stream << DescribeRecording(simulation) << "\n" << std::flush))
      throw std::runtime_error(arguments.report->string() + ": cannot be written");
    report.Commit();
  }
  if (!arguments.output) return 0;
  fallen::PartialFile log(*arguments.output);
  fallen::ProgressBar bar("simulate");
  WriteRecording(simulation, log.path(), arguments.jobs, [&](int done) {
    bar.Update(static_cast<double>(done) / scenario.frames, "frame " + std::to_string(done));
  });
  log.Commit();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  const auto parser = fallen::MakeToolParser(
      "fallen-simulate",
      "Simulates recordings of a depth camera on a mobile robot, with ground truth");
  parser
      ->add_option("scenario", arguments.scenario,
                   "YAML file; what it leaves open is drawn from its seed")
      ->required();
  parser->add_option("-o,--output", arguments.output, "LCM log to write");
  parser->add_option("--set", arguments.settings, "Overrides a key of the scenario: key=value")
      ->allow_extra_args(false);
  parser->add_option_function<int>(
      "--frames",
      [&](int frames) { arguments.settings.push_back("frames=" + std::to_string(frames)); },
      "Number of pictures, as --set frames=N");
  parser->add_option("--jobs", arguments.jobs, "Threads; the log does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  parser->add_option("--preview", arguments.preview,
                     "PNG with some frames, labels and the room from above");
  parser->add_option("--report", arguments.report,
                     "JSON with what is true of the recording: placement, visible share, ...");
  parser->add_option(
      "--assets", arguments.assets,
      "Folder that tools/fetch-assets filled (default: $FALLEN_ASSETS, else assets/)");
  parser->add_flag("--describe", arguments.describe,
                   "Prints the scenario with all that was drawn, as JSON");
  return fallen::RunTool(*parser, argc, argv, [&] { return Run(arguments); });
}
