// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/time_of_flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/simulate/pixel_neighbours.hpp"

namespace fallen::sim {
namespace {

constexpr double kWindowPx = 3;  // over which the camera's own filter makes noise alike
constexpr double kReachPx = 26;  // from which a corner collects light, at a width of 640
constexpr double kSharedNoise = 0.6, kOwnNoise = 0.8;  // squares add up to 1

// A number in [0, 1) of its own for every pixel.
double UniformAt(std::uint64_t seed, std::size_t pixel) {
  return static_cast<double>(MixBits(seed + pixel) >> 11) * 0x1p-53;
}

}  // namespace

double TimeOfFlightSigma(double signal) {
  // Some 2 mm of a white wall at 1 m, 2 cm where next to nothing comes back.
  constexpr double kFloor = 0.0008, kShot = 0.0011, kMost = 0.06;
  return std::min(kMost, kFloor + kShot / std::sqrt(std::max(signal, 1e-6)));
}

TimeOfFlight::TimeOfFlight(const IdealView& view, const CameraIntrinsics& intrinsics,
                           const SensorConfig& config, std::uint64_t seed)
    : view_(view),
      intrinsics_(intrinsics),
      config_(config),
      own_seed_(MixBits(seed + 11)),
      flying_seed_(MixBits(seed + 12)),
      shared_(MixBits(seed + 13), intrinsics.width, intrinsics.height,
              kWindowPx * intrinsics.width / 640) {
  const int width = intrinsics.width, height = intrinsics.height;
  const auto size = static_cast<std::size_t>((width + 1) * (height + 1));
  inverse_sums_.assign(size, 0);
  count_sums_.assign(size, 0);
  for (int v = 0; v < height; ++v) {
    double inverse = 0;
    int count = 0;
    for (int u = 0; u < width; ++u) {
      const float depth = view.depth_m[static_cast<std::size_t>(v * width + u)];
      if (depth > 0) {
        inverse += 1 / static_cast<double>(depth);
        ++count;
      }
      const auto above = static_cast<std::size_t>(v * (width + 1) + u + 1);
      const std::size_t below = above + static_cast<std::size_t>(width + 1);
      inverse_sums_[below] = inverse_sums_[above] + inverse;
      count_sums_[below] = count_sums_[above] + count;
    }
  }
}

double TimeOfFlight::MultipathBias(int u, int v, double depth) const {
  // The inverse depth of a plane is affine in the picture: its mean over a window is its middle's.
  const int width = intrinsics_.width, height = intrinsics_.height;
  const int reach = std::max(2, static_cast<int>(kReachPx * width / 640));
  if (u < reach || v < reach || u + reach >= width || v + reach >= height) return 0;
  const auto sum = [&](const auto& sums) {
    const auto at = [&](int x, int y) {
      return sums[static_cast<std::size_t>(y * (width + 1) + x)];
    };
    return at(u + reach + 1, v + reach + 1) - at(u - reach, v + reach + 1) -
           at(u + reach + 1, v - reach) + at(u - reach, v - reach);
  };
  const int count = sum(count_sums_);
  if (count == 0) return 0;
  constexpr double kMost = 0.06;  // [m]
  const double around = count / sum(inverse_sums_);
  return std::clamp(config_.multipath * (depth - around), 0.0, kMost);
}

double TimeOfFlight::Measure(int u, int v, double depth) const {
  const int width = intrinsics_.width, height = intrinsics_.height;
  const auto pixel = static_cast<std::size_t>(v * width + u);
  const double albedo = view_.albedo[pixel] / 255.0;
  // The light thins out towards the corners.
  const double x = (u - intrinsics_.cx) / intrinsics_.fx, y = (v - intrinsics_.cy) / intrinsics_.fy;
  const double vignette = 1 / ((1 + x * x + y * y) * (1 + x * x + y * y));
  const double signal = albedo * view_.cosine[pixel] * vignette / (depth * depth);
  const double noise =
      kSharedNoise * shared_.At(u, v) + kOwnNoise * NormalFromBits(MixBits(own_seed_ + pixel));
  double measured = depth + config_.axial_noise_scale * TimeOfFlightSigma(signal) * noise;
  constexpr double kWavelength = 1.5;  // [m], of the errors that harmonics leave
  measured += config_.wiggle_m * std::sin(2 * std::numbers::pi * depth / kWavelength);
  measured += config_.intensity_bias_m * (0.5 - albedo);
  const double across = DepthAcrossEdge(view_, width, height, u, v);
  if (across != view_.depth_m[pixel] && across > 0) {
    // A pixel that sees both sides reports something between them, nearer to what fills it more.
    const double draw = UniformAt(flying_seed_, pixel);
    if (draw < config_.flying_share)
      measured += 0.5 * draw / config_.flying_share * (across - depth);
    return measured;
  }
  return measured + MultipathBias(u, v, depth);
}

}  // namespace fallen::sim
