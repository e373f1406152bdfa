// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulate/scenario.hpp"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include "simulate/distractors.hpp"
#include "simulate/random.hpp"

namespace fallen::sim {
namespace {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class Enum>
std::string NamesOf() {
  std::string names;
  for (const auto& [value, name] : EnumNames(Enum{}))
    names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

template <class T>
std::string ExpectedOf() {
  if constexpr (std::is_enum_v<T>) return "one of " + NamesOf<T>();
  if constexpr (std::is_same_v<T, bool>) return "true or false";
  if constexpr (std::is_integral_v<T>) return "a whole number";
  if constexpr (std::is_floating_point_v<T>) return "a number";
  if constexpr (std::is_same_v<T, std::vector<std::string>>) return "random, or a list of kinds";
  return "text";
}

template <class T>
void Convert(const YAML::Node& node, T& value) {
  if constexpr (IsOptional<T>::value) {
    value.emplace();
    Convert(node, *value);
  } else if constexpr (std::is_enum_v<T>) {
    const auto found = EnumFromName<T>(node.as<std::string>());
    if (!found) throw YAML::BadConversion(node.Mark());
    value = *found;
  } else {
    value = node.as<T>();
  }
}

[[noreturn]] void Fail(const std::string& source, const YAML::Mark& mark, const std::string& what) {
  const std::string line = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
  throw std::runtime_error(source + line + ": " + what);
}

std::string TextOf(const YAML::Node& node) {
  return node.IsScalar() ? "'" + node.Scalar() + "'" : std::string("a list or map");
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
  if (open("room")) scenario.room = stream("room").Integer(1, 1000);
  if (open("clutter")) scenario.clutter = stream("clutter").Integer(0, 4);
  if (open("distractors")) {
    Random random = stream("distractors");
    for (int i = random.Integer(0, scenario.person ? 2 : 4); i > 0; --i)
      scenario.distractors.push_back(random.Pick(DistractorKinds()));
  }
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
  Require(frames > 0 && frames <= 100000, "frames", frames, "1 to 100000");
  Require(rate_hz > 0 && rate_hz <= 100, "rate_hz", rate_hz, "a number in (0, 100]");
  Require(max_speed_m_s >= 0 && max_speed_m_s <= 2, "max_speed_m_s", max_speed_m_s, "0 to 2");
  Require(width == 320 || width == 640, "width", width, "320 or 640");
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

Scenario ParseScenario(const std::string& text, const std::string& source,
                       const std::vector<std::string>& overrides) {
  Scenario scenario;
  std::set<std::string> given;
  const auto apply = [&](const std::string& where, const YAML::Node& root) {
    if (root.IsNull()) return;
    if (!root.IsMap())
      Fail(where, root.Mark(), "got " + TextOf(root) + ", expected keys and values");
    for (const auto& entry : root) {
      const auto key = entry.first.as<std::string>();
      const YAML::Node& node = entry.second;
      bool known = false;
      std::string keys;
      scenario.Visit([&](const char* name, auto& value) {
        keys += (keys.empty() ? "" : ", ") + std::string(name);
        if (key != name) return;
        known = true;
        using Value = std::remove_reference_t<decltype(value)>;
        try {
          if constexpr (std::is_same_v<Value, std::vector<std::string>>)
            if (node.IsScalar() && node.Scalar() == "random") return;  // as if not given
          Convert(node, value);
          given.insert(key);
        } catch (const YAML::Exception&) {
          if constexpr (IsOptional<Value>::value)
            Fail(where, node.Mark(), key + ": got " + TextOf(node) + ", expected a number");
          else
            Fail(where, node.Mark(),
                 key + ": got " + TextOf(node) + ", expected " + ExpectedOf<Value>());
        }
      });
      if (!known)
        Fail(where, entry.first.Mark(), key + ": got an unknown key, expected one of " + keys);
    }
  };
  const auto parse = [&](const std::string& where, const std::string& yaml) {
    try {
      return YAML::Load(yaml);
    } catch (const YAML::Exception& error) {
      Fail(where, error.mark, "got broken YAML (" + error.msg + "), expected keys and values");
    }
  };
  apply(source, parse(source, text));
  for (const std::string& override_text : overrides) {
    const std::size_t equals = override_text.find('=');
    if (equals == std::string::npos)
      throw std::runtime_error("--set: got '" + override_text + "', expected key=value");
    const std::string yaml =
        override_text.substr(0, equals) + ": " + override_text.substr(equals + 1);
    apply("--set", parse("--set", yaml));
  }
  scenario = DrawScenario(given, scenario);
  try {
    scenario.Validate();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(source + ": " + error.what());
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
