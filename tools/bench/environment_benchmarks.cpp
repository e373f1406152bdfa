// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <flann/flann.hpp>
#include <memory>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "benchmarks.hpp"
#include "fallen/detection/map_update.hpp"
#include "fallen/messages/model_files.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "lap_times.hpp"

namespace fallen {
namespace {

constexpr int kSmallestMap = 1000;
constexpr int kLargestMap = 1000000;
constexpr int kMapSteps = 10;
// Copies of a room stand this far apart: no cell of one is near another.
constexpr float kRoomPitch_m = 14;

// Maps of a sequence's first and last frame, world frame.
struct FrameMaps {
  NdtMap known;  // cells in random order
  NdtMap local;

  explicit FrameMaps(const BenchSequence& sequence) {
    const BenchSequence mounted = WithMounting(sequence, {});
    NdtConfig single;
    single.accumulate = false;
    NdtMapper mapper(single);
    known = UpdateMap(mapper, mounted[0], {});
    local = UpdateMap(mapper, mounted[mounted.size() - 1], {});
    std::mt19937 random(1);
    std::shuffle(known.cells.begin(), known.cells.end(), random);
  }
};

// `count` cells: those of `room`, or some of them from all over it, then room after room on a grid.
// A millimetre of noise, so that no file packs a room as a copy of another.
EnvironmentMap Rooms(const NdtMap& room, int count) {
  EnvironmentMap environment;
  environment.cell_size_m = room.cell_size_m;
  const auto side = static_cast<int>(
      std::ceil(std::sqrt(static_cast<double>(count) / static_cast<double>(room.cells.size()))));
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0, 1e-3F);
  for (int i = 0; i < count; ++i) {
    const auto copy = static_cast<int>(i / static_cast<std::int64_t>(room.cells.size()));
    NdtCell cell = room.cells[static_cast<std::size_t>(i) % room.cells.size()];
    cell.mean += kRoomPitch_m * Eigen::Vector3i(copy % side, copy / side, 0).cast<float>();
    for (float& coordinate : cell.mean) coordinate += noise(random);
    environment.cells.push_back(cell);
  }
  return environment;
}

// A file, gone with this object.
class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() /
              ("fallen-bench-" + std::to_string(getpid()) + ".map")) {}
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

void RunMapSearch(benchmark::State& state, const FrameMaps& maps) {
  if (maps.local.frame != MapFrame::kWorld) return state.SkipWithError("the frame shows no floor");
  const BackgroundSubtractor subtractor(Rooms(maps.known, static_cast<int>(state.range(0))));
  LapTimes laps;
  for (auto _ : state) {
    NdtMap map = maps.local;
    laps.Start();
    benchmark::DoNotOptimize(subtractor.Subtract(std::move(map)).is_foreground.data());
    laps.Stop();
  }
  laps.Report(state);
  state.counters["map_cells"] = static_cast<double>(maps.local.cells.size());
}

// The nearest environment cell of each local cell by FLANN's k-d tree: the search alone.
void RunFlannSearch(benchmark::State& state, const FrameMaps& maps) {
  const EnvironmentMap environment = Rooms(maps.known, static_cast<int>(state.range(0)));
  std::vector<float> known, sought;
  for (const NdtCell& cell : environment.cells)
    known.insert(known.end(), cell.mean.begin(), cell.mean.end());
  for (const NdtCell& cell : maps.local.cells)
    sought.insert(sought.end(), cell.mean.begin(), cell.mean.end());
  flann::KDTreeSingleIndex<flann::L2_Simple<float>> tree(
      flann::Matrix<float>(known.data(), environment.cells.size(), 3));
  tree.buildIndex();
  std::vector<int> indices(maps.local.cells.size());
  std::vector<float> sq_distances(maps.local.cells.size());
  flann::Matrix<int> index_rows(indices.data(), indices.size(), 1);
  flann::Matrix<float> distance_rows(sq_distances.data(), sq_distances.size(), 1);
  LapTimes laps;
  for (auto _ : state) {
    laps.Start();
    tree.knnSearch(flann::Matrix<float>(sought.data(), maps.local.cells.size(), 3), index_rows,
                   distance_rows, 1, flann::SearchParams(-1));
    laps.Stop();
  }
  laps.Report(state);
  state.counters["map_cells"] = static_cast<double>(maps.local.cells.size());
}

void RunMapLoad(benchmark::State& state, const FrameMaps& maps) {
  const TemporaryFile file;
  SaveEnvironmentMap(file.path(), Rooms(maps.known, static_cast<int>(state.range(0))), "bench");
  LapTimes laps;
  for (auto _ : state) {
    laps.Start();
    const BackgroundSubtractor subtractor(LoadEnvironmentMap(file.path()));
    laps.Stop();
    benchmark::DoNotOptimize(subtractor.has_environment());
  }
  laps.Report(state);
  state.counters["megabytes"] = 1e-6 * static_cast<double>(std::filesystem::file_size(file.path()));
}

}  // namespace

void RegisterEnvironmentBenchmarks(const std::shared_ptr<BenchSequence>& sequence) {
  const auto maps = std::make_shared<std::unique_ptr<FrameMaps>>();
  const auto add = [&](const char* name, void (*run)(benchmark::State&, const FrameMaps&)) {
    benchmark::RegisterBenchmark(name,
                                 [=](benchmark::State& state) {
                                   if (!*maps) *maps = std::make_unique<FrameMaps>(*sequence);
                                   run(state, **maps);
                                   state.SetLabel(sequence->source());
                                 })
        ->RangeMultiplier(kMapSteps)
        ->Range(kSmallestMap, kLargestMap)
        ->Unit(benchmark::kMillisecond);
  };
  add("MapSearch", RunMapSearch);
  add("FlannMapSearch", RunFlannSearch);
  add("MapLoad", RunMapLoad);
}

}  // namespace fallen
