// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/fall_alarm/snapshot_keeper.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "fallen/messages/log_file.hpp"
#include "fallen/messages/log_format.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

constexpr char kChannels[] = "(DEPTH|FOREGROUND|FALLEN_PERSONS)_.*|ROBOT_POSE";
// Both header_t and pose_t begin with utime, after the hash.
constexpr std::size_t kUtimeOffset = 8;

}  // namespace

SnapshotKeeper::SnapshotKeeper(lcm::LCM& lcm, std::size_t max_bytes)
    : lcm_(lcm), max_bytes_(max_bytes) {
  subscription_ = lcm_.subscribe(kChannels, &SnapshotKeeper::Receive, this);
  if (!subscription_) throw std::runtime_error(std::string("LCM cannot subscribe to ") + kChannels);
  subscription_->setQueueCapacity(0);
}

SnapshotKeeper::~SnapshotKeeper() { lcm_.unsubscribe(subscription_); }

void SnapshotKeeper::Receive(const lcm::ReceiveBuffer* buffer,
                             const std::string& channel) noexcept {
  if (buffer->data_size < kUtimeOffset + sizeof(std::int64_t) || buffer->data_size > max_bytes_)
    return;
  const auto* bytes = static_cast<const std::uint8_t*>(buffer->data);
  try {
    const std::lock_guard lock(mutex_);
    const auto utime =
        static_cast<std::int64_t>(log_format::ReadBigEndian<std::uint64_t>(bytes + kUtimeOffset));
    messages_.push_back({channel, utime, {bytes, bytes + buffer->data_size}});
    bytes_ += buffer->data_size;
    while (bytes_ > max_bytes_) {
      bytes_ -= messages_.front().bytes.size();
      messages_.pop_front();
    }
  } catch (const std::exception&) {  // out of memory: the alarm goes on without this message
  }
}

std::optional<AlarmSnapshot> SnapshotKeeper::Take(const std::string& camera,
                                                  std::int64_t utime) const {
  const std::lock_guard lock(mutex_);
  const auto newest = [&](const std::string& channel, bool is_exact) -> const Message* {
    const auto found = std::find_if(messages_.rbegin(), messages_.rend(), [&](const Message& m) {
      return m.channel == channel && (is_exact ? m.utime == utime : m.utime <= utime);
    });
    return found == messages_.rend() ? nullptr : &*found;
  };
  AlarmSnapshot snapshot;
  snapshot.utime = utime;
  std::int64_t number = 0;
  bool has_frame = false;
  for (const auto& [channel, is_exact] : {std::pair{std::string(channels::kRobotPose), false},
                                          {channels::Depth(camera), true},
                                          {channels::Foreground(camera), true},
                                          {channels::FallenPersons(camera), true}}) {
    const Message* message = newest(channel, is_exact);
    if (!message) continue;
    const auto event = EncodeLogEvent({number++, utime, channel, message->bytes});
    snapshot.log.insert(snapshot.log.end(), event.begin(), event.end());
    has_frame = has_frame || is_exact;
  }
  if (!has_frame) return std::nullopt;
  return snapshot;
}

}  // namespace fallen
