// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include "fallen/geometry/enum_names.hpp"
#include "fallen/geometry/oriented_box.hpp"
#include "fallen/ndt/ndt_map.hpp"

namespace fallen {

/// What last happened to an alarm.
enum class AlarmChange : std::int8_t {
  kRaised = 0,
  kUpdated = 1,  ///< seen from another side, or elsewhere
  kAcknowledged = 2,
  kCleared = 3,  ///< the last: seen again without a person, or closed by somebody
};
constexpr auto EnumNames(AlarmChange) {
  return EnumTable<AlarmChange, 4>{{{AlarmChange::kRaised, "raised"},
                                    {AlarmChange::kUpdated, "updated"},
                                    {AlarmChange::kAcknowledged, "acknowledged"},
                                    {AlarmChange::kCleared, "cleared"}}};
}

/// One fall, as it is known after its last change.
struct FallAlarm {
  std::string id;             ///< the same for all changes, of no other fall ever
  std::int32_t revision = 0;  ///< 0 raised, one more with each change
  AlarmChange change = AlarmChange::kRaised;
  std::int64_t change_utime = 0;  ///< of the frame, or the acknowledgement, that made it [us]
  std::string camera;             ///< that took this frame; as before, for an acknowledgement

  std::int64_t first_utime = 0;         ///< first sign of the person [us]
  std::int64_t raised_utime = 0;        ///< [us]
  std::int64_t acknowledged_utime = 0;  ///< 0: not yet
  std::string acknowledged_by;
  std::int64_t cleared_utime = 0;  ///< 0: active
  std::string cleared_by;          ///< "": nobody was seen there any more

  MapFrame frame = MapFrame::kWorld;  ///< of position and box; not the world: that of `camera`
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the person's centroid [m]
  OrientedBox box;                                     ///< from the best view
  double probability = 0;                              ///< of all evidence together
  double best_probability = 0;                         ///< of the best single frame
  std::int32_t views = 0;                              ///< viewpoints that spoke for a person
  std::int32_t frames = 0;                             ///< frames that did

  bool is_active() const { return change != AlarmChange::kCleared; }
  bool is_acknowledged() const { return acknowledged_utime != 0; }
  bool operator==(const FallAlarm&) const = default;
};

}  // namespace fallen
