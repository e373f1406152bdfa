// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/legends.hpp"

namespace fallen {
namespace {

constexpr double kBarHeight = 14;
constexpr double kSwatch = 14;
constexpr double kGap = 8;
constexpr double kBetweenSwatches = 22;
const TextStyle kText{13, palette::kInk, false, TextAnchor::kLeft};
const TextStyle kTickText{12, palette::kFaintInk, false, TextAnchor::kCenter};

double DrawSwatchText(Canvas& canvas, const Eigen::Vector2d& position, const std::string& text) {
  const double left = position.x() + kSwatch + kGap;
  canvas.DrawText({left, position.y() + kSwatch - 2.5}, text, kText);
  return left + canvas.TextWidth(text, kText) + kBetweenSwatches;
}

}  // namespace

void DrawColorScale(Canvas& canvas, const Area& area, const ColorScale& scale) {
  canvas.DrawText({area.x, area.y + kBarHeight - 2.5}, scale.title, kText);
  const double left = area.x + canvas.TextWidth(scale.title, kText) + kGap + 4;
  const double width = area.x + area.width - left;
  const int steps = static_cast<int>(width);
  for (int i = 0; i < steps; ++i)
    canvas.FillRectangle({left + i, area.y, 1.5, kBarHeight}, scale.color((i + 0.5) / steps));
  for (const ColorScale::Tick& tick : scale.ticks) {
    const double x = left + tick.share * width;
    canvas.StrokeLine({x, area.y + kBarHeight}, {x, area.y + kBarHeight + 4}, palette::kFaintInk,
                      1);
    canvas.DrawText({x, area.y + kBarHeight + 17}, tick.text, kTickText);
  }
}

double DrawSwatch(Canvas& canvas, const Eigen::Vector2d& position, const Color& color,
                  const std::string& text) {
  canvas.FillRectangle({position.x(), position.y(), kSwatch, kSwatch}, color);
  return DrawSwatchText(canvas, position, text);
}

double DrawBoxSwatch(Canvas& canvas, const Eigen::Vector2d& position, const Color& color,
                     double line_width, const std::string& text) {
  canvas.StrokeRectangle({position.x() + 1, position.y() + 1, kSwatch - 2, kSwatch - 2}, color,
                         line_width);
  return DrawSwatchText(canvas, position, text);
}

}  // namespace fallen
