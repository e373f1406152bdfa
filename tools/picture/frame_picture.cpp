// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/frame_picture.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <string>

#include "fallen/geometry/ground_plane.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/picture/canvas.hpp"
#include "tools/picture/depth_panel.hpp"
#include "tools/picture/map_panel.hpp"

namespace fallen {
namespace {

constexpr double kWidth = kPictureWidth;
constexpr double kHeight = kPictureHeight;
constexpr double kMargin = 24;
constexpr double kTitleHeight = 76;

template <class... Arguments>
std::string Format(const char* format, Arguments... arguments) {
  char text[256];
  std::snprintf(text, sizeof text, format, arguments...);
  return text;
}

std::string Text(std::string_view view) { return std::string(view); }

std::string DescribeGround(const NdtMap& map) {
  if (!map.ground.ok()) return "floor: " + Text(EnumName(map.ground.status));
  const Plane ground_camera = TransformPlane(map.T_map_camera.inverse(), map.ground.plane);
  const CameraAttitude attitude = AttitudeOverGround(ground_camera);
  return Format("floor by %s, camera %.2f m above it, %.1f° down",
                Text(EnumName(map.ground.method)).c_str(), attitude.height_m,
                attitude.pitch_rad * 180 / std::numbers::pi);
}

std::string Count(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string Title(const ViewedFrame& viewed) {
  return viewed.source + "   frame " + std::to_string(viewed.index) +
         Format("   t = %.6f s", static_cast<double>(viewed.frame.utime) * 1e-6);
}

}  // namespace

std::string DescribeFrame(const ViewedFrame& viewed) {
  const NdtMap& map = viewed.result.foreground.map;
  const auto& hypotheses = viewed.result.decision.hypotheses;
  const auto persons = static_cast<std::size_t>(
      std::count_if(hypotheses.begin(), hypotheses.end(),
                    [](const PersonHypothesis& hypothesis) { return hypothesis.is_person; }));
  return DescribeGround(map) + "  ·  " + Count(map.cells.size(), "cell", "cells") + " (" +
         Text(EnumName(map.frame)) + ")  ·  " + Count(hypotheses.size(), "cluster", "clusters") +
         ", " + Count(persons, "fallen person", "fallen persons") +
         Format(" (p ≥ %.3f)", viewed.result.decision.min_probability) +
         Format("  ·  %.1f ms", viewed.result.milliseconds.total);
}

void DrawFramePicture(Canvas& canvas, const ViewedFrame& viewed) {
  TextStyle title;
  title.size = 22;
  title.bold = true;
  canvas.DrawText({kMargin, 36}, Title(viewed), title);
  TextStyle subtitle;
  subtitle.size = 15;
  subtitle.color = palette::kFaintInk;
  canvas.DrawText({kMargin, 62}, DescribeFrame(viewed), subtitle);

  constexpr double kPanelWidth = (kWidth - 3 * kMargin) / 2;
  constexpr double kPanelHeight = kHeight - kTitleHeight - kMargin / 2;
  DrawDepthPanel(canvas, {kMargin, kTitleHeight, kPanelWidth, kPanelHeight}, viewed);
  DrawMapPanel(canvas, {2 * kMargin + kPanelWidth, kTitleHeight, kPanelWidth, kPanelHeight},
               viewed);
}

void SaveFramePicture(const std::filesystem::path& png, const ViewedFrame& viewed) {
  Canvas canvas(kPictureWidth, kPictureHeight, palette::kPaper);
  DrawFramePicture(canvas, viewed);
  PartialFile file(png);
  canvas.SavePng(file.path());
  file.Commit();
}

}  // namespace fallen
