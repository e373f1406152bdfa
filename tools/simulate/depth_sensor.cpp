// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/depth_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tools/simulate/random.hpp"

namespace fallen::sim {
namespace {

// Correlation windows overlap from pixel to pixel, so errors and losses are alike within some
// pixels: they are drawn on a lattice of this spacing at 640 x 480 and interpolated. In real
// recordings less than 1 % of the missing pixels stand alone.
constexpr double kLatticeAt640 = 5;  // [px]
// Of the axial noise, what is alike within a window and what is every pixel's own; squares add up
// to 1.
constexpr double kSharedNoise = 0.9, kOwnNoise = 0.436;

// Signal: albedo * cosine of incidence / depth^2. Below kWeakSignal a pixel is as likely lost as
// not; chosen such that of a matt floor (0.45), 1 m below the camera, some 5 % are lost at 4.5 m,
// as in real recordings of a Kinect.
constexpr double kWeakSignal = 0.0018;
constexpr double kSignalSpread = 0.35;  // of the logarithm, over which losses set in
// Depth steps larger than this share of the depth are edges, where a window sees two depths.
constexpr double kEdgeStep = 0.03;
constexpr double kEdgeLoss = 0.35;

// Cheap, near enough to normal: the sum of four uniform numbers of 16 bits, scaled to unit
// variance.
double NormalFromBits(std::uint64_t bits) {
  constexpr double kScale = std::numbers::sqrt3 / 65536.0;  // variance of one is 65536^2 / 12
  const auto sum = static_cast<double>((bits & 0xffff) + ((bits >> 16) & 0xffff) +
                                       ((bits >> 32) & 0xffff) + (bits >> 48));
  return (sum - 2 * 65535.0) * kScale;
}

// Noise of mean 0 and variance 1 that changes over the lattice's spacing.
class SmoothField {
 public:
  SmoothField(std::uint64_t seed, int width, int height, double spacing)
      : inverse_spacing_(1 / spacing), columns_(static_cast<int>(width / spacing) + 2) {
    const int rows = static_cast<int>(height / spacing) + 2;
    for (int i = 0; i < rows * columns_; ++i)
      nodes_.push_back(static_cast<float>(
          NormalFromBits(MixBits(MixBits(seed) + static_cast<std::uint64_t>(i)))));
  }

  double At(int u, int v) const {
    // Bilinear weights leave 4/9 of the variance on average.
    constexpr double kRestoreVariance = 1.5;
    const double x = u * inverse_spacing_, y = v * inverse_spacing_;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const double s = x - column, t = y - row;
    const float* node = &nodes_[static_cast<std::size_t>(row * columns_ + column)];
    return kRestoreVariance * ((1 - t) * ((1 - s) * node[0] + s * node[1]) +
                               t * ((1 - s) * node[columns_] + s * node[columns_ + 1]));
  }

 private:
  double inverse_spacing_;
  int columns_;
  std::vector<float> nodes_;
};

// Share of a normal distribution below `value`.
double NormalShareBelow(double value) { return 0.5 * std::erfc(-value / std::numbers::sqrt2); }

bool AtEdge(const IdealView& view, int width, int height, int u, int v) {
  const float depth = view.depth_m[static_cast<std::size_t>(v * width + u)];
  const auto step = static_cast<float>(kEdgeStep) * depth;
  const auto differs = [&](int du, int dv) {
    const int x = u + du, y = v + dv;
    if (x < 0 || y < 0 || x >= width || y >= height) return false;
    return std::abs(view.depth_m[static_cast<std::size_t>(y * width + x)] - depth) > step;
  };
  return differs(-1, 0) || differs(1, 0) || differs(0, -1) || differs(0, 1);
}

double LossProbability(double depth_m, double cosine, double albedo) {
  const double signal = albedo * cosine / (depth_m * depth_m);
  if (signal <= 0) return 1;
  const auto ratio = static_cast<float>(signal / kWeakSignal);
  return 1 / (1 + std::exp(std::log(ratio) / static_cast<float>(kSignalSpread)));
}

}  // namespace

CameraIntrinsics SensorIntrinsics(int width) {
  if (width == 640) return {640, 480, 575, 575, 319.5, 239.5};
  if (width == 320) return {320, 240, 287.5, 287.5, 159.5, 119.5};
  throw std::invalid_argument("sensor: width: got " + std::to_string(width) +
                              ", expected 320 or 640");
}

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
  const double spacing = kLatticeAt640 * width / 640;
  const auto field = [&](std::uint64_t kind) {
    return SmoothField(MixBits(seed + kind), width, height, spacing);
  };
  const SmoothField noise_u = field(1), noise_v = field(2), noise_z = field(3), loss = field(4);
  std::vector<float> jitter;
  if (config.noise) {
    const double sigma = config.lateral_noise_px * width / 640;
    jitter.reserve(2 * static_cast<std::size_t>(width * height));
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        jitter.push_back(static_cast<float>(sigma * noise_u.At(u, v)));
        jitter.push_back(static_cast<float>(sigma * noise_v.At(u, v)));
      }
    }
  }
  // Seen from the camera, the projector is to its right: shadows fall to the left of things.
  const IdealView view =
      caster.Render(intrinsics, T_world_camera, jitter, {config.baseline_m, 0, 0});
  SensorImage image;
  image.depth.intrinsics = intrinsics;
  image.depth.depth_unit_m = 0.001;
  image.depth.depth.assign(view.depth_m.size(), 0);
  image.labels = view.label;
  constexpr double kNegligibleLoss = 0.002;  // no lattice node is that unlikely
  const std::uint64_t own_seed = MixBits(seed + 5);
  const double focal_times_baseline = config.correlation_focal_px * config.baseline_m;
  for (int v = 0, i = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u, ++i) {
      const auto pixel = static_cast<std::size_t>(i);
      double depth = view.depth_m[pixel];
      if (depth <= 0) continue;
      if (config.noise) {
        if (view.lit[pixel] == 0) continue;
        double lost = LossProbability(depth, view.cosine[pixel], view.albedo[pixel] / 255.0);
        if (AtEdge(view, width, height, u, v)) lost += kEdgeLoss * (1 - lost);
        if (lost > kNegligibleLoss && NormalShareBelow(loss.At(u, v)) < lost) continue;
        const double incidence = std::acos(std::min(1.0f, view.cosine[pixel]));
        const double sigma = config.axial_noise_scale * AxialSigma(depth, incidence);
        const double own = NormalFromBits(MixBits(own_seed + static_cast<std::uint64_t>(i)));
        const double error = sigma * (kSharedNoise * noise_z.At(u, v) + kOwnNoise * own);
        double disparity = focal_times_baseline / (depth + error);
        disparity = std::round(disparity / config.disparity_step_px) * config.disparity_step_px;
        if (disparity <= 0) continue;
        depth = focal_times_baseline / disparity;
      }
      if (depth < config.min_range_m || depth > config.max_range_m) continue;
      image.depth.depth[pixel] = static_cast<std::uint16_t>(std::lround(depth * 1000));
    }
  }
  return image;
}

}  // namespace fallen::sim
