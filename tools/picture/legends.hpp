// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/picture/canvas.hpp"

namespace fallen {

/// Space that a panel keeps for its legend [px].
inline constexpr double kLegendHeight = 64;

/// A bar of colours with marks.
struct ColorScale {
  struct Tick {
    double share = 0;  ///< of the bar, [0, 1]
    std::string text;
  };
  std::string title;
  std::function<Color(double share)> color;
  std::vector<Tick> ticks;
};

/// Draws title, bar and marks in a row of `area`.
void DrawColorScale(Canvas& canvas, const Area& area, const ColorScale& scale);

/// Draws a square of `color` and what it stands for. @return Where the next one may begin (x).
double DrawSwatch(Canvas& canvas, const Eigen::Vector2d& position, const Color& color,
                  const std::string& text);

/// Draws the outline of a box and what it stands for. @return Where the next one may begin (x).
double DrawBoxSwatch(Canvas& canvas, const Eigen::Vector2d& position, const Color& color,
                     double line_width, const std::string& text);

}  // namespace fallen
