// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "fallen/geometry/oriented_box.hpp"

namespace fallen {

/// Whose surface a cell is, according to the label images of a recording.
enum class CellLabel : std::uint8_t {
  kUnknown,  ///< nothing labelled there, or a voxel that the person shares with something else
  kPerson,   ///< of a fallen person
  kOther,    ///< of anything else
};

/// Collects the labelled points of a recording, to say which NDT cells are a fallen person's.
///
/// Guards: counts a voxel. Frames go in as they go into the map, so labels accumulate as it does.
class CellLabeller {
 public:
  explicit CellLabeller(double cell_size_m = 0.05) : cell_size_m_(cell_size_m) {}

  /// Adds a labelled image.
  /// @param labels        One value a pixel of `image`.
  /// @param person_label  The value of a fallen person, 0 if none is in the scene.
  /// @throws std::invalid_argument if the sizes disagree.
  void Add(const DepthImage& image, std::span<const std::uint8_t> labels, std::uint8_t person_label,
           const Eigen::Isometry3d& T_map_camera);

  /// Forgets everything: the map has started anew.
  void Reset() { votes_.clear(); }

  /// A label for each cell of `map`.
  std::vector<CellLabel> Label(const NdtMap& map) const;

 private:
  struct Votes {
    std::int32_t person = 0;
    std::int32_t other = 0;
  };
  std::int64_t Key(const Eigen::Vector3d& p) const;

  double cell_size_m_;
  std::unordered_map<std::int64_t, Votes> votes_;
};

/// The same from a box alone, for recordings without label images: cells in the box are the
/// person's, those within 0.1 m around it unknown (limbs and cells reach over the edges), all
/// others are of something else. So a box must hold the person and little else above the floor.
/// @param person_box  In the frame of `map`; nothing: no fallen person is there.
std::vector<CellLabel> LabelByBox(const NdtMap& map, const std::optional<OrientedBox>& person_box);

}  // namespace fallen
