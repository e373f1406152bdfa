// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <thread>

#include "fallen/messages/model_files.hpp"
#include "fallen/segmentation/parallel_for.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/ablation/ablation_rows.hpp"
#include "tools/ablation/finished_rows.hpp"
#include "tools/ablation/row_difference.hpp"
#include "tools/ablation/row_evaluation.hpp"
#include "tools/common/step_progress.hpp"
#include "tools/common/tool.hpp"
#include "tools/evaluate/evaluation_report.hpp"
#include "tools/train/model_training.hpp"
#include "tools/train/observed_recordings.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs, validation;
  fs::path rows, results;
  std::optional<fs::path> config, training, maps, json;
  std::vector<std::string> only;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

/// Everything that the rows share.
struct Material {
  std::vector<ObservedRecording> training;
  ObservedPairs validation;
  Backgrounds backgrounds;
};

Backgrounds LoadBackgrounds(const Options& options, const std::vector<AblationRow>& rows,
                            const BackgroundConfig& config) {
  Backgrounds backgrounds;
  for (const AblationRow& row : rows) {
    if (row.map == MapAge::kNone || backgrounds.contains(row.map)) continue;
    if (!options.maps)
      throw std::runtime_error("row '" + row.name +
                               "': got no --maps, expected the folder of maps");
    for (const fs::path& log : options.validation)
      backgrounds[row.map].emplace_back(
          LoadEnvironmentMap(*options.maps / std::string(EnumName(row.map)) /
                             log.filename().replace_extension(".map")),
          config);
  }
  return backgrounds;
}

Material Prepare(const Options& options, const std::vector<AblationRow>& rows,
                 StepProgress& progress) {
  const Configuration deployment = LoadConfiguration(options.config);
  const ObservationConfig& observation = rows.front().training.observation;
  Material material;
  material.backgrounds = LoadBackgrounds(options, rows, deployment.background);
  const std::size_t learnt = options.logs.size(), judged = options.validation.size();
  material.training.resize(learnt);
  material.validation.accumulated.resize(judged);
  material.validation.single.resize(judged);
  std::atomic<std::size_t> done = 0;
  ParallelFor(static_cast<int>(learnt + judged), options.jobs, [&](int i) {
    const auto index = static_cast<std::size_t>(i);
    if (index < learnt)
      material.training[index] =
          ObserveRecording(options.logs[index], deployment.ground, deployment.ndt, observation);
    else
      ObservePair(options.validation[index - learnt], deployment.ground, deployment.ndt,
                  observation.frame_stride, material.validation.accumulated[index - learnt],
                  material.validation.single[index - learnt]);
    progress("mapping", static_cast<double>(++done) / static_cast<double>(learnt + judged));
  });
  RequireDisjoint(OriginsOf(material.training), OriginsOf(material.validation.accumulated));
  return material;
}

Model ModelOf(const AblationRow& row, const Material& material, int jobs,
              const TrainingProgress& progress) {
  constexpr double kCellSizeM = NdtConfig{}.cell_size_m;
  return TrainModel(material.training, material.validation.accumulated, row.training, kCellSizeM,
                    jobs, progress)
      .model;
}

/// The rows to measure: those wanted that are not finished, and the first if they need its model.
std::vector<AblationRow> Missing(const std::vector<AblationRow>& wanted, const AblationRow& first,
                                 const FinishedRows& finished) {
  std::vector<AblationRow> missing;
  for (const AblationRow& row : wanted)
    if (!finished.Find(row)) missing.push_back(row);
  const bool needs_first =
      std::any_of(missing.begin(), missing.end(), [](const auto& row) { return !row.retrains; });
  const bool has_first = finished.Find(first) && fs::exists(finished.model_file());
  if (needs_first && !has_first && missing.front().name != first.name)
    missing.insert(missing.begin(), first);
  return missing;
}

