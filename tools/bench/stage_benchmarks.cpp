// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/iron/iron_describer.hpp"
#include "fallen/service/configuration.hpp"
#include "lap_times.hpp"

namespace fallen {
namespace {

// An accumulating map grows while the robot drives: it is in its steady state after one way there
// and back. Not measured.
std::size_t WarmUpSteps(const BenchSequence& sequence) { return 2 * sequence.size(); }

std::optional<Eigen::Isometry3d> CameraPose(const Frame& frame) {
  if (!frame.T_world_robot || !frame.T_robot_camera) return std::nullopt;
  return *frame.T_world_robot * *frame.T_robot_camera;
}

void Register(const std::string& name, const BenchSequence& sequence,
              const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark((name + "/" + sequence.size_name()).c_str(),
                               [=, source = sequence.source()](benchmark::State& state) {
                                 run(state);
                                 state.SetLabel(source);
                               })
      ->Unit(benchmark::kMillisecond);
}

void RunDetect(benchmark::State& state, BenchSequence& sequence, Detector detector) {
  std::size_t step = 0;
  FrameResult result;
  while (step < WarmUpSteps(sequence)) detector.Detect(sequence.At(step++), result);
  LapTimes laps, ground, ndt, background, iron, cells, clusters, map_size;
  for (auto _ : state) {
    const Frame& frame = sequence.At(step++);
    laps.Start();
    detector.Detect(frame, result);
    laps.Stop();
    const StageTimes& times = result.milliseconds;
    ground.Add(times.ground);
    ndt.Add(times.ndt);
    background.Add(times.background);
    iron.Add(times.iron);
    cells.Add(times.cells);
    clusters.Add(times.clusters);
    map_size.Add(static_cast<double>(result.foreground.map.cells.size()));
  }
  laps.Report(state);
  state.counters["ground_ms"] = ground.Median();
  state.counters["ndt_ms"] = ndt.Median();
  state.counters["background_ms"] = background.Median();
  state.counters["iron_ms"] = iron.Median();
  state.counters["cells_ms"] = cells.Median();
  state.counters["clusters_ms"] = clusters.Median();
  state.counters["map_cells"] = map_size.Median();
}

// Mounting known, a fresh map every frame.
Detector SingleFrameDetector(const DetectorOptions& options) {
  DetectorParts parts = LoadDetectorParts(options);
  parts.config.ground.method = GroundMethod::kMounting;
  parts.config.ndt.accumulate = false;
  return Detector(std::move(parts.model), parts.config, std::move(parts.background));
}

// Mounting known, accumulating; what `first` shows is known background.
Detector AccumulatingDetector(const DetectorOptions& options, const Frame& first) {
  DetectorParts parts = LoadDetectorParts(options);
  parts.config.ground.method = GroundMethod::kMounting;
  parts.config.ndt.accumulate = true;
  NdtMapper mapper(parts.config.ndt);
  EnvironmentMap environment;
  environment.cell_size_m = parts.config.ndt.cell_size_m;
  environment.cells = UpdateMap(mapper, first, parts.config.ground).cells;
  return Detector(std::move(parts.model), parts.config,
                  BackgroundSubtractor(environment, parts.config.background));
}

void RunGround(benchmark::State& state, const BenchSequence& sequence, GroundConfig config,
               GroundMethod method) {
  config.method = method;
  LapTimes laps;
  std::size_t step = 0;
  int found = 0;
  for (auto _ : state) {
    const Frame& frame = sequence[sequence.IndexAt(step++)];
    laps.Start();
    const GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera, config);
    laps.Stop();
    found += ground.ok() ? 1 : 0;
  }
  laps.Report(state);
  state.counters["found"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}

void RunNdt(benchmark::State& state, BenchSequence& sequence, const GroundConfig& ground_config,
            const NdtConfig& config) {
  std::vector<GroundEstimate> ground;
  for (std::size_t i = 0; i < sequence.size(); ++i)
    ground.push_back(EstimateGround(sequence[i].image, sequence[i].T_robot_camera, ground_config));
  NdtMapper mapper(config);
  NdtMap map;
  const auto update = [&](std::size_t step) {
    const Frame& frame = sequence.At(step);
    mapper.Update(frame.utime, frame.image, CameraPose(frame), ground[sequence.IndexAt(step)], map);
  };
  std::size_t step = 0;
  while (step < WarmUpSteps(sequence)) update(step++);
  LapTimes laps, map_size;
  for (auto _ : state) {
    laps.Start();
    update(step++);
    laps.Stop();
    map_size.Add(static_cast<double>(map.cells.size()));
  }
  laps.Report(state);
  state.counters["map_cells"] = map_size.Median();
}

// Normals and descriptors of all cells, as without an environment map.
void RunIron(benchmark::State& state, BenchSequence& sequence, const GroundConfig& ground,
             const NdtConfig& config) {
  NdtMapper mapper(config);
  std::vector<std::vector<NdtCell>> maps;
  for (std::size_t step = 0; step < WarmUpSteps(sequence); ++step)
    maps.push_back(UpdateMap(mapper, sequence.At(step), ground).cells);
  maps.erase(maps.begin(), maps.end() - static_cast<std::ptrdiff_t>(sequence.size()));
  LapTimes laps, map_size;
  IronDescriber describer;
  std::vector<CellNormal> normals;
  std::size_t step = 0;
  for (auto _ : state) {
    const std::vector<NdtCell>& cells = maps[step++ % maps.size()];
    laps.Start();
    ComputeNormals(cells, describer.config(), normals);
    benchmark::DoNotOptimize(describer.Describe(cells, normals).neighbor_counts.data());
    laps.Stop();
    map_size.Add(static_cast<double>(cells.size()));
  }
  laps.Report(state);
  state.counters["map_cells"] = map_size.Median();
}

// Why there can be no detector, or "" if there can.
std::string WhyNoDetector(const DetectorOptions& options) {
  try {
    MakeDetector(options);
    return {};
  } catch (const std::exception& error) {
    if (options.config || !options.model.empty() || !options.environment_map.empty()) throw;
    return error.what();
  }
}

}  // namespace

void RegisterStageBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                             const DetectorOptions& options) {
  const std::string why_no_detector = WhyNoDetector(options);
  const Configuration config = LoadConfiguration(options.config);
  const auto mounted = std::make_shared<BenchSequence>(WithMounting(*sequence, config.ground));
  const auto register_detect = [&](const char* name, const std::shared_ptr<BenchSequence>& frames,
                                   const std::function<Detector()>& make_detector) {
    Register(name, *frames, [=](benchmark::State& state) {
      if (!why_no_detector.empty()) return state.SkipWithError(why_no_detector.c_str());
      RunDetect(state, *frames, make_detector());
    });
  };
  register_detect("Detect", mounted, [=] { return SingleFrameDetector(options); });
  register_detect("DetectAccumulating", mounted,
                  [=] { return AccumulatingDetector(options, (*mounted)[0]); });
  register_detect("DetectAsConfigured", sequence, [=] { return MakeDetector(options); });
  const auto register_ground = [&](const char* name, GroundMethod method) {
    Register(name, *sequence, [=, ground = config.ground](benchmark::State& state) {
      RunGround(state, *sequence, ground, method);
    });
  };
  register_ground("GroundAuto", GroundMethod::kAuto);
  register_ground("GroundMounting", GroundMethod::kMounting);
  register_ground("GroundRansac", GroundMethod::kRansac);
  register_ground("GroundVDisparity", GroundMethod::kVDisparity);
  Register("Ndt", *sequence,
           [=, ground = config.ground, ndt = config.ndt](benchmark::State& state) {
             RunNdt(state, *sequence, ground, ndt);
           });
  Register("Iron", *sequence,
           [=, ground = config.ground, ndt = config.ndt](benchmark::State& state) {
             RunIron(state, *sequence, ground, ndt);
           });
}

}  // namespace fallen
