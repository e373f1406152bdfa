// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/feed.hpp"

#include <algorithm>
#include <utility>

#include "tools/view/scene/scene_message.hpp"

namespace fallen {
namespace {

Feed::Message TextMessage(const nlohmann::json& json) {
  const std::string text = json.dump();
  return {std::make_shared<const Feed::Bytes>(text.begin(), text.end()), true};
}

}  // namespace

Feed::Feed(std::unique_ptr<FrameArchive> archive, std::size_t max_entries)
    : archive_(std::move(archive)), max_entries_(max_entries) {}

void Feed::Append(const Scene& scene) {
  // Only this thread appends, so the number stays right while others read.
  const std::int64_t index = frames().count;
  auto bytes = std::make_shared<const Bytes>(SceneToMessage(scene, index, ages_));
  const TimelineEntry entry = ToTimelineEntry(scene);
  {
    const std::lock_guard lock(mutex_);
    archive_->Append(std::move(bytes));
    if (!timeline_.empty() && entry.utime < timeline_.back().utime) timeline_.clear();
    timeline_.push_back(entry);
    if (timeline_.size() > max_entries_) timeline_.pop_front();
  }
  TellChange();
}

void Feed::SetTopic(const std::string& name, const nlohmann::json& value) {
  Set(name, TextMessage({{"type", "topic"}, {"name", name}, {"value", value}}));
}

void Feed::SetBinaryTopic(const std::string& name, Bytes bytes) {
  Set(name, {std::make_shared<const Bytes>(std::move(bytes)), false});
}

void Feed::Set(const std::string& name, Message message) {
  {
    const std::lock_guard lock(mutex_);
    topics_[name] = {std::move(message), ++version_};
  }
  TellChange();
}

void Feed::OnChange(std::function<void()> changed) {
  const std::lock_guard lock(mutex_);
  changed_ = std::move(changed);
}

void Feed::TellChange() {
  std::function<void()> changed;
  {
    const std::lock_guard lock(mutex_);
    changed = changed_;
  }
  if (changed) changed();
}

Feed::Range Feed::frames() const {
  const std::lock_guard lock(mutex_);
  return {archive_->first(), archive_->count()};
}

Feed::Message Feed::Frame(std::int64_t index) const {
  const std::lock_guard lock(mutex_);
  return {archive_->Read(std::clamp(index, archive_->first(), archive_->count() - 1)), false};
}

Feed::Message Feed::TimelineSince(std::int64_t& since) const {
  const std::lock_guard lock(mutex_);
  const std::int64_t count = archive_->count();
  if (since >= count) return {};
  const std::int64_t first_known = count - static_cast<std::int64_t>(timeline_.size());
  const std::int64_t first = std::max(since, first_known);
  nlohmann::json entries = nlohmann::json::array();
  for (auto entry = timeline_.begin() + (first - first_known); entry != timeline_.end(); ++entry)
    entries.push_back(ToJson(*entry));
  since = count;
  return TextMessage({{"type", "timeline"},
                      {"first", first},
                      {"oldest", first_known},
                      {"kept", archive_->first()},
                      {"entries", std::move(entries)}});
}

Feed::Topic Feed::NextTopic(std::int64_t version) const {
  const std::lock_guard lock(mutex_);
  Topic next;
  for (const auto& [name, topic] : topics_)
    if (topic.version > version && (!next.message.bytes || topic.version < next.version))
      next = topic;
  return next;
}

}  // namespace fallen
