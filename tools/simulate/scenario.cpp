// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/scenario.hpp"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "fallen/service/yaml_fields.hpp"
#include "tools/simulate/distractors.hpp"
#include "tools/simulate/random.hpp"
#include "tools/simulate/resting_person.hpp"

namespace fallen::sim {
namespace {

// Beside a person up to two things of any kind. Without one, what false alarms come from: people on
// furniture, people who stand or stoop, dogs, and things; one room in seven is empty.
std::vector<std::string> DrawDistractors(bool person, Random random) {
  std::vector<std::string> kinds;
  const auto any = [&](int count) {
    for (; count > 0; --count) kinds.push_back(random.Pick(DistractorKinds()));
  };
  const auto one_of = [&](double probability, std::initializer_list<const char*> names) {
    if (random.Chance(probability)) kinds.emplace_back(names.begin()[random.Index(names.size())]);
  };
  if (person) {
    any(random.Integer(0, 2));
    return kinds;
  }
  if (random.Chance(1.0 / 7)) return kinds;
  one_of(0.3, {kResting});
  one_of(0.25, {kSeated});
  one_of(0.3, {"lying_dog", "lying_dog", "sitting_dog", "standing_dog", "dog", "cat"});
  one_of(0.35, {kStandingPerson, "sitting_person", "kneeling_person", "bending_person",
                "crouching_person"});
  one_of(0.4, {"pile", "blanket", "sleeping_bag", "air_mattress", "clothes", "rolled_carpet",
               "backpack_and_bag"});
  any(random.Integer(0, 2));
  return kinds;
}

// What the file leaves open.
Scenario DrawScenario(const std::set<std::string>& given, Scenario scenario) {
  const auto seed = static_cast<std::uint64_t>(scenario.seed);
  const auto open = [&](const char* key) { return !given.contains(key); };
  const auto stream = [&](const char* key) { return Random::Stream(seed, key); };
  if (open("person")) scenario.person = stream("person").Chance(0.7);
  if (open("body")) scenario.body = stream("body").Integer(1, 1000);
  if (open("pose")) scenario.pose = stream("pose").Pick(EnumNames(PoseFamily{})).first;
  if (open("placement")) {
    const double draw = stream("placement").Uniform();
    scenario.placement =
        draw < 0.6 ? Placement::kFree : (draw < 0.85 ? Placement::kTouching : Placement::kUnder);
  }
  if (open("blanket")) scenario.blanket = stream("blanket").Chance(0.06);
  if (open("room")) scenario.room = stream("room").Integer(1, 1000);
  if (open("clutter")) scenario.clutter = stream("clutter").Integer(0, 4);
  if (open("distractors"))
    scenario.distractors = DrawDistractors(scenario.person, stream("distractors"));
  if (open("camera_height_m"))
    scenario.camera_height_m = stream("camera_height_m").Uniform(0.9, 1.3);
  if (open("camera_pitch_deg"))
    scenario.camera_pitch_deg = stream("camera_pitch_deg").Uniform(18, 32);
  return scenario;
}

template <class T>
void Require(bool condition, const char* key, const T& got, const char* expected) {
  if (condition) return;
  std::ostringstream message;
  message << key << ": got " << got << ", expected " << expected;
  throw std::invalid_argument(message.str());
}

}  // namespace

void Scenario::Validate() const {
  Require(body > 0, "body", body, "a number > 0");
  Require(room > 0, "room", room, "a number > 0");
  Require(clutter >= 0 && clutter <= 50, "clutter", clutter, "0 to 50");
  Require(moved_furniture >= 0 && moved_furniture <= 1, "moved_furniture", moved_furniture,
          "0 to 1");
  Require(black_cloth >= 0 && black_cloth <= 1, "black_cloth", black_cloth, "0 to 1");
  if (gets_up_after_s)
    Require(*gets_up_after_s > 0, "gets_up_after_s", *gets_up_after_s, "a number > 0");
  Require(frames > 0 && frames <= 100000, "frames", frames, "1 to 100000");
  Require(rate_hz > 0 && rate_hz <= 100, "rate_hz", rate_hz, "a number in (0, 100]");
  Require(max_speed_m_s >= 0 && max_speed_m_s <= 2, "max_speed_m_s", max_speed_m_s, "0 to 2");
  Require(width == 320 || width == 640, "width", width, "320 or 640");
  Require(sensor_variation >= 0 && sensor_variation <= 1, "sensor_variation", sensor_variation,
          "0 to 1");
  Require(camera_height_m >= 0.3 && camera_height_m <= 1.6, "camera_height_m", camera_height_m,
          "0.3 to 1.6");
  Require(camera_pitch_deg >= 0 && camera_pitch_deg <= 45, "camera_pitch_deg", camera_pitch_deg,
          "0 to 45");
  Require(!camera.empty(), "camera", "nothing", "a name");
  Require(mounting_error_deg >= 0 && mounting_error_deg <= 10, "mounting_error_deg",
          mounting_error_deg, "0 to 10");
  Require(mounting_error_m >= 0 && mounting_error_m <= 0.2, "mounting_error_m", mounting_error_m,
          "0 to 0.2");
  Require(odometry_drift >= 0 && odometry_drift <= 0.5, "odometry_drift", odometry_drift,
          "0 to 0.5");
  Require(noise_scale >= 0 && noise_scale <= 10, "noise_scale", noise_scale, "0 to 10");
  Require(distractors.size() <= 20, "distractors", distractors.size(), "at most 20");
  for (const std::string& kind : distractors) {
    std::string kinds;
    bool known = false;
    for (const std::string& candidate : DistractorKinds()) {
      kinds += (kinds.empty() ? "one of " : ", ") + candidate;
      known |= candidate == kind;
    }
    Require(known, "distractors", kind, kinds.c_str());
  }
}

namespace {

// Takes over what one document says; `given` collects its keys.
void Apply(YAML::Node root, const std::string& source, Scenario& scenario,
           std::set<std::string>& given) {
  const YamlPlace place{source, ""};
  RequireYamlMap(root, place);
  const YAML::Node distractors = root["distractors"];
  if (distractors.IsDefined() && distractors.IsScalar() && distractors.Scalar() == "random")
    root.remove("distractors");  // the same as not naming any
  ReadYaml(root, place, scenario);
  for (const auto& entry : root) given.insert(entry.first.Scalar());
}

YAML::Node ParseYaml(const std::string& text, const std::string& source) {
  try {
    return YAML::Load(text);
  } catch (const YAML::ParserException& error) {
    throw std::runtime_error(source + ":" + std::to_string(error.mark.line + 1) +
                             ": no valid YAML: " + error.msg);
  }
}

}  // namespace

Scenario ParseScenario(const std::string& text, const std::string& source,
                       const std::vector<std::string>& overrides) {
  Scenario scenario;
  std::set<std::string> given;
  const YAML::Node root = ParseYaml(text, source);
  Apply(root, source, scenario, given);
  for (const std::string& setting : overrides) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error("--set: got '" + setting + "', expected key=value");
    const std::string where = "--set " + setting;
    Apply(ParseYaml(setting.substr(0, equals) + ": " + setting.substr(equals + 1), where), where,
          scenario, given);
  }
  scenario = DrawScenario(given, scenario);
  try {
    scenario.Validate();
  } catch (const std::invalid_argument& error) {
    ThrowInvalid(root, {source, ""}, error.what());
  }
  return scenario;
}

Scenario LoadScenario(const std::filesystem::path& path,
                      const std::vector<std::string>& overrides) {
  std::ifstream stream(path);
  if (!stream || std::filesystem::is_directory(path))
    throw std::runtime_error(path.string() + ": got no such file, expected a scenario");
  std::ostringstream text;
  text << stream.rdbuf();
  return ParseScenario(text.str(), path.string(), overrides);
}

std::string DescribeScenario(const Scenario& scenario) {
  nlohmann::ordered_json json;
  Scenario copy = scenario;
  copy.Visit([&](const char* name, auto& value) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (IsOptional<Value>::value) {
      if (value) json[name] = *value;
    } else if constexpr (std::is_enum_v<Value>) {
      json[name] = std::string(EnumName(value));
    } else {
      json[name] = value;
    }
  });
  return json.dump();
}

}  // namespace fallen::sim
