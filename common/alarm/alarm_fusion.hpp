// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fallen/alarm/alarm_config.hpp"
#include "fallen/alarm/fall_alarm.hpp"
#include "fallen/alarm/place_evidence.hpp"
#include "fallen/alarm/zone.hpp"
#include "fallen/classification/cluster_classification.hpp"

namespace fallen {

/// Who and where the alarms are about.
struct AlarmScope {
  std::string robot = "robot";     ///< begins the alarms' ids
  std::int64_t first_number = 0;   ///< ends them; counts up, so that no id comes twice
  bool has_fixed_cameras = false;  ///< without a pose, a camera's frames are about one place
  std::vector<Zone> zones;         ///< in the world
};

/// From decisions about frames to alarms about falls: the paper leaves the decision over time open.
///
/// Follows places where somebody may lie, several at once, over frames, cameras and viewpoints.
/// What frames say about a place adds up as in PlaceEvidence; an alarm is raised when that
/// suffices, updated when the person is seen from another side, cleared when the place is seen
/// again and nobody is there. Clusters are in the local map, which remembers: a frame says
/// something only about places that it sees.
///
/// Deterministic: a function of the sequence of calls; times are those of the frames. Not
/// thread-safe.
class AlarmFusion {
 public:
  /// @throws std::invalid_argument if the configuration or a zone is out of range.
  AlarmFusion(const AlarmConfig& config, AlarmScope scope);

  /// Takes the decision about one frame of `camera`; returns what it changes.
  std::vector<FallAlarm> Add(std::int64_t utime, const std::string& camera,
                             const Decision& decision);

  /// Somebody takes notice of an alarm, or of all (empty id); returns those that were not yet.
  std::vector<FallAlarm> Acknowledge(const std::string& id, const std::string& by,
                                     std::int64_t utime);
  /// Somebody closes an alarm, or all (empty id).
  std::vector<FallAlarm> Close(const std::string& id, const std::string& by, std::int64_t utime);

  /// Goes on with an active alarm from before a restart.
  void Resume(const FallAlarm& alarm);

  /// Alarms that are not cleared, in the order in which they were raised.
  std::vector<FallAlarm> Active() const;

  /// Frames that could not be used: without a pose, of a camera that may move.
  std::int64_t frames_without_pose() const { return frames_without_pose_; }

 private:
  struct Place {
    std::string owner;  ///< camera whose frame it is in, "" for the world
    FallAlarm alarm;    ///< as of now; its change is the last one told
    bool is_raised = false;
    PlaceEvidence evidence;
    double decided_s = 0;         ///< for so long beyond the threshold that would change the alarm
    double unseen_s = 0;          ///< since it was last seen
    std::int32_t told_views = 0;  ///< at the last change
    Eigen::Vector3d told_position = Eigen::Vector3d::Zero();
  };
  struct Seen;

  double SecondsSinceLast(const std::string& camera, std::int64_t utime);
  std::vector<const PersonHypothesis*> Candidates(const Decision& decision) const;
  std::vector<const PersonHypothesis*> Match(const std::vector<const PersonHypothesis*>& candidates,
                                             const Seen& seen);
  void Observe(Place& place, const PersonHypothesis* person, const Seen& seen);
  std::optional<FallAlarm> Decide(Place& place, const Seen& seen);
  FallAlarm Tell(Place& place, AlarmChange change, std::int64_t utime);
  void ForgetPlaces();
  std::string NewId(std::int64_t utime);

  AlarmConfig config_;
  AlarmScope scope_;
  std::vector<Place> places_;
  std::map<std::string, std::int64_t> last_utime_;
  std::int64_t frames_without_pose_ = 0;
};

}  // namespace fallen
