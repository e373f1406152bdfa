// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/recording_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace fallen::sim {
namespace {

double Thousandths(double value) { return std::round(1000 * value) / 1000; }

}  // namespace

std::string DescribeRecording(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  nlohmann::ordered_json json;
  json["scenario"] = nlohmann::ordered_json::parse(DescribeScenario(simulation.scenario()));
  json["room_m"] = {Thousandths(scene.room_size.x()), Thousandths(scene.room_size.y())};
  json["objects"] = nlohmann::ordered_json::array();
  for (const SceneObject& object : scene.objects) json["objects"].push_back(object.category);
  if (const auto person = simulation.person_index()) {
    constexpr int kEvery = 5;
    json["placement"] = std::string(EnumName(simulation.placement_reached()));
    json["sink_m"] = Thousandths(simulation.settled().sink_m);
    json["float_m"] = Thousandths(simulation.settled().float_m);
    json["height_m"] = Thousandths(scene.objects[*person].box.size.z());
    for (int i = 0; i < simulation.scenario().frames; i += kEvery)
      json["visible_share"].push_back(Thousandths(simulation.VisibleShare(i)));
  }
  return json.dump();
}

}  // namespace fallen::sim
