// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

#include "fallen/messages/model_files.hpp"
#include "fallen/segmentation/parallel_for.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"
#include "tools/train/model_training.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs;
  std::vector<fs::path> validation;
  fs::path model;
  std::optional<fs::path> config;
  std::optional<fs::path> training;
  fs::path report;
  double validation_share = 0.25;
  std::string description;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

// One bar for each step, whichever thread reports.
class StepProgress {
 public:
  void operator()(const char* step, double share) {
    const std::lock_guard lock(mutex_);
    if (step_ != step) {
      bar_.reset();
      bar_ = std::make_unique<ProgressBar>(step);
      step_ = step;
    }
    bar_->Update(share);
  }

 private:
  std::mutex mutex_;
  std::string step_;
  std::unique_ptr<ProgressBar> bar_;
};

std::vector<ObservedRecording> Observe(const std::vector<fs::path>& logs,
                                       const Configuration& deployment,
                                       const TrainingConfig& config, int jobs,
                                       const TrainingProgress& progress) {
  std::vector<ObservedRecording> recordings(logs.size());
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(logs.size()), jobs, [&](int i) {
    recordings[i] =
        ObserveRecording(logs[i], deployment.ground, deployment.ndt, config.observation);
    progress("mapping", static_cast<double>(++done) / static_cast<double>(logs.size()));
  });
  return recordings;
}

std::vector<RecordingOrigin> Origins(const std::vector<ObservedRecording>& recordings) {
  std::vector<RecordingOrigin> origins;
  for (const ObservedRecording& recording : recordings) origins.push_back(recording.origin);
  return origins;
}

// Moves the recordings of the validation side out of `recordings`.
std::vector<ObservedRecording> SplitOff(std::vector<ObservedRecording>& recordings, double share,
                                        std::int64_t seed) {
  const RecordingSplit split =
      SplitByPersonAndRoom(Origins(recordings), share, static_cast<std::uint64_t>(seed));
  std::vector<ObservedRecording> training, validation;
  for (const std::size_t i : split.training) training.push_back(std::move(recordings[i]));
  for (const std::size_t i : split.validation) validation.push_back(std::move(recordings[i]));
  recordings = std::move(training);
  return validation;
}

int Train(const Options& options) {
  const Configuration deployment = LoadConfiguration(options.config);
  const TrainingConfig config = LoadTrainingConfig(options.training);
  auto steps = std::make_shared<StepProgress>();
  const TrainingProgress progress = [steps](const char* step, double share) {
    (*steps)(step, share);
  };

  std::vector<ObservedRecording> training =
      Observe(options.logs, deployment, config, options.jobs, progress);
  std::vector<ObservedRecording> validation;
  if (options.validation.empty()) {
    validation = SplitOff(training, options.validation_share, config.sampling.seed);
  } else {
    validation = Observe(options.validation, deployment, config, options.jobs, progress);
    RequireDisjoint(Origins(training), Origins(validation));
  }

  TrainedModel trained =
      TrainModel(training, validation, config, deployment.ndt.cell_size_m, options.jobs, progress);
  trained.model.description = options.description;
  trained.report["description"] = options.description;
  steps.reset();
  SaveModel(options.model, trained.model);
  if (!options.report.empty()) {
    std::ofstream file(options.report);
    file << trained.report.dump(2) << "\n";
    if (!file.flush()) throw std::runtime_error(options.report.string() + ": cannot be written");
  }
  std::cout << SummaryText(trained.report);
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
  parser->add_option("--validation", options.validation, "Recordings of other persons and rooms");
  parser->add_option("--validation-share", options.validation_share,
                     "Share of the recordings to split off, if none are named");
  parser->add_option("--config", options.config, "Deployment: sections ground and ndt are used");
  parser->add_option("--training", options.training, "Settings of the training (YAML)");
  parser->add_option("--report", options.report, "Write the record of the training here (JSON)");
  parser->add_option("--description", options.description, "Text that the model file carries");
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] { return Train(options); });
}
