// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/depth_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/simulate/noise_field.hpp"
#include "tools/simulate/pixel_neighbours.hpp"
#include "tools/simulate/time_of_flight.hpp"

namespace fallen::sim {
namespace {

// Of the axial noise, what is alike within a window and what is every pixel's own; squares add up
// to 1.
constexpr double kSharedNoise = 0.9, kOwnNoise = 0.436;
constexpr double kSignalSpread = 0.35;  // of the signal's logarithm, over which losses set in

double LossProbability(double signal, double weak_signal) {
  if (signal <= 0) return 1;
  const auto ratio = static_cast<float>(signal / weak_signal);
  return 1 / (1 + std::exp(std::log(ratio) / static_cast<float>(kSignalSpread)));
}

// Which pixels have no depth for another reason than the range.
class Losses {
 public:
  Losses(const IdealView& view, int width, int height, const SensorConfig& config,
         std::uint64_t seed)
      : view_(view),
        config_(config),
        width_(width),
        height_(height),
        loss_(MixBits(seed + 4), width, height, config.window_px * width / 640),
        blobs_(MixBits(seed + 6), width, height, 4 * config.window_px * width / 640),
        device_blobs_(MixBits(config.device_seed + 7), width, height, 24.0 * width / 640) {
    const double scale = width / 640.0;
    first_u_ = static_cast<int>(config.border_px[0] * scale);
    first_v_ = static_cast<int>(config.border_px[1] * scale);
    last_u_ = width - static_cast<int>(config.border_px[2] * scale);
    last_v_ = height - static_cast<int>(config.border_px[3] * scale);
  }

  bool At(int u, int v) const {
    if (u < first_u_ || v < first_v_ || u >= last_u_ || v >= last_v_) return true;
    constexpr double kNegligible = 0.002;  // no lattice node is that unlikely
    const auto pixel = static_cast<std::size_t>(v * width_ + u);
    if (view_.lit[pixel] == 0) return true;
    const double depth = view_.depth_m[pixel];
    const double signal = view_.albedo[pixel] / 255.0 * view_.cosine[pixel] / (depth * depth);
    double lost = LossProbability(signal, config_.weak_signal);
    if (AtEdge(view_, width_, height_, u, v)) lost += config_.edge_loss * (1 - lost);
    if (lost > kNegligible && NormalShareBelow(loss_.At(u, v)) < lost) return true;
    if (config_.blob_loss <= 0) return false;
    // Half of the blobs stay where they are in the picture, half come and go.
    const double blob = (blobs_.At(u, v) + device_blobs_.At(u, v)) / std::numbers::sqrt2;
    return NormalShareBelow(blob) < config_.blob_loss;
  }

 private:
  const IdealView& view_;
  const SensorConfig& config_;
  int width_, height_;
  NoiseField loss_, blobs_, device_blobs_;
  int first_u_, first_v_, last_u_, last_v_;
};

// Structured light: noise on depth, then steps of disparity.
class Disparity {
 public:
  Disparity(const IdealView& view, int width, int height, const SensorConfig& config,
            std::uint64_t seed)
      : view_(view),
        config_(config),
        width_(width),
        shared_(MixBits(seed + 3), width, height, config.window_px * width / 640),
        own_seed_(MixBits(seed + 5)),
        focal_times_baseline_(config.correlation_focal_px * std::abs(config.baseline_m)) {}

  double Measure(int u, int v, double depth) const {
    const auto pixel = static_cast<std::size_t>(v * width_ + u);
    const double incidence = std::acos(std::min(1.0f, view_.cosine[pixel]));
    const double sigma = config_.axial_noise_scale * AxialSigma(depth, incidence);
    const double own = NormalFromBits(MixBits(own_seed_ + pixel));
    const double error = sigma * (kSharedNoise * shared_.At(u, v) + kOwnNoise * own);
    const double exact = focal_times_baseline_ / (depth + error);
    const double disparity =
        std::round(exact / config_.disparity_step_px) * config_.disparity_step_px;
    return disparity <= 0 ? -1 : focal_times_baseline_ / disparity;
  }

