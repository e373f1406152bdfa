// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/baseline_files.hpp"

#include "fallen/messages/classifier_conversion.hpp"
#include "fallen/messages/message_file.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

constexpr ContainerKind kBaselineModelFile{"FALLENBM", "a baseline model file", 1};
const std::string kBaselineModel = "baseline_model_t";

}  // namespace

baseline_model_t ToMessage(const BaselineModel& model) {
  model.Validate();
  baseline_model_t message{};
  message.description = model.description;
  checks::CheckText(kBaselineModel + ".description", message.description, limits::kMaxTextBytes);
  message.max_range_m = model.config.max_range_m;
  message.ground_clearance_m = model.config.ground_clearance_m;
  message.ground_clearance_per_sq_m = model.config.ground_clearance_per_sq_m;
  message.max_height_m = model.config.max_height_m;
  message.leaf_m = model.config.leaf_m;
  message.normal_radius_m = model.config.normal_radius_m;
  message.cluster_tolerance_m = model.config.cluster_tolerance_m;
  message.min_cluster_points = model.config.min_cluster_points;
  message.layers = model.config.layers;
  message.layer_height_m = model.config.layer_height_m;
  message.normal_bins = model.config.normal_bins;
  message.trees = TreesToMessage(model.trees);
  CalibrationToMessage(model.calibration, message);
  return message;
}

BaselineModel FromMessage(const baseline_model_t& message) {
  BaselineModel model;
  checks::CheckText(kBaselineModel + ".description", message.description, limits::kMaxTextBytes);
  model.description = message.description;
  model.config.max_range_m = message.max_range_m;
  model.config.ground_clearance_m = message.ground_clearance_m;
  model.config.ground_clearance_per_sq_m = message.ground_clearance_per_sq_m;
  model.config.max_height_m = message.max_height_m;
  model.config.leaf_m = message.leaf_m;
  model.config.normal_radius_m = message.normal_radius_m;
  model.config.cluster_tolerance_m = message.cluster_tolerance_m;
  model.config.min_cluster_points = message.min_cluster_points;
  model.config.layers = message.layers;
  model.config.layer_height_m = message.layer_height_m;
  model.config.normal_bins = message.normal_bins;
  model.trees = TreesFromMessage(kBaselineModel + ".trees", message.trees);
  model.calibration = CalibrationFromMessage(kBaselineModel, message);
  model.Validate();
  return model;
}

BaselineModel LoadBaselineModel(const std::filesystem::path& path) {
  return LoadMessageFile<baseline_model_t>(path, kBaselineModelFile);
}

void SaveBaselineModel(const std::filesystem::path& path, const BaselineModel& model) {
  WriteContainer(path, kBaselineModelFile, EncodeMessage(ToMessage(model)));
}

}  // namespace fallen
