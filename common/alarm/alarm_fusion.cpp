// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/alarm_fusion.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "fallen/alarm/place_visibility.hpp"

namespace fallen {
namespace {

// A frame speaks for the time since the camera's frame before it, but not for a gap [s].
constexpr double kMaxFrameSeconds = 0.5;
constexpr double kFirstFrameSeconds = 0.1;
// Sums of microseconds as doubles.
constexpr double kTimeTolerance_s = 1e-6;
// The position is a running mean over the frames, the newest counting at least so much.
constexpr double kMinPositionGain = 0.1;
// A person who is found this far from where the last message said is worth another [m].
constexpr double kToldDistance_m = 0.25;
// Logits of probabilities that are 0 or 1 to within doubles.
constexpr double kMinProbability = 1e-12;

double Logit(double probability) {
  const double p = std::clamp(probability, kMinProbability, 1 - kMinProbability);
  return std::log(p / (1 - p));
}

double Logistic(double logit) { return 1 / (1 + std::exp(-logit)); }

std::string Iso8601(std::int64_t utime) {
  const std::time_t seconds = utime / 1'000'000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &utc);
  return text;
}

}  // namespace

/// What a frame is about, and for how long it speaks.
struct AlarmFusion::Seen {
  std::int64_t utime;
  const std::string& camera;
  const Decision& decision;
  double seconds;

  bool IsAbout(const Place& place) const {
    return place.alarm.frame == decision.frame &&
           (decision.frame == MapFrame::kWorld || place.owner == camera);
  }
};

AlarmFusion::AlarmFusion(const AlarmConfig& config, AlarmScope scope)
    : config_(config), scope_(std::move(scope)) {
  config_.Validate();
  for (const Zone& zone : scope_.zones) zone.Validate();
}

std::vector<FallAlarm> AlarmFusion::Add(std::int64_t utime, const std::string& camera,
                                        const Decision& decision) {
  const Seen seen{utime, camera, decision, SecondsSinceLast(camera, utime)};
  if (decision.frame != MapFrame::kWorld && !scope_.has_fixed_cameras) {
    ++frames_without_pose_;
    return {};
  }
  const std::vector<const PersonHypothesis*> persons = Match(Candidates(decision), seen);
  std::vector<FallAlarm> changes;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!seen.IsAbout(places_[i])) continue;
    Observe(places_[i], persons[i], seen);
    if (places_[i].unseen_s > 0) continue;
    if (auto change = Decide(places_[i], seen)) changes.push_back(std::move(*change));
  }
  ForgetPlaces();
  return changes;
}

double AlarmFusion::SecondsSinceLast(const std::string& camera, std::int64_t utime) {
  const auto [last, is_first] = last_utime_.try_emplace(camera, utime);
  if (is_first) return kFirstFrameSeconds;
  const double seconds = static_cast<double>(utime - last->second) * 1e-6;
  last->second = utime;
  return std::clamp(seconds, 0.0, kMaxFrameSeconds);
}

std::vector<const PersonHypothesis*> AlarmFusion::Candidates(const Decision& decision) const {
  std::vector<const PersonHypothesis*> candidates;
  for (const PersonHypothesis& person : decision.hypotheses) {
    const bool is_excluded =
        decision.frame == MapFrame::kWorld &&
        std::any_of(scope_.zones.begin(), scope_.zones.end(),
                    [&](const Zone& zone) { return zone.Excludes(person.centroid); });
    if (!is_excluded) candidates.push_back(&person);
  }
  return candidates;
}

/// The most probable cluster at each place, or none; clusters at no place that speak for a person
/// make one.
std::vector<const PersonHypothesis*> AlarmFusion::Match(
    const std::vector<const PersonHypothesis*>& candidates, const Seen& seen) {
  std::vector<const PersonHypothesis*> matched(places_.size(), nullptr);
  for (const PersonHypothesis* person : candidates) {  // best first
    std::optional<std::size_t> nearest;
    double nearest_m = config_.match_distance_m;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!seen.IsAbout(places_[i])) continue;
      const double distance_m = (places_[i].alarm.position - person->centroid).norm();
      if (distance_m > nearest_m) continue;
      nearest = i;
      nearest_m = distance_m;
    }
    if (nearest) {
      if (!matched[*nearest]) matched[*nearest] = person;
      continue;
    }
    if (person->probability <= config_.neutral_probability) continue;
    Place place;
    if (seen.decision.frame != MapFrame::kWorld) place.owner = seen.camera;
    place.alarm.frame = seen.decision.frame;
    place.alarm.position = person->centroid;
    place.alarm.box = person->box;
    place.alarm.first_utime = seen.utime;
    places_.push_back(std::move(place));
    matched.push_back(person);
  }
  return matched;
}

