// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long the chain of services takes from depth image to decision: 640 x 480 at 30 Hz from the
// virtual camera. Measured by hand: cmake --build build/release --target chain-figures
//   FALLEN_RECORDING  log or import directory whose 640 x 480 images the camera shows, over and
//                     over; else those of a ray-cast room
//   FALLEN_SECONDS    how long to measure; default 60
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "tests/integration/arrival_times.hpp"
#include "tests/integration/figure_inputs.hpp"
#include "tests/integration/service_chain.hpp"
#include "tests/services/depth_capture/virtual_camera_control.hpp"

namespace fallen::testing_support {
namespace {

using std::chrono::milliseconds;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr std::size_t kFilmFrames = 90;
constexpr double kCameraUnit_m = 1e-3;
// Before the measurement: services that have just started touch their memory for the first time.
constexpr milliseconds kWarmUp{3000};
constexpr milliseconds kLastStatus{1500};
// The aims.
constexpr double kMaxTransport_ms = 3;
constexpr double kMaxTail_ms = 33;

const std::string kDepth = "DEPTH_CAMERA";
const std::string kPersons = "FALLEN_PERSONS_CAMERA";

/// The frames that the virtual camera shows, in its unit.
std::filesystem::path WriteFilm(const std::filesystem::path& file) {
  const BenchSequence sequence = LargeImages(kFilmFrames);
  std::printf("%zu images of %s\n", sequence.size(), sequence.source().c_str());
  std::ofstream raw(file, std::ios::binary);
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const DepthImage& image = sequence[i].image;
    for (const std::uint16_t depth : image.depth) {
      const auto value =
          static_cast<std::uint16_t>(std::lround(depth * image.depth_unit_m / kCameraUnit_m));
      raw.write(reinterpret_cast<const char*>(&value), sizeof value);
    }
  }
  return file;
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Median and 99 % of the time between two messages about the same frame; `from` empty: since the
/// camera gave the frame.
struct Delay {
  Delay(const ArrivalTimes& times, const std::string& from, const std::string& to) {
    std::vector<double> delays;
    for (const auto& [seq, frame] : times.frames()) {
      const auto end = frame.arrivals.find(to);
      const auto begin = frame.arrivals.find(from);
      if (end == frame.arrivals.end() || (!from.empty() && begin == frame.arrivals.end())) continue;
      const std::int64_t since = from.empty() ? frame.utime : begin->second;
      delays.push_back(1e-3 * static_cast<double>(end->second - since));
    }
    median_ms = Quantile(delays, 0.5);
    p99_ms = Quantile(delays, 0.99);
    largest_ms = Quantile(delays, 1);
  }
  double median_ms = 0;
  double p99_ms = 0;
  double largest_ms = 0;
};

void Print(const std::string& what, const Delay& delay) {
  std::printf("%-52s median %6.2f ms, p99 %6.2f ms, at most %6.2f ms\n", what.c_str(),
              delay.median_ms, delay.p99_ms, delay.largest_ms);
}

TEST(ChainFigures, FiveProcessesDecideAboutEachFrameOf30Hz) {
  const test::VirtualCameraControl camera;
  const TemporaryFolder folder;
  const std::filesystem::path film = WriteFilm(folder / "film.raw");
  setenv(virtual_camera::kFramesVariable, film.c_str(), 1);
  const int seconds = std::stoi(Environment("FALLEN_SECONDS", "60"));

  ServiceChain chain(FALLEN_SOURCE_DIR "/models/fallen.model", Environment("FALLEN_CONFIG", ""),
                     ServiceChain::Pace::kLive);
  ArrivalTimes times(chain.recorder().lcm(),
                     "(DEPTH|NDT_MAP|FOREGROUND|CLUSTERS|FALLEN_PERSONS)_CAMERA");
  chain.StartAll();
  ChildProcess capture(
      {"env", "LD_LIBRARY_PATH=" FALLEN_OPENNI2_DIR, Program("fallen-depth-capture"), "--width",
       std::to_string(kWidth), "--height", std::to_string(kHeight), "--lcm-url", chain.url()},
      folder.path());
  chain.recorder().HandleFor(kWarmUp);
  times.Clear();
  chain.recorder().HandleFor(std::chrono::seconds(seconds));
  EXPECT_EQ(capture.Stop(), 0) << capture.StandardError();
  chain.recorder().HandleFor(kLastStatus);

  double compute_ms = 0;
  for (const std::string service : {"depth-capture", "ndt-mapping", "background-subtraction",
                                    "cell-segmentation", "cluster-classification"}) {
    const service_status_t status = chain.recorder().Status(service);
    compute_ms += status.median_ms;
    std::printf(
        "%-24s received %5lld published %5lld late %lld lost %lld  median %5.2f p99 %5.2f ms  "
        "%3.0f "
        "MB resident\n",
        service.c_str(), static_cast<long long>(status.received),
        static_cast<long long>(status.published), static_cast<long long>(status.dropped_late),
        static_cast<long long>(status.lost_upstream), status.median_ms, status.p99_ms,
        static_cast<double>(status.resident_bytes) / (1 << 20));
    EXPECT_EQ(status.dropped_late, 0) << service;
    EXPECT_EQ(status.lost_upstream, 0) << service;
    EXPECT_EQ(status.dropped_damaged, 0) << service;
  }
  std::string before = kDepth;
  for (const Stage& stage : kStages) {
    Print("  " + before + " to " + stage.output, Delay(times, before, stage.output));
    before = stage.output;
  }
  Print("depth image on the wire to decision", Delay(times, kDepth, kPersons));
  const Delay latency(times, "", kPersons);
  Print("frame in the camera's hands to decision", latency);

  std::int64_t undecided = 0;
  for (const auto& [seq, frame] : times.frames()) undecided += !frame.arrivals.contains(kPersons);
  std::printf(
      "frames %zu in %d s, without a decision %lld; compute %.2f ms, latency %.2f ms more\n",
      times.frames().size(), seconds, static_cast<long long>(undecided), compute_ms,
      latency.median_ms - compute_ms);
  EXPECT_GE(times.frames().size(), static_cast<std::size_t>(29 * seconds));
  EXPECT_EQ(undecided, 0);
  EXPECT_LE(latency.median_ms, compute_ms + kMaxTransport_ms);
  EXPECT_LE(latency.p99_ms, kMaxTail_ms);
  chain.StopAll();
}

}  // namespace
}  // namespace fallen::testing_support
