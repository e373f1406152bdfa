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
#include "tools/evaluate/evaluation_report.hpp"
#include "tools/evaluate/sequence_evaluation.hpp"

namespace {

using namespace fallen;
namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> logs;
  DetectorOptions detector;
  std::optional<fs::path> json;
  std::optional<fs::path> plot;
  int jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

std::vector<SequenceOutcome> EvaluateAll(const Options& options) {
  std::vector<SequenceOutcome> sequences(options.logs.size());
  ProgressBar bar("evaluate");
  std::mutex mutex;
  std::size_t done = 0;
  ParallelFor(static_cast<int>(options.logs.size()), options.jobs, [&](int i) {
    sequences[i] = EvaluateSequence(options.logs[i], MakeDetector(options.detector));
    const std::lock_guard lock(mutex);
    bar.Update(static_cast<double>(++done) / static_cast<double>(options.logs.size()));
  });
  return sequences;
}

int Evaluate(const Options& options) {
  const std::vector<SequenceOutcome> sequences = EvaluateAll(options);
  std::vector<FrameOutcome> frames;
  for (const SequenceOutcome& sequence : sequences)
    frames.insert(frames.end(), sequence.frames.begin(), sequence.frames.end());
  const DetectionErrorTradeoff curve = ComputeTradeoff(frames);
  const double min_probability = sequences.front().min_probability;

  const nlohmann::json figures = FiguresJson(curve, min_probability);
  if (options.json) {
    const nlohmann::json report = {{"detector", figures},
                                   {"sequences", SequencesJson(sequences, min_probability)}};
    std::ofstream file(*options.json);
    file << report.dump(2) << "\n";
    if (!file.flush()) throw std::runtime_error(options.json->string() + ": cannot be written");
  }
  if (options.plot) PlotCurves({{"detector", curve}}, *options.plot);
  std::cout << figures.dump(2) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  const auto parser =
      MakeToolParser("fallen-evaluate",
                     "Measures the detector on logs with ground truth, by the paper's protocol");
  parser->add_option("LOG", options.logs, "Recordings with ground truth")->required();
  AddDetectorOptions(*parser, options.detector);
  parser->add_option("--json", options.json, "Write figures here, sequence by sequence too");
  parser->add_option("--plot", options.plot, "Draw miss rate against false positives (.svg, .png)");
  parser->add_option("--jobs", options.jobs, "Threads; the result does not depend on them")
      ->check(CLI::Range(1, 256));
  return RunTool(*parser, argc, argv, [&] { return Evaluate(options); });
}
