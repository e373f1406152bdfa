// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

#include "fallen/messages/baseline_files.hpp"
#include "fallen/messages/model_files.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/common/detector_setup.hpp"
#include "tools/common/step_progress.hpp"
#include "tools/common/tool.hpp"
#include "tools/train/baseline_training.hpp"
#include "tools/train/model_training.hpp"
#include "tools/train/observed_recordings.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs;
  std::vector<fs::path> validation;
  fs::path model;
  bool is_baseline = false;
  std::optional<fs::path> config;
  std::optional<fs::path> training;
  std::optional<Preset> preset;
  fs::path report;
  double validation_share = 0.25;
  std::string description;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

// Training and validation recordings, observed; no person or room on both sides.
template <class ObserveTraining, class ObserveValidation>
auto Observe(const Options& options, std::int64_t seed, const TrainingProgress& progress,
             const ObserveTraining& observe_training, const ObserveValidation& observe_validation) {
  auto training = ObserveRecordings(options.logs, options.jobs, progress, observe_training);
  if (options.validation.empty()) {
    auto split_off = SplitOffValidation(training, options.validation_share, seed);
    return std::pair(std::move(training), std::move(split_off));
  }
  auto validation =
      ObserveRecordings(options.validation, options.jobs, progress, observe_validation);
  RequireDisjoint(OriginsOf(training), OriginsOf(validation));
  return std::pair(std::move(training), std::move(validation));
}

void WriteReport(const fs::path& path, const nlohmann::json& report) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << report.dump(2) << "\n";
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

TrainingProgress ShowProgress() {
  return [steps = std::make_shared<StepProgress>()](const char* step, double share) {
    (*steps)(step, share);
  };
}

int TrainDetector(const Options& options) {
  const Configuration deployment = LoadConfiguration(options.config);
  const TrainingConfig config =
      LoadTrainingConfig(options.preset ? PresetTrainingPath(*options.preset) : options.training);
  TrainingProgress progress = ShowProgress();
  const auto observe = [&](const fs::path& log) {
    return ObserveRecording(log, deployment.ground, deployment.ndt, config.observation);
  };
  const auto [training, validation] =
      Observe(options, config.sampling.seed, progress, observe, observe);
  TrainedModel trained =
      TrainModel(training, validation, config, deployment.ndt.cell_size_m, options.jobs, progress);
  progress = {};  // the bar ends
  trained.model.description = options.description;
  trained.report["description"] = options.description;
  SaveModel(options.model, trained.model);
  WriteReport(options.report, trained.report);
  std::cout << SummaryText(trained.report);
  return 0;
}

int TrainComparison(const Options& options) {
  const Configuration deployment = LoadConfiguration(options.config);
  const BaselineTrainingConfig config = LoadBaselineTrainingConfig(options.training);
  config.Validate();
  TrainingProgress progress = ShowProgress();
  // Cells are counted where figures are measured: on recordings split off the others too.
  const BaselineObservation learnt{deployment.ground, deployment.ndt, config.baseline,
                                   config.sampling.frame_stride, options.validation.empty()};
  const BaselineObservation measured{deployment.ground, deployment.ndt, config.baseline,
                                     config.sampling.validation_frame_stride, true};
  const auto [training, validation] = Observe(
      options, config.sampling.seed, progress,
      [&](const fs::path& log) { return ObserveForBaseline(log, learnt); },
      [&](const fs::path& log) { return ObserveForBaseline(log, measured); });
  TrainedBaseline trained = TrainBaseline(training, validation, config, options.jobs, progress);
  progress = {};
  trained.model.description = options.description;
  trained.report["description"] = options.description;
  SaveBaselineModel(options.model, trained.model);
  WriteReport(options.report, trained.report);
  trained.report.erase("settings");
  std::cout << trained.report.dump(2) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser =
      MakeToolParser("fallen-train",
                     "Trains a model on logs with ground truth. Validation is by unseen persons "
                     "and rooms: split off the logs, or named with --validation.");
  parser->add_option("LOG", options.logs, "Recordings to train on")->required();
  parser->add_option("-o,--output", options.model, "Model file to write")->required();
  CLI::Option* const baseline = parser->add_flag(
      "--baseline", options.is_baseline,
      "Train the comparison detector instead: clusters and layers of surface normals");
  parser->add_option("--validation", options.validation, "Recordings of other persons and rooms");
  parser->add_option("--validation-share", options.validation_share,
                     "Share of the recordings to split off, if none are named");
  parser->add_option("--config", options.config, "Deployment: sections ground and ndt are used");
  CLI::Option* const training =
      parser->add_option("--training", options.training, "Settings of the training (YAML)");
  AddPresetOption(*parser, options.preset,
                  "Settings of the method as the paper has it (paper): models/paper.yaml");
  parser->get_option("--preset")->excludes(training)->excludes(baseline);
  parser->add_option("--report", options.report, "Write the record of the training here (JSON)");
  parser->add_option("--description", options.description, "Text that the model file carries");
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] {
    return options.is_baseline ? TrainComparison(options) : TrainDetector(options);
  });
}