 private:
  const IdealView& view_;
  const SensorConfig& config_;
  int width_;
  NoiseField shared_;
  std::uint64_t own_seed_;
  double focal_times_baseline_;
};

// Two values a pixel: by how much its ray goes astray.
std::vector<float> LateralNoise(const SensorConfig& config, int width, int height,
                                std::uint64_t seed) {
  if (!config.noise || config.kind != SensorKind::kStructuredLight) return {};
  const double scale = width / 640.0;
  const NoiseField noise_u(MixBits(seed + 1), width, height, config.window_px * scale);
  const NoiseField noise_v(MixBits(seed + 2), width, height, config.window_px * scale);
  std::vector<float> jitter;
  jitter.reserve(2 * static_cast<std::size_t>(width * height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      jitter.push_back(static_cast<float>(config.lateral_noise_px * scale * noise_u.At(u, v)));
      jitter.push_back(static_cast<float>(config.lateral_noise_px * scale * noise_v.At(u, v)));
    }
  }
  return jitter;
}

template <class Measure>
void FillDepth(const SensorConfig& config, const Measure& measure, DepthImage& image) {
  const CameraIntrinsics& k = image.intrinsics;
  for (int v = 0, pixel = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u, ++pixel) {
      const double depth = measure(u, v, static_cast<std::size_t>(pixel));
      if (depth < config.min_range_m || depth > config.max_range_m) continue;
      image.depth[static_cast<std::size_t>(pixel)] =
          static_cast<std::uint16_t>(std::lround(depth * 1000));
    }
  }
}

}  // namespace

double AxialSigma(double depth_m, double incidence_rad) {
  const double beyond = depth_m - 0.4;
  const double grazing = std::numbers::pi / 2 - std::min(incidence_rad, 1.5);
  return 0.0012 + 0.0019 * beyond * beyond +
         0.0001 / std::sqrt(depth_m) * incidence_rad * incidence_rad / (grazing * grazing);
}

SensorImage TakePicture(const RayCaster& caster, const CameraIntrinsics& intrinsics,
                        const Eigen::Isometry3d& T_world_camera, const SensorConfig& config,
                        std::uint64_t seed) {
  const int width = intrinsics.width, height = intrinsics.height;
  // Seen from the camera, the projector is to its right: shadows fall to the left of things.
  const IdealView view =
      caster.Render(intrinsics, T_world_camera, LateralNoise(config, width, height, seed),
                    {config.baseline_m, 0, 0});
  SensorImage image;
  image.depth.intrinsics = intrinsics;
  image.depth.depth_unit_m = 0.001;
  image.depth.depth.assign(view.depth_m.size(), 0);
  image.labels = view.label;
  if (!config.noise) {
    FillDepth(
        config, [&](int, int, std::size_t pixel) { return view.depth_m[pixel]; }, image.depth);
    return image;
  }
  const Losses losses(view, width, height, config, seed);
  const NoiseField warp(MixBits(config.device_seed + 8), width, height, 110.0 * width / 640);
  const auto fill = [&](const auto& sensor) {
    FillDepth(
        config,
        [&](int u, int v, std::size_t pixel) {
          const double depth = view.depth_m[pixel];
          if (depth <= 0 || losses.At(u, v)) return -1.0;
          const double warped =
              config.depth_scale * depth + config.depth_warp_m * depth * depth * warp.At(u, v);
          return sensor.Measure(u, v, warped);
        },
        image.depth);
  };
  if (config.kind == SensorKind::kStructuredLight)
    fill(Disparity(view, width, height, config, seed));
  else
    fill(TimeOfFlight(view, intrinsics, config, seed));
  return image;
}

}  // namespace fallen::sim
