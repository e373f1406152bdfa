// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/scene_assembler.hpp"

#include <stdexcept>
#include <utility>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

/// A frame without a decision is given out when one so much newer is there [us].
constexpr std::int64_t kPatienceUs = 1'000'000;
/// So far back in time is no late message but a log that was started anew [us].
constexpr std::int64_t kRestartUs = 2'000'000;
/// Scenes that wait, at most: a second at 30 Hz.
constexpr std::size_t kMaxWaiting = 32;

template <class Message>
Message Decode(std::span<const std::uint8_t> bytes) {
  Decoded<Message> decoded = DecodeMessage<Message>(bytes);
  if (!decoded) throw std::invalid_argument(decoded.error);
  return std::move(*decoded.message);
}

ForegroundMap AllForeground(NdtMap map) {
  ForegroundMap foreground;
  foreground.is_foreground.assign(map.cells.size(), 1);
  foreground.map = std::move(map);
  return foreground;
}

}  // namespace

std::string AssembledChannels(const std::string& camera) {
  return "(DEPTH|NDT_MAP|FOREGROUND|CLUSTERS|FALLEN_PERSONS)_" + camera;
}

SceneAssembler::SceneAssembler(const std::string& camera, std::function<void(const Scene&)> emit)
    : emit_(std::move(emit)) {
  using Bytes = std::span<const std::uint8_t>;
  handlers_[channels::Depth(camera)] = [this](Bytes bytes) {
    StampedDepthImage depth = FromMessage(Decode<depth_image_t>(bytes));
    Add(depth.header, [&](Scene& scene) { scene.image = std::move(depth.image); });
  };
  handlers_[channels::NdtMap(camera)] = [this](Bytes bytes) {
    const auto message = Decode<ndt_map_t>(bytes);
    ForegroundMap map = AllForeground(NdtMapFromMessage(message));
    Add(FromMessage(message.header), [&](Scene& scene) {
      if (!scene.map) scene.map = std::move(map);  // else the subtraction has spoken
    });
  };
  handlers_[channels::Foreground(camera)] = [this](Bytes bytes) {
    const auto message = Decode<ndt_map_t>(bytes);
    ForegroundMap map = ForegroundFromMessage(message);
    Add(FromMessage(message.header), [&](Scene& scene) { scene.map = std::move(map); });
  };
  handlers_[channels::Clusters(camera)] = [this](Bytes bytes) {
    const auto message = Decode<clusters_t>(bytes);
    SegmentedMap segmented = FromMessage(message);
    Add(FromMessage(message.header), [&](Scene& scene) { scene.segmented = std::move(segmented); });
  };
  handlers_[channels::FallenPersons(camera)] = [this](Bytes bytes) {
    const auto message = Decode<fallen_persons_t>(bytes);
    Decision decision = FromMessage(message);
    Add(FromMessage(message.header), [&](Scene& scene) { scene.decision = std::move(decision); });
  };
}

void SceneAssembler::Take(const std::string& channel, std::span<const std::uint8_t> bytes) {
  const auto handler = handlers_.find(channel);
  if (handler != handlers_.end()) handler->second(bytes);
}

void SceneAssembler::Add(const Header& header, const std::function<void(Scene&)>& fill) {
  const std::int64_t utime = header.utime;
  if (emitted_utime_ && utime < *emitted_utime_ - kRestartUs) {
    waiting_.clear();
    emitted_utime_.reset();
  }
  if (emitted_utime_ && utime <= *emitted_utime_) return;
  Scene& scene = waiting_[utime];
  scene.header = header;
  fill(scene);
  if (scene.decision) return EmitUpTo(utime);
  EmitOverdue(waiting_.rbegin()->first);
}

void SceneAssembler::EmitUpTo(std::int64_t utime) {
  emit_(waiting_.at(utime));
  emitted_utime_ = utime;
  waiting_.erase(waiting_.begin(), waiting_.upper_bound(utime));
}

void SceneAssembler::EmitOverdue(std::int64_t newest_utime) {
  while (!waiting_.empty() &&
         (waiting_.begin()->first < newest_utime - kPatienceUs || waiting_.size() > kMaxWaiting))
    EmitUpTo(waiting_.begin()->first);
}

void SceneAssembler::Flush() {
  while (!waiting_.empty()) EmitUpTo(waiting_.begin()->first);
}

}  // namespace fallen
