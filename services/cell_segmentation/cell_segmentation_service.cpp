// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/cell_segmentation/cell_segmentation_service.hpp"

#include "fallen/messages/conversions.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

const CellModel& Validated(const CellModel& model) {
  model.Validate();
  return model;
}

}  // namespace

CellSegmentationService::CellSegmentationService(lcm::LCM& lcm, const StageOptions& options,
                                                 const CellModel& model,
                                                 const SegmentationConfig& config)
    : segmenter_(Validated(model), config), loop_(lcm, options) {
  loop_.Connect<ndt_map_t, clusters_t>(
      channels::Foreground(options.camera), channels::Clusters(options.camera),
      [this](const ndt_map_t& message) { return Segment(message); });
}

clusters_t CellSegmentationService::Segment(const ndt_map_t& message) {
  return ToMessage(FromMessage(message.header), segmenter_.Segment(ForegroundFromMessage(message)));
}

}  // namespace fallen
