// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/segmentation/cell_features.hpp"
#include "fallen/segmentation/tree_scorer.hpp"
#include "lap_times.hpp"
#include "plain_iron.hpp"

namespace fallen {
namespace {

// Maps and features of a sequence's frames, made when the first benchmark asks for them.
struct Inputs {
  std::vector<NdtMap> maps;
  std::vector<FeatureMatrix> features;
  BoostedTrees trees;
};

void MakeMaps(BenchSequence& sequence, Inputs& inputs) {
  if (!inputs.maps.empty()) return;
  NdtMapper mapper;
  for (std::size_t step = 0; step < sequence.size(); ++step)
    inputs.maps.push_back(UpdateMap(mapper, sequence.At(step), GroundConfig{}));
}

void MakeFeatures(const Model& model, Inputs& inputs) {
  if (!inputs.features.empty()) return;
  inputs.trees = model.cells.trees;
  for (const NdtMap& map : inputs.maps) {
    const std::vector<CellNormal> normals = ComputeNormals(map.cells, model.cells.iron);
    const IronDescriptors descriptors =
        ComputeIronDescriptors(map.cells, normals, {}, model.cells.iron);
    std::vector<std::int32_t> described;
    for (std::size_t i = 0; i < map.cells.size(); ++i)
      if (descriptors.valid(i)) described.push_back(static_cast<std::int32_t>(i));
    inputs.features.push_back(
        ComputeCellFeatures(map, normals, descriptors, described, model.cells.features));
  }
}

// The definition: one row, one tree, one node after the other.
std::vector<float> WalkPlainly(const BoostedTrees& model, const FeatureMatrix& features,
                               double largest_sum) {
  std::vector<float> scores;
  for (Eigen::Index row = 0; row < features.rows(); ++row) {
    double sum = 0;
    for (std::int32_t at : model.roots) {
      while (model.nodes[at].feature >= 0) {
        const BoostedTrees::Node& node = model.nodes[at];
        at = node.left + (features(row, node.feature) <= node.threshold ? 0 : 1);
      }
      sum += model.nodes[at].value;
    }
    scores.push_back(static_cast<float>(sum / largest_sum));
  }
  return scores;
}

// Times `work(i)` on the inputs in turn.
template <class Work>
void Measure(benchmark::State& state, std::size_t inputs, const Work& work) {
  LapTimes laps;
  std::size_t step = 0;
  for (auto _ : state) {
    laps.Start();
    work(step++ % inputs);
    laps.Stop();
  }
  laps.Report(state);
}

}  // namespace

void RegisterPeerBenchmarks(const std::shared_ptr<BenchSequence>& sequence,
                            const DetectorOptions& options) {
  const auto inputs = std::make_shared<Inputs>();
  const auto add = [&](const char* name, const auto& run) {
    benchmark::RegisterBenchmark((std::string(name) + "/" + sequence->size_name()).c_str(),
                                 [=](benchmark::State& state) {
                                   MakeMaps(*sequence, *inputs);
                                   run(state);
                                   state.SetLabel(sequence->source());
                                 })
        ->Unit(benchmark::kMillisecond);
  };
  add("IronKdTree", [=](benchmark::State& state) {
    Measure(state, inputs->maps.size(), [&](std::size_t i) {
      benchmark::DoNotOptimize(DescribePlainly(inputs->maps[i].cells).neighbor_counts.data());
    });
  });
  const auto add_trees = [&](const char* name, const auto& run) {
    add(name, [=](benchmark::State& state) {
      try {
        MakeFeatures(LoadDetectorParts(options).model, *inputs);
      } catch (const std::exception& error) {
        return state.SkipWithError(error.what());
      }
      run(state);
    });
  };
  add_trees("BoostedTrees", [=](benchmark::State& state) {
    const TreeScorer scorer(inputs->trees);
    std::vector<float> scores;
    Measure(state, inputs->features.size(),
            [&](std::size_t i) { scorer.Score(inputs->features[i], scores); });
    state.counters["rows"] = static_cast<double>(scores.size());
  });
  add_trees("PlainTreeWalker", [=](benchmark::State& state) {
    Measure(state, inputs->features.size(), [&](std::size_t i) {
      benchmark::DoNotOptimize(WalkPlainly(inputs->trees, inputs->features[i], 1).data());
    });
  });
}

}  // namespace fallen
