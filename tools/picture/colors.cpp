// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/colors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace fallen {
namespace {

constexpr Color Rgb(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0};
}

// Nine samples of matplotlib's viridis (CC0), bright end first.
constexpr std::array kViridis = {Rgb(253, 231, 37), Rgb(173, 220, 48), Rgb(94, 201, 98),
                                 Rgb(40, 174, 128), Rgb(33, 145, 140), Rgb(44, 114, 142),
                                 Rgb(59, 82, 139),  Rgb(71, 45, 123),  Rgb(68, 1, 84)};

// From a quiet blue through grey to a loud red: what is to be seen is where persons may be.
constexpr std::array kScore = {Rgb(104, 136, 184), Rgb(158, 178, 205), Rgb(208, 208, 208),
                               Rgb(238, 128, 96), Rgb(196, 20, 44)};

Color Interpolate(std::span<const Color> stops, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double t = place - static_cast<double>(below);
  const Color& a = stops[below];
  const Color& b = stops[below + 1];
  return {std::lerp(a.red, b.red, t), std::lerp(a.green, b.green, t), std::lerp(a.blue, b.blue, t)};
}

std::uint32_t Byte(double value) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
}

}  // namespace

std::uint32_t PackColor(const Color& color) {
  return Byte(color.red) << 16 | Byte(color.green) << 8 | Byte(color.blue);
}

Color Shade(const Color& color, double factor) {
  return {color.red * factor, color.green * factor, color.blue * factor, color.alpha};
}

Color DepthColor(double share) { return Interpolate(kViridis, share); }

Color ScoreColor(double score) { return Interpolate(kScore, (score / kScoreColorRange + 1) / 2); }

}  // namespace fallen
