// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "fallen/classification/cluster_classification.hpp"
#include "fallen/detection/frame.hpp"
#include "fallen/geometry/oriented_box.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/segmentation/background_subtraction.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"

namespace fallen {

/// A frame as far as it is known: what the page draws. A stage that has not spoken left nothing.
struct Scene {
  Header header;
  std::optional<DepthImage> image;
  std::optional<ForegroundMap> map;  ///< all cells, floor and flags
  std::optional<SegmentedMap> segmented;
  std::optional<Decision> decision;
  std::optional<StageTimes> milliseconds;  ///< where the stages ran in this process
  std::optional<OrientedBox> truth;        ///< the lying person's box, world frame, if labelled
};

}  // namespace fallen
