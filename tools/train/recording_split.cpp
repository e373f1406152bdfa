// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/recording_split.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace fallen {
namespace {

// Union-find over recordings.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t Root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void Join(std::size_t a, std::size_t b) { parent_[Root(a)] = Root(b); }

 private:
  std::vector<std::size_t> parent_;
};

void JoinEqual(const std::vector<RecordingOrigin>& recordings, std::string RecordingOrigin::*key,
               Groups& groups) {
  std::map<std::string, std::size_t> first;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    if ((recordings[i].*key).empty()) continue;
    const auto [entry, is_new] = first.emplace(recordings[i].*key, i);
    if (!is_new) groups.Join(i, entry->second);
  }
}

}  // namespace

RecordingSplit SplitByPersonAndRoom(const std::vector<RecordingOrigin>& recordings,
                                    double validation_share, std::uint64_t seed) {
  if (!(validation_share > 0 && validation_share < 1))
    throw std::invalid_argument("split: validation share is " + std::to_string(validation_share) +
                                ", must be in (0, 1)");
  Groups groups(recordings.size());
  JoinEqual(recordings, &RecordingOrigin::person, groups);
  JoinEqual(recordings, &RecordingOrigin::room, groups);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < recordings.size(); ++i) members[groups.Root(i)].push_back(i);
  if (members.size() < 2)
    throw std::invalid_argument(
        "split: all " + std::to_string(recordings.size()) +
        " recordings share persons or rooms, so no validation set without both can be split off; "
        "name one with --validation");

  std::vector<std::size_t> order;
  for (const auto& [root, indices] : members) order.push_back(root);
  // Fisher-Yates by hand: std::shuffle may differ between standard libraries.
  std::mt19937_64 random(seed);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);

  const double wanted = validation_share * static_cast<double>(recordings.size());
  RecordingSplit split;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_last = k + 1 == order.size();
    const bool to_validation = static_cast<double>(split.validation.size()) < wanted &&
                               !(is_last && split.training.empty());
    auto& side = to_validation ? split.validation : split.training;
    side.insert(side.end(), members[order[k]].begin(), members[order[k]].end());
  }
  std::sort(split.training.begin(), split.training.end());
  std::sort(split.validation.begin(), split.validation.end());
  return split;
}

void RequireDisjoint(const std::vector<RecordingOrigin>& training,
                     const std::vector<RecordingOrigin>& validation) {
  std::set<std::string> persons, rooms;
  for (const RecordingOrigin& recording : training) {
    persons.insert(recording.person);
    rooms.insert(recording.room);
  }
  for (const RecordingOrigin& recording : validation) {
    if (!recording.person.empty() && persons.contains(recording.person))
      throw std::invalid_argument(recording.log + ": person " + recording.person +
                                  " is in the training set too, expected an unseen one");
    if (!recording.room.empty() && rooms.contains(recording.room))
      throw std::invalid_argument(recording.log + ": room " + recording.room +
                                  " is in the training set too, expected an unseen one");
  }
}

}  // namespace fallen
