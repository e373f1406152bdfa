// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/fall_alarm_service.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "fallen/service/channels.hpp"
#include "fallen/service/logging.hpp"

namespace fallen {
namespace {

// Times that a cleared alarm is repeated: LCM may lose a message, but hardly five in a row.
constexpr int kClearedRepetitions = 5;

/// Every decision counts, and takes microseconds: none is dropped for a newer one.
StageOptions EveryFrame(StageOptions options) {
  options.lossless = true;
  return options;
}

AlarmScope WithNextNumber(AlarmScope scope, const AlarmHistory& history) {
  scope.first_number = history.NextNumber();
  return scope;
}

}  // namespace

FallAlarmService::FallAlarmService(lcm::LCM& lcm, const StageOptions& options, FallAlarmSetup setup,
                                   AlarmHistory& history)
    : setup_(std::move(setup)),
      history_(history),
      fusion_(setup_.config, WithNextNumber(setup_.scope, history)),
      loop_(lcm, EveryFrame(options)) {
  if (setup_.has_snapshots) snapshots_ = std::make_unique<SnapshotKeeper>(lcm);
  for (const NumberedAlarm& active : history_.Active()) {
    fusion_.Resume(active.alarm);
    told_[active.alarm.id] = {ToMessage(active)};
    newest_utime_ = std::max(newest_utime_, active.alarm.change_utime);
  }
  loop_.OnFrame<fallen_persons_t>(
      channels::FallenPersons(setup_.camera.empty() ? ".*" : setup_.camera),
      [this](const fallen_persons_t& message) { Decide(message); });
  loop_.OnMessage<fall_alarm_ack_t>(
      channels::kFallAlarmAck,
      [this](const fall_alarm_ack_t& message) { Obey(FromMessage(message)); });
  loop_.OnEverySecond([this] { EverySecond(); });
  UpdateState();
}

void FallAlarmService::Decide(const fallen_persons_t& message) {
  const Header header = FromMessage(message.header);
  const Decision decision = FromMessage(message);
  newest_utime_ = std::max<std::int64_t>(header.utime, 1);
  Tell(fusion_.Add(header.utime, header.sensor_name, decision));
}

void FallAlarmService::Obey(AlarmAnswer answer) {
  if (answer.utime == 0) answer.utime = newest_utime_;
  Tell(answer.closes ? fusion_.Close(answer.event_id, answer.by, answer.utime)
                     : fusion_.Acknowledge(answer.event_id, answer.by, answer.utime));
}

void FallAlarmService::Answer(const AlarmAnswer& answer) {
  loop_.Post([this, answer] { Obey(FromMessage(ToMessage(answer))); });
}

void FallAlarmService::Tell(const std::vector<FallAlarm>& changes) {
  for (const FallAlarm& change : changes) {
    // In order: what could not be recorded before comes first.
    const std::int64_t number = unrecorded_.empty() ? Record(change) : 0;
    if (number == 0) unrecorded_.push_back(change);
    Send(change, number);
    LogInfo("alarm " + change.id + " " + std::string(EnumName(change.change)));
  }
  if (!changes.empty()) UpdateState();
}

void FallAlarmService::Send(const FallAlarm& change, std::int64_t number) {
  Told& told = told_[change.id];
  told = {ToMessage(NumberedAlarm{setup_.scope.robot, number, change})};
  loop_.Publish(channels::kFallAlarm, told.message);
}

std::int64_t FallAlarmService::Record(const FallAlarm& change) {
  try {
    std::optional<AlarmSnapshot> snapshot;
    const bool is_seen =
        change.change == AlarmChange::kRaised || change.change == AlarmChange::kUpdated;
    if (snapshots_ && is_seen) snapshot = snapshots_->Take(change.camera, change.change_utime);
    const std::int64_t number = history_.Record(setup_.scope.robot, change, snapshot);
    if (!setup_.has_broker) history_.MarkSent(number);
    history_trouble_.clear();
    return number;
  } catch (const std::exception& error) {
    history_trouble_ = error.what();
    return 0;
  }
}

void FallAlarmService::EverySecond() {
  while (!unrecorded_.empty()) {
    const std::int64_t number = Record(unrecorded_.front());
    if (number == 0) break;
    const auto told = told_.find(unrecorded_.front().id);
    if (told != told_.end() && told->second.message.revision == unrecorded_.front().revision)
      told->second.message.header.seq = number;
    unrecorded_.erase(unrecorded_.begin());
  }
  for (auto told = told_.begin(); told != told_.end();) {
    loop_.reporter().Publish(channels::kFallAlarm, EncodeMessage(told->second.message));
    const bool is_over = told->second.message.change == fall_alarm_t::CLEARED &&
                         ++told->second.repetitions >= kClearedRepetitions;
    told = is_over ? told_.erase(told) : std::next(told);
  }
  UpdateState();
}

void FallAlarmService::SetBrokerTrouble(const std::string& trouble) {
  {
    const std::lock_guard lock(broker_mutex_);
    broker_trouble_ = trouble;
  }
  loop_.Post([this] { UpdateState(); });
}

void FallAlarmService::UpdateState() {
  std::string broker_trouble;
  {
    const std::lock_guard lock(broker_mutex_);
    broker_trouble = broker_trouble_;
  }
  const std::int64_t without_pose = fusion_.frames_without_pose();
  const bool lacks_pose = without_pose > std::exchange(seen_without_pose_, without_pose);
  std::string text;
  for (const std::string& part :
       {lacks_pose ? std::string("frames without a pose say nothing: see ndt.without_pose")
                   : std::string(),
        setup_.history_note, history_trouble_, broker_trouble})
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  loop_.reporter().SetState(text.empty() ? ServiceState::kRunning : ServiceState::kDegraded, text);
}

}  // namespace fallen
