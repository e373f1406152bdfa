// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/drawn_box.hpp"

#include <cstdio>
#include <limits>
#include <optional>

#include "tools/picture/box_edges.hpp"

namespace fallen {
namespace {

constexpr double kHalo = 2.5;  // [px] white beside each line, so that it is seen on any colour
constexpr std::size_t kMaxLabelledCandidates = 5;  // more would hide the picture

std::string ProbabilityLabel(const PersonHypothesis& person) {
  char text[64];
  std::snprintf(text, sizeof text, person.is_person ? "person  p = %.3f" : "%.3f",
                person.probability);
  return text;
}

}  // namespace

std::vector<DrawnBox> BoxesToDraw(const ViewedFrame& viewed) {
  const Decision& decision = viewed.result.decision;
  std::vector<DrawnBox> boxes;
  // The label is in the world: it can only be drawn where the map is there too.
  if (viewed.truth && decision.frame == MapFrame::kWorld)
    boxes.push_back({*viewed.truth, palette::kTruth, 1.5, ""});
  for (std::size_t i = decision.hypotheses.size(); i-- > 0;) {
    const PersonHypothesis& person = decision.hypotheses[i];
    if (person.is_person) continue;
    const bool has_label = i < kMaxLabelledCandidates;
    boxes.push_back(
        {person.box, palette::kCandidate, 1.2, has_label ? ProbabilityLabel(person) : ""});
  }
  for (std::size_t i = decision.hypotheses.size(); i-- > 0;) {
    const PersonHypothesis& person = decision.hypotheses[i];
    if (person.is_person)
      boxes.push_back({person.box, palette::kPerson, 2.5, ProbabilityLabel(person)});
  }
  return boxes;
}

void DrawBox(Canvas& canvas, const DrawnBox& box,
             const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& project,
             const std::function<bool(Eigen::Vector3d&, Eigen::Vector3d&)>& clip_edge) {
  const std::array<Eigen::Vector3d, 8> corners = BoxCorners(box.box);
  struct Line {
    Eigen::Vector2d from, to;
  };
  std::vector<Line> lines;
  std::optional<Eigen::Vector2d> top;
  for (const auto& [a, b] : BoxEdges()) {
    Eigen::Vector3d from = corners[a];
    Eigen::Vector3d to = corners[b];
    if (!clip_edge(from, to)) continue;
    lines.push_back({project(from), project(to)});
    for (const Eigen::Vector2d& end : {lines.back().from, lines.back().to})
      if (!top || end.y() < top->y()) top = end;
  }
  for (const Line& line : lines)
    canvas.StrokeLine(line.from, line.to, {1, 1, 1, 0.6}, box.line_width + kHalo);
  for (const Line& line : lines) canvas.StrokeLine(line.from, line.to, box.color, box.line_width);
  if (!top || box.label.empty()) return;
  TextStyle style;
  style.size = box.line_width > 2 ? 16 : 12;
  style.bold = box.line_width > 2;
  style.color = palette::kPaper;
  canvas.DrawLabel(*top - Eigen::Vector2d(0, 10), box.label, style, box.color);
}

}  // namespace fallen
