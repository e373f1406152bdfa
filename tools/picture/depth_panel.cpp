// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/depth_panel.hpp"

#include <algorithm>
#include <vector>

#include "tools/picture/drawn_box.hpp"
#include "tools/picture/legends.hpp"

namespace fallen {
namespace {

// What PrimeSense-type sensors measure; fixed, so that pictures can be compared.
constexpr double kNearM = 0.5;
constexpr double kFarM = 5.0;
/// Nearer to the camera than this, a box is cut off [m].
constexpr double kClipM = 0.1;

std::vector<std::uint32_t> ColorDepth(const DepthImage& image) {
  std::vector<std::uint32_t> pixels(image.depth.size());
  std::transform(image.depth.begin(), image.depth.end(), pixels.begin(), [&](std::uint16_t depth) {
    if (depth == 0) return PackColor(palette::kNoDepth);
    const double z_m = depth * image.depth_unit_m;
    return PackColor(DepthColor((z_m - kNearM) / (kFarM - kNearM)));
  });
  return pixels;
}

/// The largest area of the image's shape in `area`, at its top.
Area FitImage(const Area& area, const CameraIntrinsics& camera) {
  const double scale = std::min(area.width / camera.width, area.height / camera.height);
  const double width = scale * camera.width;
  return {area.x + (area.width - width) / 2, area.y, width, scale * camera.height};
}

/// Cuts an edge (camera frame) where it passes behind the camera.
bool ClipToFront(Eigen::Vector3d& from, Eigen::Vector3d& to) {
  if (from.z() < kClipM && to.z() < kClipM) return false;
  Eigen::Vector3d& behind = from.z() < to.z() ? from : to;
  const Eigen::Vector3d& ahead = from.z() < to.z() ? to : from;
  if (behind.z() < kClipM)
    behind += (ahead - behind) * ((kClipM - behind.z()) / (ahead.z() - behind.z()));
  return true;
}

}  // namespace

void DrawDepthPanel(Canvas& canvas, const Area& area, const ViewedFrame& viewed) {
  const DepthImage& image = viewed.frame.image;
  const CameraIntrinsics& camera = image.intrinsics;
  const Area place = FitImage({area.x, area.y, area.width, area.height - kLegendHeight}, camera);
  canvas.DrawImage(place, camera.width, camera.height, ColorDepth(image));

  {
    const Canvas::Clip clip = canvas.ClipTo(place);
    const Eigen::Isometry3d T_camera_map = viewed.result.segmented.T_map_camera.inverse();
    const double scale = place.width / camera.width;
    const auto project = [&](const Eigen::Vector3d& p_camera) -> Eigen::Vector2d {
      // Pixel centres are whole numbers: the picture's corner is at (-0.5, -0.5).
      const Eigen::Vector2d pixel = camera.Project(p_camera) + Eigen::Vector2d::Constant(0.5);
      return Eigen::Vector2d(place.x, place.y) + scale * pixel;
    };
    const auto to_camera = [&](Eigen::Vector3d& from, Eigen::Vector3d& to) {
      from = T_camera_map * from;
      to = T_camera_map * to;
      return ClipToFront(from, to);
    };
    for (const DrawnBox& box : BoxesToDraw(viewed)) DrawBox(canvas, box, project, to_camera);
  }
  canvas.StrokeRectangle(place, palette::kFaintInk, 1);

  ColorScale scale;
  scale.title = "depth";
  scale.color = DepthColor;
  scale.ticks = {{0, "0.5 m"},     {0.5 / 4.5, "1"}, {1.5 / 4.5, "2"},
                 {2.5 / 4.5, "3"}, {3.5 / 4.5, "4"}, {1, "5 m"}};
  const double y = place.y + place.height + 14;
  DrawColorScale(canvas, {place.x, y, place.width * 0.62, kLegendHeight}, scale);
  DrawSwatch(canvas, {place.x + place.width * 0.70, y}, palette::kNoDepth, "no depth");
}

}  // namespace fallen
