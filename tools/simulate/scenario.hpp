// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/simulate/furniture_catalogue.hpp"
#include "tools/simulate/lying_poses.hpp"
#include "tools/simulate/person_placement.hpp"
#include "tools/simulate/room_layout.hpp"
#include "tools/simulate/sensor_model.hpp"

namespace fallen::sim {

/// A recording to make, with nothing left open.
///
/// In the file every key may be missing: it is then drawn from `seed`, each from a stream of its
/// own, so that fixing one key leaves the others as they are.
struct Scenario {
  std::int64_t seed = 1;
  bool person = true;  ///< a person lies on the floor
  int body = 1;        ///< which one, > 0
  PoseFamily pose = PoseFamily::kSupine;
  Placement placement = Placement::kFree;
  bool blanket = false;  ///< over the person's legs
  /// Chance of each cloth of the fallen person and of each distractor to reflect next to nothing,
  /// [0, 1]. Blankets and people on furniture stay as they are.
  double black_cloth = 0;
  bool half_hidden = false;  ///< drives, if there are some, past what hides half of the person
  /// From then on the person stands elsewhere in the room, or has left it if it is too full [s].
  std::optional<double> gets_up_after_s;
  std::optional<double> yaw_deg;  ///< of the line from pelvis to head in the world; any if missing
  bool furnished = true;          ///< false: bare room, the person in its middle
  int room = 1;                   ///< which one, > 0
  RoomKind room_kind = RoomKind::kAny;
  FurniturePool furniture_pool = FurniturePool::kTrain;
  int clutter = 2;             ///< small things standing about
  double moved_furniture = 0;  ///< share of the room's pieces that stand elsewhere, [0, 1]
  std::vector<std::string> distractors;  ///< kinds, see DistractorKinds()
  bool distractors_near = false;         ///< as near to the person as there is room

  int frames = 60;
  double rate_hz = 10;
  double max_speed_m_s = 0.6;
  int width = 320;  ///< 320 or 640
  SensorKind sensor = SensorKind::kStructuredLight;
  double sensor_variation = 0;  ///< 0: as in the data sheet; 1: any copy, see DrawSensor
  double camera_height_m = 1.1;
  double camera_pitch_deg = 25;  ///< downwards
  std::string camera = "CAMERA";
  double mounting_error_deg = 0;  ///< size of the difference between true and told mounting
  double mounting_error_m = 0;
  double odometry_drift = 0;  ///< metres astray for each metre driven
  bool noise = true;
  double noise_scale = 1;  ///< times the noise of that copy of the sensor, along the ray and across

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("seed", seed);
    visit("person", person);
    visit("body", body);
    visit("pose", pose);
    visit("placement", placement);
    visit("blanket", blanket);
    visit("black_cloth", black_cloth);
    visit("half_hidden", half_hidden);
    visit("gets_up_after_s", gets_up_after_s);
    visit("yaw_deg", yaw_deg);
    visit("furnished", furnished);
    visit("room", room);
    visit("room_kind", room_kind);
    visit("furniture_pool", furniture_pool);
    visit("clutter", clutter);
    visit("moved_furniture", moved_furniture);
    visit("distractors", distractors);
    visit("distractors_near", distractors_near);
    visit("frames", frames);
    visit("rate_hz", rate_hz);
    visit("max_speed_m_s", max_speed_m_s);
    visit("width", width);
    visit("sensor", sensor);
    visit("sensor_variation", sensor_variation);
    visit("camera_height_m", camera_height_m);
    visit("camera_pitch_deg", camera_pitch_deg);
    visit("camera", camera);
    visit("mounting_error_deg", mounting_error_deg);
    visit("mounting_error_m", mounting_error_m);
    visit("odometry_drift", odometry_drift);
    visit("noise", noise);
    visit("noise_scale", noise_scale);
  }

  /// @throws std::invalid_argument: "<key>: got ..., expected ...".
  void Validate() const;
};

/// Reads a scenario and draws what it leaves open.
///
/// @param overrides  "key=value" as on the command line; the value is YAML, too.
/// @throws std::runtime_error: "<file>:<line>: <key>: got ..., expected ...".
Scenario LoadScenario(const std::filesystem::path& path, const std::vector<std::string>& overrides);
/// The same from text; `source` stands for the file's name in errors.
Scenario ParseScenario(const std::string& text, const std::string& source,
                       const std::vector<std::string>& overrides);

/// All keys and values, as one JSON object.
std::string DescribeScenario(const Scenario& scenario);

}  // namespace fallen::sim