std::vector<AblationRow> Wanted(const std::vector<AblationRow>& rows,
                                const std::vector<std::string>& only) {
  if (only.empty()) return rows;
  std::vector<AblationRow> wanted;
  for (const std::string& name : only) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == name; });
    if (row == rows.end()) {
      std::string names;
      for (const AblationRow& known : rows) names += (names.empty() ? "" : ", ") + known.name;
      throw std::runtime_error("--only: got '" + name + "', expected one of " + names);
    }
    wanted.push_back(*row);
  }
  return wanted;
}

void Measure(const std::vector<AblationRow>& missing, const AblationRow& first,
             const Options& options, const FinishedRows& finished) {
  StepProgress progress;
  const TrainingProgress report = [&](const char* step, double share) { progress(step, share); };
  const Material material = Prepare(options, missing, progress);
  std::size_t number = 0;
  for (const AblationRow& row : missing) {
    progress.Announce("row " + std::to_string(++number) + " of " + std::to_string(missing.size()) +
                      ": " + row.name);
    const Model model = row.retrains ? ModelOf(row, material, options.jobs, report)
                                     : LoadModel(finished.model_file());
    if (row.name == first.name) SaveModel(finished.model_file(), model);
    const auto outcomes =
        JudgeRow(row, model, material.validation, material.backgrounds, options.jobs, report);
    finished.Keep(row, FiguresJson(outcomes, 0.5, BootstrapConfig{}), OutcomesJson(outcomes));
  }
}

/// The finished rows with their differences from the first, if that is finished, in place of their
/// outcomes.
std::vector<nlohmann::json> Results(const std::vector<AblationRow>& rows,
                                    const FinishedRows& finished) {
  const auto first = finished.Find(rows.front());
  std::vector<nlohmann::json> results;
  for (const AblationRow& row : rows) {
    auto result = finished.Find(row);
    if (!result) continue;
    if (first && row.name != rows.front().name)
      (*result)["difference"] = DifferenceJson(first->at("outcomes"), result->at("outcomes"), {});
    result->erase("outcomes");
    results.push_back(std::move(*result));
  }
  return results;
}

int Ablate(const Options& options) {
  const auto rows = LoadAblationRows(options.rows, LoadTrainingConfig(options.training));
  const auto wanted = Wanted(rows, options.only);
  const FinishedRows finished(options.results,
                              std::to_string(options.logs.size()) + " recordings to learn from, " +
                                  std::to_string(options.validation.size()) + " to judge on");
  const auto missing = Missing(wanted, rows.front(), finished);
  if (!missing.empty()) Measure(missing, rows.front(), options, finished);

  const std::vector<nlohmann::json> results = Results(rows, finished);
  if (options.json) {
    std::ofstream file(*options.json);
    file << nlohmann::json(results).dump(2) << "\n";
    if (!file.flush()) throw std::runtime_error(options.json->string() + ": cannot be written");
  }
  std::cout << MarkdownTable(results);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser = MakeToolParser(
      "fallen-ablate",
      "Trains and judges variants of the method on the same recordings: what each part is worth. "
      "Finished rows are kept: a second run goes on. tools/ablate makes all that it needs.");
  parser->add_option("LOG", options.logs, "Recordings to learn from")->required();
  parser->add_option("--validation", options.validation, "Recordings to judge on: never test sets")
      ->required();
  parser->add_option("--rows", options.rows, "The variants (YAML)")->required();
  parser->add_option("--results", options.results, "Folder of finished rows")->required();
  parser->add_option("--training", options.training, "Settings that the rows vary (YAML)");
  parser->add_option("--config", options.config,
                     "Deployment: sections ground, ndt and background are used");
  parser->add_option("--maps", options.maps,
                     "Folder with fresh/NAME.map and stale/NAME.map for each validation recording");
  parser->add_option("--only", options.only, "Name of a row to measure; repeatable")
      ->allow_extra_args(false);
  parser->add_option("--json", options.json, "Write the rows here too");
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] { return Ablate(options); });
}
