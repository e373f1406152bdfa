// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "fallen/detection/detector.hpp"
#include "fallen/evaluation/cell_labels.hpp"
#include "tools/train/recording_split.hpp"

namespace fallen {

/// A frame as training sees it: the map, and what is a fallen person in it.
struct ObservedFrame {
  NdtMap map;
  /// One a cell, by the label image or else by the box; empty if there is a box but no pose that
  /// would say where in the map it is.
  std::vector<CellLabel> labels;
  std::optional<OrientedBox> person_box;  ///< map frame
  int cells_in_box = 0;

  /// True if the paper's protocol counts a fallen person as present.
  bool is_positive() const;
};

/// Nothing but the fallen person of a frame, as if alone in the world (the paper, Sec. IV-A): the
/// cells that are labelled so, none if nothing is labelled.
ObservedFrame IsolatePerson(const ObservedFrame& frame);

/// One recording, mapped.
struct ObservedRecording {
  RecordingOrigin origin;
  std::vector<ObservedFrame> frames;
  std::int64_t damaged = 0;  ///< messages that could not be read
};

struct ObservationConfig {
  int frame_stride = 2;         ///< every so many frames are kept, all go into the map
  int single_frame_stride = 8;  ///< every so many are kept once more as a map of their own; 0: none

  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("frame_stride", frame_stride);
    visit("single_frame_stride", single_frame_stride);
  }
};

/// Maps a log with ground truth, as the mapping service would.
/// @throws std::runtime_error if the log cannot be read or holds no frame with ground truth.
ObservedRecording ObserveRecording(const std::filesystem::path& log, const GroundConfig& ground,
                                   const NdtConfig& ndt, const ObservationConfig& config);

}  // namespace fallen
