// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/map_panel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/picture/box_edges.hpp"
#include "tools/picture/drawn_box.hpp"
#include "tools/picture/legends.hpp"
#include "tools/picture/map_cells.hpp"
#include "tools/picture/oblique_view.hpp"

namespace fallen {
namespace {

constexpr double kSigmas = 2;      // an ellipsoid then about fills its patch of the surface
constexpr double kMargin = 24;     // [px] around what is drawn
constexpr double kCutOff = 0.01;   // share of the cells on each side that may lie outside
constexpr double kMinExtentM = 2;  // an empty room is not blown up
constexpr double kMaxPixelsPerM = 320;
constexpr double kGridReachM = 8;  // metre lines drawn at most this far

/// Bounds of what is to be seen, in pixels at one pixel a metre.
struct Bounds {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

Bounds FindBounds(const std::vector<DrawnCell>& cells, const std::vector<DrawnBox>& boxes,
                  const Eigen::Isometry3d& T_view_map) {
  const ObliqueView unit(1, Eigen::Vector2d::Zero());
  Bounds bounds;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<double> places = {0};  // the camera's place on the floor
    for (const DrawnCell& cell : cells) places.push_back(unit.Project(cell.mean)[axis]);
    std::sort(places.begin(), places.end());
    const auto cut = static_cast<std::size_t>(kCutOff * static_cast<double>(places.size()));
    bounds.low[axis] = std::min(places[cut], 0.0);
    bounds.high[axis] = std::max(places[places.size() - 1 - cut], 0.0);
  }
  for (const DrawnBox& drawn : boxes)
    for (const Eigen::Vector3d& corner : BoxCorners(drawn.box)) {
      const Eigen::Vector2d place = unit.Project(T_view_map * corner);
      bounds.low = bounds.low.cwiseMin(place);
      bounds.high = bounds.high.cwiseMax(place);
    }
  for (int axis = 0; axis < 2; ++axis) {
    const double missing = kMinExtentM - (bounds.high[axis] - bounds.low[axis]);
    if (missing <= 0) continue;
    bounds.low[axis] -= missing / 2;
    bounds.high[axis] += missing / 2;
  }
  return bounds;
}

ObliqueView FitView(const Area& area, const Bounds& bounds) {
  const Eigen::Vector2d extent = bounds.high - bounds.low;
  const double scale = std::min({(area.width - 2 * kMargin) / extent.x(),
                                 (area.height - 2 * kMargin) / extent.y(), kMaxPixelsPerM});
  const Eigen::Vector2d middle(area.x + area.width / 2, area.y + area.height / 2);
  return ObliqueView(scale, middle - scale * (bounds.low + bounds.high) / 2);
}

/// Metre lines on the floor, and the distances ahead.
void DrawFloor(Canvas& canvas, const ObliqueView& view) {
  const int reach = static_cast<int>(kGridReachM);
  for (int i = -reach; i <= reach; ++i) {
    const double side = i;
    canvas.StrokeLine(view.Project({0, side, 0}), view.Project({kGridReachM, side, 0}),
                      palette::kGrid, 1);
    if (i >= 0)
      canvas.StrokeLine(view.Project({side, -kGridReachM, 0}), view.Project({side, kGridReachM, 0}),
                        palette::kGrid, 1);
  }
}

void DrawDistances(Canvas& canvas, const Area& area, const ObliqueView& view) {
  TextStyle style;
  style.size = 12;
  style.color = palette::kFaintInk;
  style.anchor = TextAnchor::kRight;
  for (int ahead = 1; ahead <= static_cast<int>(kGridReachM); ++ahead) {
    const double y = view.Project({static_cast<double>(ahead), 0, 0}).y();
    if (y < area.y + 16 || y > area.y + area.height - 4) continue;
    canvas.DrawLabel({area.x + area.width - 8, y + 4}, std::to_string(ahead) + " m", style,
                     {1, 1, 1, 0.8});
  }
}

/// A triangle where the camera stands, pointing where it looks.
void DrawCamera(Canvas& canvas, const ObliqueView& view) {
  const std::vector<Eigen::Vector2d> corners = {
      view.Project({0.12, 0, 0}), view.Project({-0.08, 0.09, 0}), view.Project({-0.08, -0.09, 0})};
  canvas.FillPolygon(corners, palette::kInk);
  TextStyle style;
  style.size = 12;
  canvas.DrawText(view.Project({-0.08, -0.09, 0}) + Eigen::Vector2d(6, 2), "camera", style);
}

void DrawLegend(Canvas& canvas, const Area& area, const ViewedFrame& viewed) {
  ColorScale scale;
  scale.title = "cell score";
  scale.color = [](double share) { return ScoreColor((2 * share - 1) * kScoreColorRange); };
  scale.ticks = {{0, "≤ -0.25"}, {0.5, "0"}, {1, "≥ 0.25 person"}};
  DrawColorScale(canvas, {area.x, area.y, area.width * 0.36, area.height}, scale);

  double x = area.x + area.width * 0.44;
  x = DrawSwatch(canvas, {x, area.y}, palette::kUnscoredCell, "not scored");
  if (viewed.result.foreground.status == BackgroundStatus::kSubtracted)
    DrawSwatch(canvas, {x, area.y}, palette::kBackgroundCell, "known background");
  x = area.x + area.width * 0.44;
  const double second_row = area.y + 26;
  x = DrawBoxSwatch(canvas, {x, second_row}, palette::kPerson, 2.5, "fallen person");
  x = DrawBoxSwatch(canvas, {x, second_row}, palette::kCandidate, 1.5, "other cluster");
  if (viewed.truth) DrawBoxSwatch(canvas, {x, second_row}, palette::kTruth, 1.5, "label");
}

}  // namespace

void DrawMapPanel(Canvas& canvas, const Area& area, const ViewedFrame& viewed) {
  const NdtMap& map = viewed.result.foreground.map;
  const Eigen::Isometry3d T_view_map = ViewFromMap(map.frame, map.T_map_camera);
  const std::vector<DrawnCell> cells = CellsToDraw(viewed.result, T_view_map);
  const std::vector<DrawnBox> boxes = BoxesToDraw(viewed);

  const Area place = {area.x, area.y, area.width, area.height - kLegendHeight};
  const ObliqueView view = FitView(place, FindBounds(cells, boxes, T_view_map));
  {
    const Canvas::Clip clip = canvas.ClipTo(place);
    if (map.frame != MapFrame::kCamera) DrawFloor(canvas, view);
    DrawCamera(canvas, view);
    for (const DrawnCell& cell : cells)
      canvas.FillEllipse(view.Project(cell.mean), view.ProjectCovariance(cell.covariance), kSigmas,
                         cell.color);
    const auto project = [&](const Eigen::Vector3d& p_map) {
      return view.Project(T_view_map * p_map);
    };
    const auto keep = [](Eigen::Vector3d&, Eigen::Vector3d&) { return true; };
    for (const DrawnBox& box : boxes) DrawBox(canvas, box, project, keep);
    if (map.frame != MapFrame::kCamera) DrawDistances(canvas, place, view);
  }
  canvas.StrokeRectangle(place, palette::kFaintInk, 1);
  DrawLegend(canvas, {place.x, place.y + place.height + 14, place.width, kLegendHeight}, viewed);
}

}  // namespace fallen
