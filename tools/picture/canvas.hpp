// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "tools/picture/colors.hpp"

namespace fallen {

/// A rectangle on the canvas, pixels, y down.
struct Area {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

enum class TextAnchor { kLeft, kCenter, kRight };

/// How a text is set.
struct TextStyle {
  double size = 14;  ///< [px]
  Color color{0.13, 0.13, 0.13};
  bool bold = false;
  TextAnchor anchor = TextAnchor::kLeft;  ///< which end of the base line the position is
};

/// A picture to draw on, over Cairo.
class Canvas {
 public:
  /// @throws std::runtime_error if there is no memory for it.
  Canvas(int width, int height, const Color& background);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void FillRectangle(const Area& area, const Color& color);
  void StrokeRectangle(const Area& area, const Color& color, double width);
  void StrokeLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Color& color,
                  double width);
  /// The ellipse of the points p with (p - center)' covariance^-1 (p - center) <= sigmas^2.
  void FillEllipse(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance, double sigmas,
                   const Color& color);
  void FillPolygon(std::span<const Eigen::Vector2d> corners, const Color& color);
  void DrawText(const Eigen::Vector2d& position, const std::string& text, const TextStyle& style);
  /// A text on a plate of its own, so that it can be read on anything; `position` as in DrawText.
  void DrawLabel(const Eigen::Vector2d& position, const std::string& text, const TextStyle& style,
                 const Color& plate);
  /// Pixels (0xRRGGBB, row-major), scaled into `area`.
  void DrawImage(const Area& area, int width, int height, std::span<const std::uint32_t> pixels);

  /// Width of `text` [px].
  double TextWidth(const std::string& text, const TextStyle& style);

  /// Keeps what follows inside `area`, until the end of the scope of what is returned.
  class Clip;
  [[nodiscard]] Clip ClipTo(const Area& area);

  /// What has been drawn, 0x..RRGGBB, row-major.
  std::span<const std::uint32_t> Pixels();

  /// @throws std::runtime_error if the file cannot be written.
  void SavePng(const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class Canvas::Clip {
 public:
  explicit Clip(Canvas& canvas) : canvas_(canvas) {}
  ~Clip();
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;

 private:
  Canvas& canvas_;
};

}  // namespace fallen
