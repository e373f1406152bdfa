// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/segmentation/cell_segmenter.hpp"
#include "lap_times.hpp"

namespace fallen {
namespace {

// The local map after all frames, its cells sorted by their distance from the middle one: the first
// n of them are a map of n cells that is as dense as the whole.
NdtMap AccumulatedMap(BenchSequence sequence) {
  NdtMapper mapper;
  NdtMap map;
  for (std::size_t step = 0; step < sequence.size(); ++step)
    map = UpdateMap(mapper, sequence.At(step), GroundConfig{});
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  for (const NdtCell& cell : map.cells) middle += cell.mean / static_cast<float>(map.cells.size());
  std::sort(map.cells.begin(), map.cells.end(), [&](const NdtCell& a, const NdtCell& b) {
    return (a.mean - middle).squaredNorm() < (b.mean - middle).squaredNorm();
  });
  return map;
}

// Pairs of cells that a descriptor compares: within its radius, each counted once.
double CountPairs(const std::vector<NdtCell>& cells, double radius_m) {
  const auto sq_radius = static_cast<float>(radius_m * radius_m);
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((cells[i].mean - cells[j].mean).squaredNorm() <= sq_radius) ++pairs;
  return static_cast<double>(pairs);
}

// All stages after the mapping, on a map of so many cells.
void RunCells(benchmark::State& state, const NdtMap& whole, const DetectorParts& parts) {
  const auto count = static_cast<std::size_t>(state.range(0));
  if (whole.cells.size() < count) return state.SkipWithError("the map has not so many cells");
  ForegroundMap foreground;
  foreground.map = whole;
  foreground.map.cells.resize(count);
  foreground.is_foreground.assign(count, 1);
  CellSegmenter segmenter(parts.model.cells, parts.config.segmentation);
  ClusterClassifier classifier(parts.model.clusters);
  SegmentedMap segmented;
  Decision decision;
  LapTimes laps;
  for (auto _ : state) {
    laps.Start();
    segmenter.Segment(foreground, segmented);
    classifier.Classify(segmented, parts.config.classification, decision);
    benchmark::DoNotOptimize(decision.hypotheses.data());
    laps.Stop();
  }
  laps.Report(state);
  const double pairs = CountPairs(foreground.map.cells, parts.model.cells.iron.radius_m);
  state.counters["pairs"] = pairs;
  state.counters["ns_per_pair"] = 1e6 * laps.Median() / pairs;
}

}  // namespace

void RegisterCostBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                            const DetectorOptions& options) {
  const auto map = std::make_shared<NdtMap>();
  benchmark::RegisterBenchmark("CellsToDecision",
                               [=](benchmark::State& state) {
                                 std::optional<DetectorParts> parts;
                                 try {
                                   parts = LoadDetectorParts(options);
                                 } catch (const std::exception& error) {
                                   return state.SkipWithError(error.what());
                                 }
                                 if (map->cells.empty())
                                   *map = AccumulatedMap(WithMounting(*sequence, {}));
                                 RunCells(state, *map, *parts);
                                 state.SetLabel(sequence->source());
                               })
      ->Arg(500)
      ->Arg(1000)
      ->Arg(2000)
      ->Arg(4000)
      ->Arg(8000)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace fallen
