// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/load_files.hpp"

#include <stdexcept>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/config_text.hpp"
#include "fallen/service/zone_file.hpp"

namespace fallen {
namespace {

void RequireCellSize(const std::string& file, double got_m, const Configuration& configuration) {
  const double expected_m = configuration.ndt.cell_size_m;
  if (got_m == expected_m) return;
  throw std::runtime_error(file + ": cell_size_m: got " + ConfigText(got_m) + ", expected " +
                           ConfigText(expected_m) + " (ndt.cell_size_m of the configuration)");
}

}  // namespace

Model LoadModelFor(const Configuration& configuration, const std::string& flag) {
  std::string file = flag.empty() ? configuration.files.model : flag;
  if (file.empty()) file = ShippedModelPath().string();
  Model model = LoadModel(file);
  RequireCellSize(file, model.cells.cell_size_m, configuration);
  return model;
}

BackgroundSubtractor LoadBackgroundFor(const Configuration& configuration,
                                       const std::string& flag) {
  const std::string& file = flag.empty() ? configuration.files.environment_map : flag;
  if (file.empty()) return BackgroundSubtractor(configuration.background);
  const EnvironmentMap environment = LoadEnvironmentMap(file);
  RequireCellSize(file, environment.cell_size_m, configuration);
  return BackgroundSubtractor(environment, configuration.background);
}

AlarmScope LoadAlarmScopeFor(const Configuration& configuration) {
  AlarmScope scope;
  scope.robot = configuration.service.robot;
  scope.has_fixed_cameras = configuration.ndt.without_pose == PoseMode::kFixedCamera;
  if (!configuration.files.zones.empty()) scope.zones = LoadZones(configuration.files.zones);
  return scope;
}

}  // namespace fallen
