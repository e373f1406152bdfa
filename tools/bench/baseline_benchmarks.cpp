// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/baseline/ground_free_points.hpp"
#include "fallen/baseline/point_cloud_steps.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/iron/iron_descriptor.hpp"
#include "fallen/segmentation/dbscan.hpp"
#include "fallen/service/configuration.hpp"
#include "lap_times.hpp"
#include "tools/common/baseline_setup.hpp"

namespace fallen {
namespace {

// As the cell segmentation has them by default.
constexpr float kDbscanEpsilon_m = 0.1F;
constexpr int kDbscanMinPoints = 6;

// What the steps of both ways work on, made when the first benchmark asks for it.
struct StepInputs {
  std::vector<std::vector<NdtCell>> cells;
  std::vector<std::vector<Eigen::Vector3f>> means;    // of these cells
  std::vector<std::vector<Eigen::Vector3f>> thinned;  // the baseline's points, level frame
  std::vector<Eigen::Vector3f> cameras;               // in that frame
};

void MakeStepInputs(const BenchSequence& sequence, const Configuration& config,
                    StepInputs& inputs) {
  if (!inputs.cells.empty()) return;
  NdtConfig single = config.ndt;
  single.accumulate = false;
  NdtMapper mapper(single);
  const BaselineConfig baseline;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const NdtMap map = UpdateMap(mapper, sequence[i], config.ground);
    inputs.cells.push_back(map.cells);
    std::vector<Eigen::Vector3f>& means = inputs.means.emplace_back();
    for (const NdtCell& cell : map.cells) means.push_back(cell.mean);
    const GroundEstimate ground =
        EstimateGround(sequence[i].image, sequence[i].T_robot_camera, config.ground);
    inputs.thinned.emplace_back();
    inputs.cameras.emplace_back(0, 0, static_cast<float>(ground.plane.offset));
    if (ground.ok())
      inputs.thinned.back() =
          ThinPoints(GroundFreePoints(sequence[i].image, ground.plane, baseline), baseline.leaf_m);
  }
}

template <class Work>
void Measure(benchmark::State& state, std::size_t inputs, const Work& work) {
  LapTimes laps, items;
  std::size_t step = 0;
  for (auto _ : state) {
    laps.Start();
    const std::size_t count = work(step++ % inputs);
    laps.Stop();
    items.Add(static_cast<double>(count));
  }
  laps.Report(state);
  state.counters["items"] = items.Median();
}

}  // namespace

void RegisterBaselineBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                                const DetectorOptions& options) {
  const Configuration config = LoadConfiguration(options.config);
  const auto mounted = std::make_shared<BenchSequence>(WithMounting(*sequence, config.ground));
  const auto inputs = std::make_shared<StepInputs>();
  const auto add = [&](const char* name, const auto& run) {
    benchmark::RegisterBenchmark((std::string(name) + "/" + sequence->size_name()).c_str(),
                                 [=](benchmark::State& state) {
                                   run(state);
                                   state.SetLabel(sequence->source());
                                 })
        ->Unit(benchmark::kMillisecond);
  };
  const auto add_step = [&](const char* name, const auto& work) {
    add(name, [=](benchmark::State& state) {
      MakeStepInputs(*mounted, config, *inputs);
      Measure(state, inputs->cells.size(), [&](std::size_t i) { return work(*inputs, i); });
    });
  };
  add("Baseline", [=](benchmark::State& state) {
    try {
      const BaselineDetector baseline = MakeBaselineDetector("", options);
      Measure(state, mounted->size(),
              [&](std::size_t i) { return baseline.Detect((*mounted)[i]).hypotheses.size(); });
    } catch (const std::runtime_error& error) {
      state.SkipWithError(error.what());
    }
  });
  add_step("CellNormals", [](const StepInputs& in, std::size_t i) {
    return ComputeNormals(in.cells[i], IronConfig{}).size();
  });
  add_step("PclNormalEstimation", [](const StepInputs& in, std::size_t i) {
    return EstimateNormals(in.thinned[i], in.cameras[i], BaselineConfig{}.normal_radius_m).size();
  });
  add_step("Dbscan", [](const StepInputs& in, std::size_t i) {
    return Dbscan(in.means[i], kDbscanEpsilon_m, kDbscanMinPoints).size();
  });
  add_step("PclEuclideanClusters", [](const StepInputs& in, std::size_t i) {
    EuclideanClusters(in.means[i], kDbscanEpsilon_m, kDbscanMinPoints);
    return in.means[i].size();
  });
}

}  // namespace fallen
