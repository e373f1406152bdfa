// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

#include "fallen/segmentation/parallel_for.hpp"
#include "tools/common/detector_setup.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/tool.hpp"
#include "tools/evaluate/error_report.hpp"
#include "tools/evaluate/evaluation_report.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs;
  std::vector<std::string> compared;  // NAME=MODEL
  std::optional<Preset> preset;       // measured beside the detector
  DetectorOptions detector;
  bool with_baseline = false;
  std::string baseline_model;
  std::optional<fs::path> json;
  std::vector<fs::path> plots;
  std::optional<fs::path> report;
  std::size_t report_cases = 20;
  BootstrapConfig bootstrap;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

std::vector<MethodChoice> MethodsOf(const Options& options) {
  using Place = nlohmann::json::json_pointer;
  std::vector<MethodChoice> methods = {
      DetectorMethod("detector", Place("/detector"), options.detector)};
  if (options.preset) {
    DetectorOptions compared = options.detector;
    compared.model = PresetModelPath(*options.preset).string();
    const std::string name(EnumName(*options.preset));
    methods.push_back(DetectorMethod(name, Place("/compared") / name, compared));
  }
  for (const std::string& text : options.compared) {
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
      throw std::runtime_error("--compare: got '" + text + "', expected NAME=MODEL");
    DetectorOptions compared = options.detector;
    compared.model = text.substr(equals + 1);
    const std::string name = text.substr(0, equals);
    methods.push_back(DetectorMethod(name, Place("/compared") / name, compared));
  }
  if (options.with_baseline)
    methods.push_back(BaselineMethod(options.baseline_model, options.detector));
  return methods;
}

/// Outcomes of every method on every log, method by method.
std::vector<std::vector<SequenceOutcome>> EvaluateAll(const Options& options,
                                                      const std::vector<MethodChoice>& methods) {
  const std::size_t logs = options.logs.size();
  std::vector<std::vector<SequenceOutcome>> outcomes(methods.size());
  for (auto& sequences : outcomes) sequences.resize(logs);
  ProgressBar bar("evaluate");
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t runs = methods.size() * logs;
  ParallelFor(static_cast<int>(runs), options.jobs, [&](int i) {
    const std::size_t method = i / logs, log = i % logs;
    const std::unique_ptr<EvaluatedMethod> fresh = methods[method].make();
    outcomes[method][log] = EvaluateSequence(options.logs[log], *fresh);
    const std::lock_guard lock(mutex);
    bar.Update(static_cast<double>(++done) / static_cast<double>(runs));
  });
  return outcomes;
}

void WriteJson(const fs::path& path, const nlohmann::json& json) {
  std::ofstream file(path);
  file << json.dump(2) << "\n";
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

void ReportErrors(const std::vector<SequenceOutcome>& sequences, const Options& options) {
  ErrorReportHead head;
  head.min_probability = sequences.front().min_probability;
  std::vector<ErrorCase> cases;
  for (const SequenceOutcome& sequence : sequences) {
    ++head.recordings;
    head.frames += static_cast<std::int64_t>(sequence.frames.size());
    cases.insert(cases.end(), sequence.cases.begin(), sequence.cases.end());
  }
  WriteErrorReport(*options.report, PickWorstCases(std::move(cases), options.report_cases), head,
                   options.detector, options.jobs);
}

int Evaluate(const Options& options) {
  const std::vector<MethodChoice> methods = MethodsOf(options);
  const auto outcomes = EvaluateAll(options, methods);
  nlohmann::json report, shown;
  std::vector<NamedCurve> curves;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::vector<SequenceOutcome>& sequences = outcomes[m];
    const double min_probability = sequences.front().min_probability;
    nlohmann::json figures = FiguresJson(sequences, min_probability, options.bootstrap);
    figures["kinds"] = KindsJson(sequences, min_probability);
    shown[methods[m].name] = figures;
    report[methods[m].place] = std::move(figures);
    if (m == 0) report["sequences"] = SequencesJson(sequences, min_probability);
    curves.push_back({methods[m].name, CurveOf(sequences)});
  }
  if (options.json) WriteJson(*options.json, report);
  for (const fs::path& plot : options.plots) PlotCurves(curves, plot);
  if (options.report) ReportErrors(outcomes.front(), options);
  std::cout << (methods.size() == 1 ? shown["detector"] : shown).dump(2) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser =
      MakeToolParser("fallen-evaluate",
                     "Measures the detector on logs with ground truth, by the paper's protocol");
  parser->add_option("LOG", options.logs, "Recordings with ground truth")->required();
  AddModelOptions(*parser, options.detector);
  AddPresetOption(*parser, options.preset,
                  "Measure the method as the paper has it too (paper), on the same frames");
  parser->add_option("--json", options.json, "Write figures here, sequence by sequence too");
  CLI::Option* const baseline = parser->add_flag(
      "--baseline", options.with_baseline,
      "Measure the comparison detector too, on the same frames: Euclidean clusters and layers of "
      "surface normals");
  parser
      ->add_option("--baseline-model", options.baseline_model,
                   "Its model (fallen-train --baseline); default: the shipped")
      ->needs(baseline);
  parser
      ->add_option("--compare", options.compared,
                   "NAME=MODEL: measure another model too, on the same frames; repeatable")
      ->allow_extra_args(false);
  parser
      ->add_option("--plot", options.plots,
                   "Draw miss rate against false positives (.svg, .png), all methods in one "
                   "picture; repeatable")
      ->allow_extra_args(false);
  CLI::Option* const report = parser->add_option("--report", options.report,
                                                 "Folder for the detector's worst misses and false "
                                                 "alarms, with a picture of each (index.html)");
  parser->add_option("--report-cases", options.report_cases, "Of each at most so many")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str()
      ->needs(report);
  parser
      ->add_option("--resamples", options.bootstrap.resamples,
                   "Resamples of the sequences for the confidence intervals")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  parser->add_option("--seed", options.bootstrap.seed, "Of the resampling")->capture_default_str();
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] { return Evaluate(options); });
}
