// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/cell_segmentation/cell_segmentation_service.hpp"

#include <utility>

#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {

CellSegmentationService::CellSegmentationService(lcm::LCM& lcm, const StageOptions& options,
                                                 CellModel model, const SegmentationConfig& config)
    : model_(std::move(model)), config_(config), loop_(lcm, options) {
  model_.Validate();
  config_.Validate();
  loop_.Connect<ndt_map_t, clusters_t>(
      channels::Foreground(options.camera), channels::Clusters(options.camera),
      [this](const ndt_map_t& message) { return Segment(message); });
}

clusters_t CellSegmentationService::Segment(const ndt_map_t& message) const {
  const ForegroundMap foreground = ForegroundFromMessage(message);
  return ToMessage(FromMessage(message.header), SegmentCells(foreground, model_, config_));
}

}  // namespace fallen
