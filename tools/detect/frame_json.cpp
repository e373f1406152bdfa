// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/detect/frame_json.hpp"

#include <nlohmann/json.hpp>

namespace fallen {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json ToJson(const OrientedBox& box) {
  return {{"center", ToJson(box.center)}, {"size", ToJson(box.size)}, {"yaw", box.yaw}};
}

Json ToJson(const PersonHypothesis& person) {
  return {{"centroid", ToJson(person.centroid)},
          {"probability", person.probability},
          {"distance", person.mahalanobis_distance},
          {"cells", person.cell_count},
          {"box", ToJson(person.box)}};
}

Json ToJson(const StageTimes& times) {
  return {{"ground", times.ground}, {"ndt", times.ndt},     {"background", times.background},
          {"iron", times.iron},     {"cells", times.cells}, {"clusters", times.clusters},
          {"total", times.total}};
}

Json ListPersons(const Decision& decision, ListedPersons listed) {
  Json persons = Json::array();
  for (const PersonHypothesis& hypothesis : decision.hypotheses) {
    if (listed == ListedPersons::kAccepted && !hypothesis.is_person) continue;
    Json person = ToJson(hypothesis);
    if (listed == ListedPersons::kAll) person["accepted"] = hypothesis.is_person;
    persons.push_back(std::move(person));
  }
  return persons;
}

Json ListAlarms(const std::vector<NumberedAlarm>& changes) {
  Json alarms = Json::array();
  for (const NumberedAlarm& numbered : changes) {
    const FallAlarm& alarm = numbered.alarm;
    alarms.push_back({{"event_id", alarm.id},
                      {"revision", alarm.revision},
                      {"event_type", EnumName(alarm.change)},
                      {"position", ToJson(alarm.position)},
                      {"box", ToJson(alarm.box)},
                      {"probability", alarm.probability},
                      {"views", alarm.views},
                      {"frames", alarm.frames}});
  }
  return alarms;
}

}  // namespace

std::string FrameJson(std::int64_t utime, std::int64_t index, const Decision& decision,
                      const StageTimes& milliseconds, ListedPersons listed,
                      const std::optional<std::vector<NumberedAlarm>>& alarms) {
  Json line = {{"utime", utime},
               {"frame", index},
               {"persons", ListPersons(decision, listed)},
               {"milliseconds", ToJson(milliseconds)}};
  if (alarms) line["alarms"] = ListAlarms(*alarms);
  return line.dump();
}

}  // namespace fallen