/// Adds what the frame says about a place, if it sees it.
void AlarmFusion::Observe(Place& place, const PersonHypothesis* person, const Seen& seen) {
  FallAlarm& alarm = place.alarm;
  const Decision& decision = seen.decision;
  // A source that does not tell what it saw is believed what it found, not what it missed.
  const auto is_seen = [&](const OrientedBox& box, bool if_unknown) {
    const std::optional<double> share =
        VisibleShare(decision.view, decision.T_map_camera, box, config_.visibility_margin_m);
    return share ? *share >= config_.min_visible_share : if_unknown;
  };
  // A cluster that the frame does not see is only remembered, and as good as not there.
  if (person && !is_seen(person->box, true)) person = nullptr;
  if (!person && !is_seen(alarm.box, false)) {
    place.unseen_s += seen.seconds;
    return;
  }
  place.unseen_s = 0;
  const double log_odds =
      person ? std::clamp(Logit(person->probability) - Logit(config_.neutral_probability),
                          -config_.max_log_odds, config_.max_log_odds)
             : config_.missing_log_odds;
  place.evidence.Add(log_odds, decision.T_map_camera.translation() - alarm.position, seen.seconds,
                     config_);
  alarm.probability = Logistic(place.evidence.log_odds());
  // Never fewer than before a restart, which forgets them.
  alarm.views = std::max(alarm.views, place.evidence.supporting_views());
  if (log_odds <= 0) return;
  alarm.camera = seen.camera;
  ++alarm.frames;
  alarm.position +=
      std::max(1.0 / alarm.frames, kMinPositionGain) * (person->centroid - alarm.position);
  if (person->probability <= alarm.best_probability) return;
  alarm.best_probability = person->probability;
  alarm.box = person->box;
}

std::optional<FallAlarm> AlarmFusion::Decide(Place& place, const Seen& seen) {
  const double log_odds = place.evidence.log_odds();
  const bool is_beyond =
      place.is_raised ? log_odds < config_.clear_log_odds : log_odds >= config_.raise_log_odds;
  const double delay_s = place.is_raised ? config_.off_delay_s : config_.on_delay_s;
  if (is_beyond && place.decided_s + kTimeTolerance_s >= delay_s) {
    place.decided_s = 0;
    if (place.is_raised) {
      place.alarm.cleared_utime = seen.utime;
      return Tell(place, AlarmChange::kCleared, seen.utime);
    }
    place.is_raised = true;
    place.alarm.id = NewId(seen.utime);
    place.alarm.raised_utime = seen.utime;
    return Tell(place, AlarmChange::kRaised, seen.utime);
  }
  place.decided_s = is_beyond ? place.decided_s + seen.seconds : 0;
  if (!place.is_raised || log_odds < config_.raise_log_odds) return std::nullopt;
  const double since_s =
      std::abs(static_cast<double>(seen.utime - place.alarm.change_utime)) * 1e-6;
  const bool is_news = place.alarm.views > place.told_views ||
                       (place.alarm.position - place.told_position).norm() > kToldDistance_m;
  if (!is_news || since_s < config_.update_interval_s) return std::nullopt;
  return Tell(place, AlarmChange::kUpdated, seen.utime);
}

FallAlarm AlarmFusion::Tell(Place& place, AlarmChange change, std::int64_t utime) {
  FallAlarm& alarm = place.alarm;
  if (change != AlarmChange::kRaised) ++alarm.revision;
  alarm.change = change;
  alarm.change_utime = utime;
  place.told_views = alarm.views;
  place.told_position = alarm.position;
  return alarm;
}

void AlarmFusion::ForgetPlaces() {
  const auto is_over = [&](const Place& place) {
    if (place.is_raised) return !place.alarm.is_active();
    if (place.unseen_s >= config_.forget_s) return true;
    if (place.evidence.log_odds() < std::min(0.0, config_.clear_log_odds)) return true;
    // Two that have grown together are one: the one that is raised, or was there first.
    for (const Place& other : places_) {
      if (&other == &place || other.alarm.frame != place.alarm.frame || other.owner != place.owner)
        continue;
      if ((other.alarm.position - place.alarm.position).norm() > config_.match_distance_m / 2)
        continue;
      if (other.is_raised || &other < &place) return true;
    }
    return false;
  };
  std::vector<Place> kept;
  for (const Place& place : places_)
    if (!is_over(place)) kept.push_back(place);
  places_ = std::move(kept);
}

std::string AlarmFusion::NewId(std::int64_t utime) {
  return scope_.robot + "-" + Iso8601(utime) + "-" + std::to_string(scope_.first_number++);
}

std::vector<FallAlarm> AlarmFusion::Acknowledge(const std::string& id, const std::string& by,
                                                std::int64_t utime) {
  std::vector<FallAlarm> changes;
  for (Place& place : places_) {
    if (!place.is_raised || place.alarm.is_acknowledged()) continue;
    if (!id.empty() && place.alarm.id != id) continue;
    place.alarm.acknowledged_utime = utime;
    place.alarm.acknowledged_by = by;
    changes.push_back(Tell(place, AlarmChange::kAcknowledged, utime));
  }
  return changes;
}

std::vector<FallAlarm> AlarmFusion::Close(const std::string& id, const std::string& by,
                                          std::int64_t utime) {
  std::vector<FallAlarm> changes;
  for (Place& place : places_) {
    if (!place.is_raised || (!id.empty() && place.alarm.id != id)) continue;
    place.alarm.cleared_utime = utime;
    place.alarm.cleared_by = by;
    changes.push_back(Tell(place, AlarmChange::kCleared, utime));
  }
  ForgetPlaces();
  return changes;
}

void AlarmFusion::Resume(const FallAlarm& alarm) {
  Place place;
  place.alarm = alarm;
  place.is_raised = true;
  if (alarm.frame != MapFrame::kWorld) place.owner = alarm.camera;
  place.told_views = alarm.views;
  place.told_position = alarm.position;
  places_.push_back(std::move(place));
}

std::vector<FallAlarm> AlarmFusion::Active() const {
  std::vector<FallAlarm> active;
  for (const Place& place : places_)
    if (place.is_raised) active.push_back(place.alarm);
  std::stable_sort(active.begin(), active.end(), [](const FallAlarm& a, const FallAlarm& b) {
    return a.raised_utime < b.raised_utime;
  });
  return active;
}

}  // namespace fallen
