// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench_sequence.hpp"
#include "benchmarks.hpp"
#include "tools/common/tool.hpp"

namespace {

// Google Benchmark reads its own options; anything else that we do not know is a wrong call.
// It keeps the pointer to `program`.
void InitializeBenchmark(char* program, const std::vector<std::string>& options) {
  std::vector<std::string> words;
  for (const std::string& option : options) {
    if (option.rfind("--benchmark_", 0) != 0)
      throw std::runtime_error("got " + option +
                               ", expected an option of --help or --benchmark_...");
    words.push_back(option);
  }
  std::vector<char*> pointers = {program};
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (count > 1)
    throw std::runtime_error("got " + words[1] + ", expected an option of Google Benchmark");
}

}  // namespace

int main(int argc, char** argv) {
  const auto parser = fallen::MakeToolParser(
      "fallen-bench",
      "Measures the detector and its stages beside what PCL offers, on the same frames. Options of "
      "Google Benchmark (--benchmark_filter=REGEX, --benchmark_out=FILE, ...) are passed on");
  std::filesystem::path recording = fallen::ShippedRecording();
  std::string camera;
  std::size_t max_frames = 60;
  fallen::DetectorOptions options;
  parser
      ->add_option(
          "--recording", recording,
          "Log or import directory whose frames are measured on; default: the shipped one. "
          "Where it has not the size, a ray-cast room is")
      ->capture_default_str();
  parser->add_option("--camera", camera, "Camera in the recording; default: the only one");
  parser->add_option("--frames", max_frames, "Frames to read from the recording")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  fallen::AddDetectorOptions(*parser, options);
  parser->allow_extras();

  return fallen::RunTool(*parser, argc, argv, [&] {
    InitializeBenchmark(argv[0], parser->remaining());
    std::shared_ptr<fallen::BenchSequence> first;
    for (fallen::BenchSequence& chosen : fallen::ChooseSequences(recording, camera, max_frames)) {
      const auto sequence = std::make_shared<fallen::BenchSequence>(std::move(chosen));
      if (!first) first = sequence;
      fallen::RegisterStageBenchmarks(sequence, options);
      fallen::RegisterPeerBenchmarks(sequence, options);
      fallen::RegisterPclBenchmarks(sequence);
      fallen::RegisterBaselineBenchmarks(sequence, options);
      fallen::RegisterTransportBenchmarks(sequence, options);
    }
    fallen::RegisterCostBenchmarks(first, options);
    fallen::RegisterEnvironmentBenchmarks(first);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
  });
}
