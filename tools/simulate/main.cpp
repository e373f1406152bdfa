// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <thread>

#include "simulate/preview.hpp"
#include "simulate/recording.hpp"

namespace {

// A bar where somebody watches, nothing in a file.
void ShowProgress(int done, int total) {
  constexpr int kWidth = 40;
  static const bool watched = isatty(STDERR_FILENO) != 0;
  if (!watched) return;
  const int filled = kWidth * done / total;
  std::fprintf(stderr, "\r[%s%s] %d/%d", std::string(static_cast<std::size_t>(filled), '#').c_str(),
               std::string(static_cast<std::size_t>(kWidth - filled), ' ').c_str(), done, total);
  if (done == total) std::fprintf(stderr, "\n");
}

int Run(const std::string& scenario_file, const std::string& output,
        const std::vector<std::string>& set, int jobs, const std::string& preview,
        const std::optional<std::filesystem::path>& assets_folder, bool describe) {
  using namespace fallen::sim;
  const Scenario scenario = LoadScenario(scenario_file, set);
  if (describe) std::printf("%s\n", DescribeScenario(scenario).c_str());
  if (output.empty() && preview.empty()) return 0;
  const Assets assets = LoadAssets(AssetsFolder(assets_folder));
  const Simulation simulation(scenario, assets);
  if (!preview.empty()) WritePng(preview, DrawPreview(simulation, std::min(4, scenario.frames)));
  if (output.empty()) return 0;
  std::fprintf(stderr, "%s\n", DescribeScenario(scenario).c_str());
  WriteRecording(simulation, output, jobs, [&](int done) { ShowProgress(done, scenario.frames); });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Simulates recordings of a depth camera on a mobile robot, with ground truth");
  app.set_version_flag("--version", FALLEN_VERSION);
  std::string scenario, output, preview;
  std::vector<std::string> set;
  std::optional<std::filesystem::path> assets;
  bool describe = false;
  int jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  app.add_option("scenario", scenario, "YAML file; what it leaves open is drawn from its seed")
      ->required();
  app.add_option("-o,--output", output, "LCM log to write");
  app.add_option("--set", set, "Overrides a key of the scenario: key=value")->take_all();
  app.add_option_function<int>(
      "--frames", [&](int frames) { set.push_back("frames=" + std::to_string(frames)); },
      "Number of pictures, as --set frames=N");
  app.add_option("--jobs", jobs, "Threads; the log does not depend on it")
      ->check(CLI::Range(1, 1024));
  app.add_option("--preview", preview, "PNG with some frames, labels and the room from above");
  app.add_option("--assets", assets,
                 "Folder that tools/fetch-assets filled (default: $FALLEN_ASSETS)");
  app.add_flag("--describe", describe, "Prints the scenario with all that was drawn, as JSON");
  try {
    app.parse(argc, argv);
    if (output.empty() && preview.empty() && !describe)
      throw CLI::ValidationError("arguments",
                                 "got nothing to do, expected --output, --preview or --describe");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "fallen-simulate: %s\n", error.what());
    return 2;
  }
  try {
    return Run(scenario, output, set, jobs, preview, assets, describe);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fallen-simulate: %s\n", error.what());
    return 2;
  }
}
