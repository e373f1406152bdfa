// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

#include "fallen/segmentation/parallel_for.hpp"
#include "fallen/service/configuration.hpp"
#include "fallen/service/load_files.hpp"
#include "tools/common/detector_setup.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"
#include "tools/evaluate_alarm/alarm_report.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs;
  DetectorOptions detector;
  std::vector<fs::path> compared;  ///< configurations whose alarm is judged on the same decisions
  std::optional<fs::path> json;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

/// A fusion for each configuration: the detector's first, then the compared ones.
std::vector<AlarmFusion> MakeFusions(const Options& options) {
  std::vector<std::optional<fs::path>> files = {options.detector.config};
  files.insert(files.end(), options.compared.begin(), options.compared.end());
  std::vector<AlarmFusion> fusions;
  for (const std::optional<fs::path>& file : files) {
    const Configuration configuration = LoadConfiguration(file);
    fusions.emplace_back(configuration.alarm, LoadAlarmScopeFor(configuration));
  }
  return fusions;
}

/// Outcomes by fusion, then drive.
std::vector<std::vector<DriveOutcome>> EvaluateAll(const Options& options) {
  const std::vector<AlarmFusion> fusions = MakeFusions(options);
  std::vector<std::vector<DriveOutcome>> outcomes(fusions.size(),
                                                  std::vector<DriveOutcome>(options.logs.size()));
  ProgressBar bar("evaluate");
  std::mutex mutex;
  std::size_t done = 0;
  ParallelFor(static_cast<int>(options.logs.size()), options.jobs, [&](int i) {
    const DriveTrace trace = TraceDrive(options.logs[i], MakeDetector(options.detector));
    for (std::size_t k = 0; k < fusions.size(); ++k) outcomes[k][i] = JudgeDrive(trace, fusions[k]);
    const std::lock_guard lock(mutex);
    bar.Update(static_cast<double>(++done) / static_cast<double>(options.logs.size()));
  });
  return outcomes;
}

int Evaluate(const Options& options) {
  const std::vector<std::vector<DriveOutcome>> outcomes = EvaluateAll(options);
  nlohmann::ordered_json report = AlarmFigures(outcomes.front());
  for (std::size_t k = 0; k < options.compared.size(); ++k)
    report["compared"][options.compared[k].string()] = AlarmFigures(outcomes[k + 1])["alarm"];
  std::cout << report.dump(2) << "\n";
  if (!options.json) return 0;
  report["sequences"] = DriveList(outcomes.front());
  std::ofstream file(*options.json);
  file << report.dump(2) << "\n";
  if (!file.flush()) throw std::runtime_error(options.json->string() + ": cannot be written");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser = MakeToolParser(
      "fallen-evaluate-alarm",
      "Measures the alarm on drives with poses and ground truth, beside single decisions");
  parser->add_option("LOG", options.logs, "Recordings with ground truth, a drive each")->required();
  AddDetectorOptions(*parser, options.detector);
  parser
      ->add_option("--compare", options.compared,
                   "Judge the alarm of these configurations too, on the same decisions: of each "
                   "only its alarm and zones count")
      ->allow_extra_args(false);
  parser->add_option("--json", options.json, "Write figures here, drive by drive too");
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] { return Evaluate(options); });
}
