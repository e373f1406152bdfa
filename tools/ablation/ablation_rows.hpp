// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/train/training_config.hpp"

namespace fallen {

/// What is known of a room beforehand.
enum class MapAge : std::int32_t {
  kNone = 0,   ///< nothing: no background subtraction
  kFresh = 1,  ///< an environment map of the room as it is
  kStale = 2,  ///< one from before a third of the furniture moved
};
constexpr auto EnumNames(MapAge) {
  return EnumTable<MapAge, 3>{
      {{MapAge::kNone, "none"}, {MapAge::kFresh, "fresh"}, {MapAge::kStale, "stale"}}};
}

/// One variant of the method.
struct AblationRow {
  std::string name;
  TrainingConfig training;          ///< what its model is trained with
  bool retrains = false;            ///< false: the model is the first row's
  SegmentationConfig segmentation;  ///< in use; the training's unless told
  MapAge map = MapAge::kNone;
  bool accumulate = true;  ///< false: each map is of one frame
  /// Descriptors tell the sides of surfaces apart, see NormalSigns: trained anew.
  bool oriented_normals = false;

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("name", name);
    visit("training", training);
    visit("segmentation", segmentation);
    visit("map", map);
    visit("accumulate", accumulate);
    visit("oriented_normals", oriented_normals);
  }

  /// All settings as text: a finished row with the same text need not be measured again.
  std::string Settings() const;
};

/// Reads the rows: `training:`, settings of all of them over `base`, and `rows:`, a list of maps
/// with a `name` and what differs (keys of AblationRow). Only rows with `training:` or
/// `oriented_normals: true` are trained.
/// @throws std::runtime_error naming file, line, got and expected: also for two rows of one name,
/// for rows that want other `observation` settings, which all share, and for a first row with
/// oriented normals, whose model could not be kept.
std::vector<AblationRow> LoadAblationRows(const std::filesystem::path& file,
                                          const TrainingConfig& base);

}  // namespace fallen
