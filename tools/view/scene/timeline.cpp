// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/scene/timeline.hpp"

#include <algorithm>
#include <cmath>

namespace fallen {
namespace {

double Rounded(double value, double step) { return std::round(value / step) * step; }

}  // namespace

TimelineEntry ToTimelineEntry(const Scene& scene) {
  TimelineEntry entry;
  entry.utime = scene.header.utime;
  if (scene.decision) {
    const auto& hypotheses = scene.decision->hypotheses;
    entry.probability = hypotheses.empty() ? 0 : hypotheses.front().probability;
    entry.persons = static_cast<int>(std::count_if(
        hypotheses.begin(), hypotheses.end(), [](const auto& found) { return found.is_person; }));
  }
  if (scene.map && scene.map->map.frame == MapFrame::kWorld)
    entry.camera = scene.map->map.T_map_camera.translation();
  else if (scene.segmented && scene.segmented->frame == MapFrame::kWorld)
    entry.camera = scene.segmented->T_map_camera.translation();
  return entry;
}

nlohmann::json ToJson(const TimelineEntry& entry) {
  nlohmann::json json = {entry.utime, nullptr, entry.persons};
  if (entry.probability) json[1] = Rounded(*entry.probability, 1e-4);
  if (entry.camera)
    for (const double value : *entry.camera) json.push_back(Rounded(value, 1e-3));
  return json;
}

}  // namespace fallen
