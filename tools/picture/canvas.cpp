// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/canvas.hpp"

#include <cairo.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

namespace fallen {
namespace {

constexpr char kFont[] = "DejaVu Sans";
/// Space around the text of a label [px].
constexpr double kLabelMargin = 4;

void Check(cairo_status_t status, const std::string& what) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(what + ": " + cairo_status_to_string(status));
}

void SetColor(cairo_t* cairo, const Color& color) {
  cairo_set_source_rgba(cairo, color.red, color.green, color.blue, color.alpha);
}

void SetFont(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, kFont, CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size);
}

}  // namespace

struct Canvas::State {
  cairo_surface_t* surface;
  cairo_t* cairo;

  State(int width, int height)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
        cairo(cairo_create(surface)) {}
  ~State() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

Canvas::Canvas(int width, int height, const Color& background)
    : state_(std::make_unique<State>(width, height)) {
  Check(cairo_surface_status(state_->surface), "picture");
  FillRectangle({0, 0, static_cast<double>(width), static_cast<double>(height)}, background);
}

Canvas::~Canvas() = default;

void Canvas::FillRectangle(const Area& area, const Color& color) {
  SetColor(state_->cairo, color);
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  cairo_fill(state_->cairo);
}

void Canvas::StrokeRectangle(const Area& area, const Color& color, double width) {
  SetColor(state_->cairo, color);
  cairo_set_line_width(state_->cairo, width);
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  cairo_stroke(state_->cairo);
}

void Canvas::StrokeLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Color& color,
                        double width) {
  SetColor(state_->cairo, color);
  cairo_set_line_width(state_->cairo, width);
  cairo_set_line_cap(state_->cairo, CAIRO_LINE_CAP_ROUND);
  cairo_move_to(state_->cairo, from.x(), from.y());
  cairo_line_to(state_->cairo, to.x(), to.y());
  cairo_stroke(state_->cairo);
}

void Canvas::FillEllipse(const Eigen::Vector2d& center, const Eigen::Matrix2d& covariance,
                         double sigmas, const Color& color) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance);
  const Eigen::Vector2d radii = sigmas * axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  constexpr double kMinRadius = 0.5;  // [px] a thinner one would not be seen
  const Eigen::Vector2d major = axes.eigenvectors().col(1);
  cairo_t* cairo = state_->cairo;
  cairo_save(cairo);
  cairo_translate(cairo, center.x(), center.y());
  cairo_rotate(cairo, std::atan2(major.y(), major.x()));
  cairo_scale(cairo, std::max(radii[1], kMinRadius), std::max(radii[0], kMinRadius));
  cairo_new_path(cairo);
  cairo_arc(cairo, 0, 0, 1, 0, 2 * std::numbers::pi);
  cairo_restore(cairo);
  SetColor(cairo, color);
  cairo_fill(cairo);
}

void Canvas::FillPolygon(std::span<const Eigen::Vector2d> corners, const Color& color) {
  cairo_new_path(state_->cairo);
  for (const Eigen::Vector2d& corner : corners)
    cairo_line_to(state_->cairo, corner.x(), corner.y());
  SetColor(state_->cairo, color);
  cairo_fill(state_->cairo);
}

double Canvas::TextWidth(const std::string& text, const TextStyle& style) {
  SetFont(state_->cairo, style);
  cairo_text_extents_t extents;
  cairo_text_extents(state_->cairo, text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::DrawText(const Eigen::Vector2d& position, const std::string& text,
                      const TextStyle& style) {
  const double width = TextWidth(text, style);
  double left = position.x();
  if (style.anchor == TextAnchor::kCenter) left -= width / 2;
  if (style.anchor == TextAnchor::kRight) left -= width;
  SetColor(state_->cairo, style.color);
  cairo_move_to(state_->cairo, left, position.y());
  cairo_show_text(state_->cairo, text.c_str());
}

void Canvas::DrawLabel(const Eigen::Vector2d& position, const std::string& text,
                       const TextStyle& style, const Color& plate) {
  const double width = TextWidth(text, style);
  double left = position.x();
  if (style.anchor == TextAnchor::kCenter) left -= width / 2;
  if (style.anchor == TextAnchor::kRight) left -= width;
  FillRectangle({left - kLabelMargin, position.y() - style.size - kLabelMargin / 2,
                 width + 2 * kLabelMargin, style.size + 2 * kLabelMargin},
                plate);
  DrawText(position, text, style);
}

void Canvas::DrawImage(const Area& area, int width, int height,
                       std::span<const std::uint32_t> pixels) {
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  Check(cairo_surface_status(image), "picture");
  cairo_surface_flush(image);
  const int stride = cairo_image_surface_get_stride(image);
  unsigned char* data = cairo_image_surface_get_data(image);
  for (int v = 0; v < height; ++v)
    std::memcpy(data + static_cast<std::size_t>(v) * stride,
                pixels.data() + static_cast<std::size_t>(v) * width,
                static_cast<std::size_t>(width) * sizeof(std::uint32_t));
  cairo_surface_mark_dirty(image);

  cairo_t* cairo = state_->cairo;
  cairo_save(cairo);
  cairo_translate(cairo, area.x, area.y);
  cairo_scale(cairo, area.width / width, area.height / height);
  cairo_set_source_surface(cairo, image, 0, 0);
  // Depth is not to be smoothed over edges: what is shown is what was measured.
  cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo);
  cairo_restore(cairo);
  cairo_surface_destroy(image);
}

Canvas::Clip Canvas::ClipTo(const Area& area) {
  cairo_save(state_->cairo);
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  cairo_clip(state_->cairo);
  return Clip(*this);
}

Canvas::Clip::~Clip() { cairo_restore(canvas_.state_->cairo); }

std::span<const std::uint32_t> Canvas::Pixels() {
  cairo_surface_flush(state_->surface);
  const unsigned char* bytes = cairo_image_surface_get_data(state_->surface);
  const int width = cairo_image_surface_get_width(state_->surface);
  const int height = cairo_image_surface_get_height(state_->surface);
  // Rows of 32-bit pixels follow each other without a gap.
  return {reinterpret_cast<const std::uint32_t*>(bytes),
          static_cast<std::size_t>(width) * static_cast<std::size_t>(height)};
}

void Canvas::SavePng(const std::filesystem::path& file) {
  Check(cairo_status(state_->cairo), "picture");
  Check(cairo_surface_write_to_png(state_->surface, file.c_str()),
        file.string() + ": cannot be written");
}

}  // namespace fallen
