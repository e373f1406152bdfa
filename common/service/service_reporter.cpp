// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/service_reporter.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "fallen/service/channels.hpp"
#include "fallen/service/version.hpp"

namespace fallen {
namespace {

constexpr std::chrono::seconds kStatusInterval{1};
constexpr double kTailShare = 0.99;
// Names come from messages: more than these are not kept apart, and not counted.
constexpr std::size_t kMaxCameras = 64;

std::string StateName(ServiceState state) {
  switch (state) {
    case ServiceState::kStarting:
      return "starting";
    case ServiceState::kRunning:
      return "running";
    case ServiceState::kDegraded:
      return "degraded";
    case ServiceState::kLost:
      return "lost";
    case ServiceState::kStopping:
      return "stopping";
  }
  return "unknown";
}

}  // namespace

std::int64_t ResidentBytes() {
  std::ifstream file("/proc/self/statm");
  std::int64_t size_pages = 0;
  std::int64_t resident_pages = 0;
  if (!(file >> size_pages >> resident_pages)) return 0;
  return resident_pages * sysconf(_SC_PAGESIZE);
}

ServiceReporter::ServiceReporter(lcm::LCM& lcm, const std::string& service,
                                 const std::string& camera)
    : lcm_(lcm), status_channel_(channels::Status(service)) {
  state_ = ServiceState::kRunning;  // shows as STARTING until something happens
  counts_.service = service;
  counts_.version = Version();
  counts_.pid = getpid();
  counts_.header.sensor_name = camera;
}

void ServiceReporter::CountReceived(std::int64_t utime, std::int64_t seq,
                                    const std::string& camera) {
  const std::lock_guard lock(mutex_);
  ++counts_.received;
  counts_.header.utime = utime;
  if (!gaps_.contains(camera) && gaps_.size() >= kMaxCameras) return;
  SequenceGaps& gaps = gaps_[camera];
  const std::int64_t missing_before = gaps.missing();
  gaps.Add(seq);
  missing_ += gaps.missing() - missing_before;
  // A damaged message leaves a gap in seq as well, but it did arrive.
  const std::int64_t gap = std::max<std::int64_t>(gaps.missing() - missing_before, 0);
  damaged_in_gaps_ += std::min(gap, damaged_since_received_);
  damaged_since_received_ = 0;
}

void ServiceReporter::CountDamaged(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  ++counts_.dropped_damaged;
  newest_damage_ = reason;
  is_newest_damaged_ = true;
  warnings_.Warn("damaged", "dropped: " + reason);
}

void ServiceReporter::CountDamagedFrame(const std::string& reason) {
  CountDamaged(reason);
  const std::lock_guard lock(mutex_);
  ++damaged_since_received_;
}

void ServiceReporter::CountLate(std::int64_t frames, const std::string& reason) {
  if (frames == 0) return;
  const std::lock_guard lock(mutex_);
  counts_.dropped_late += frames;
  warnings_.Warn("late", reason);
}

void ServiceReporter::CountSkipped() {
  const std::lock_guard lock(mutex_);
  ++counts_.skipped;
}

bool ServiceReporter::Publish(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return false;
  const std::lock_guard lock(publish_mutex_);
  return lcm_.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size())) == 0;
}

void ServiceReporter::CountPublished(bool sent, double milliseconds) {
  const std::lock_guard lock(mutex_);
  if (!sent) return warnings_.Warn("publish", "a result could not be sent");
  ++counts_.published;
  is_newest_damaged_ = false;
  timing_.Add(milliseconds, Clock::now());
}

void ServiceReporter::SetState(ServiceState state, const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (state == state_ && text == text_) return;
  state_ = state;
  text_ = text;
  // A state that comes and goes with the frames (no floor in view) must not fill the log.
  const std::string line = StateName(state) + (text.empty() ? "" : ": " + text);
  const std::string due = warnings_.Note("state " + line, line, Clock::now());
  if (!due.empty()) LogInfo(due);
}

service_status_t ServiceReporter::Status() const {
  const std::lock_guard lock(mutex_);
  service_status_t status = counts_;
  const bool is_idle = counts_.received == 0 && counts_.published == 0;
  ServiceState state = state_;
  if (state == ServiceState::kRunning && is_idle) state = ServiceState::kStarting;
  if (state == ServiceState::kRunning && is_newest_damaged_) state = ServiceState::kDegraded;
  status.state = static_cast<std::int8_t>(state);
  status.text = text_;
  if (!newest_damage_.empty())
    status.text += (text_.empty() ? "dropped: " : "; dropped: ") + newest_damage_;
  status.lost_upstream = missing_ - damaged_in_gaps_;
  status.rate_hz = timing_.RateHz(Clock::now());
  status.median_ms = timing_.Quantile(0.5);
  status.p99_ms = timing_.Quantile(kTailShare);
  status.resident_bytes = ResidentBytes();
  return status;
}

void ServiceReporter::PublishStatus() {
  const service_status_t status = Status();
  Publish(status_channel_, EncodeMessage(status));
  const std::lock_guard lock(mutex_);
  ++counts_.header.seq;
}

std::chrono::milliseconds ServiceReporter::PublishStatusIfDue() {
  const Clock::time_point now = Clock::now();
  if (now >= next_status_) {
    PublishStatus();
    next_status_ = now + kStatusInterval;
  }
  return std::chrono::ceil<std::chrono::milliseconds>(next_status_ - now);
}

}  // namespace fallen
