// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tools/simulate/random.hpp"

/// Noise over a picture that is the same for the same seed, whoever asks for which pixel first.
namespace fallen::sim {

/// Cheap, near enough to normal: the sum of four uniform numbers of 16 bits, scaled to unit
/// variance.
inline double NormalFromBits(std::uint64_t bits) {
  constexpr double kScale = std::numbers::sqrt3 / 65536.0;  // variance of one is 65536^2 / 12
  const auto sum = static_cast<double>((bits & 0xffff) + ((bits >> 16) & 0xffff) +
                                       ((bits >> 32) & 0xffff) + (bits >> 48));
  return (sum - 2 * 65535.0) * kScale;
}

/// Share of a normal distribution below `value`.
inline double NormalShareBelow(double value) {
  return 0.5 * std::erfc(-value / std::numbers::sqrt2);
}

/// Noise of mean 0 and variance 1 that changes over the lattice's spacing.
class NoiseField {
 public:
  NoiseField(std::uint64_t seed, int width, int height, double spacing)
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

}  // namespace fallen::sim
