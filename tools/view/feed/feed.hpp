// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/view/feed/frame_archive.hpp"
#include "tools/view/scene/cell_ages.hpp"
#include "tools/view/scene/scene.hpp"
#include "tools/view/scene/timeline.hpp"

namespace fallen {

/// What there is to be seen: a source puts in, sessions of browsers take out at their own pace.
///
/// Frames with their timeline, and topics: named messages of which only the newest counts (what is
/// being watched, the services, the alarms, the environment map). Thread-safe; nobody waits for
/// anybody but for the moment of a copy.
class Feed {
 public:
  using Bytes = std::vector<std::uint8_t>;

  struct Message {
    std::shared_ptr<const Bytes> bytes;
    bool is_text = false;
  };
  struct Topic {
    Message message;
    std::int64_t version = 0;  ///< grows with every change of any topic
  };

  /// @param max_entries  Of the timeline; the oldest go first.
  Feed(std::unique_ptr<FrameArchive> archive, std::size_t max_entries);

  /// Adds a frame. One whose time lies before the last one's starts a new timeline.
  /// @throws std::runtime_error if it cannot be kept.
  void Append(const Scene& scene);

  /// Sends {"type": "topic", "name": name, "value": value} to all, now and to those who come later.
  void SetTopic(const std::string& name, const nlohmann::json& value);
  void SetBinaryTopic(const std::string& name, Bytes bytes);

  /// `changed` is called after every change, in the thread that made it.
  void OnChange(std::function<void()> changed);

  /// Numbers of the frames that can be had: [first, count).
  struct Range {
    std::int64_t first = 0;
    std::int64_t count = 0;
  };
  Range frames() const;

  /// A frame; the nearest that is kept. @pre There is one.
  Message Frame(std::int64_t index) const;

  /// The timeline from frame `since` on, as {"type": "timeline", "first" (of the entries), "oldest"
  /// (known), "kept" (first frame that can be had), "entries"}; `since` becomes the number after
  /// the last. No message if there is nothing new.
  Message TimelineSince(std::int64_t& since) const;

  /// A topic that has changed since `version`, the longest unchanged first; no message if none has.
  Topic NextTopic(std::int64_t version) const;

 private:
  void Set(const std::string& name, Message message);
  void TellChange();

  mutable std::mutex mutex_;
  std::unique_ptr<FrameArchive> archive_;
  const std::size_t max_entries_;
  std::deque<TimelineEntry> timeline_;  // of the frames up to archive_->count()
  CellAges ages_;
  std::map<std::string, Topic> topics_;
  std::int64_t version_ = 0;
  std::function<void()> changed_;
};

}  // namespace fallen
