// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "fallen/classification/calibration.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/segmentation/boosted_trees.hpp"
#include "fallen/trees_t.hpp"

/// Parts that the messages of several models share. Internal to this folder.
///
/// All throw std::invalid_argument for what could not be read; the parts' own Validate does the
/// rest.
namespace fallen {

trees_t TreesToMessage(const BoostedTrees& trees);
BoostedTrees TreesFromMessage(const std::string& field, const trees_t& message);

/// Sets the fields calibration_* and operating_point_* of a model's message.
template <class ModelMessage>
void CalibrationToMessage(const Calibration& calibration, ModelMessage& message) {
  message.calibration_slope = calibration.slope;
  message.calibration_intercept = calibration.intercept;
  for (const auto& point : calibration.operating_points) {
    message.operating_point_min_probability.push_back(point.min_probability);
    message.operating_point_false_positives_per_frame.push_back(point.false_positives_per_frame);
    message.operating_point_miss_rate.push_back(point.miss_rate);
  }
  message.operating_point_count = static_cast<std::int32_t>(calibration.operating_points.size());
}

/// @param owner  Name of the message, for error texts.
template <class ModelMessage>
Calibration CalibrationFromMessage(const std::string& owner, const ModelMessage& message) {
  const auto count = message.operating_point_count;
  for (const std::size_t elements : {message.operating_point_min_probability.size(),
                                     message.operating_point_false_positives_per_frame.size(),
                                     message.operating_point_miss_rate.size()})
    checks::Count(owner + ".operating_point_count", count, elements);
  Calibration calibration;
  calibration.slope = message.calibration_slope;
  calibration.intercept = message.calibration_intercept;
  for (std::int32_t i = 0; i < count; ++i)
    calibration.operating_points.push_back({message.operating_point_min_probability[i],
                                            message.operating_point_false_positives_per_frame[i],
                                            message.operating_point_miss_rate[i]});
  return calibration;
}

}  // namespace fallen
