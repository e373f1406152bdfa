// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/build_map.hpp"

#include <memory>
#include <stdexcept>

#include "fallen/messages/model_files.hpp"
#include "fallen/service/configuration.hpp"
#include "tools/map/cloud_file.hpp"
#include "tools/map/environment_builder.hpp"
#include "tools/map/map_recording.hpp"

namespace fallen {
namespace {

EnvironmentBuilderConfig BuilderConfig(const NdtConfig& ndt) {
  EnvironmentBuilderConfig config;
  config.cell_size_m = ndt.cell_size_m;
  config.min_points = ndt.min_points;
  config.min_eigenvalue_ratio = ndt.min_eigenvalue_ratio;
  return config;
}

/// Points on the floor are left out, as the maps that this one is compared with are free of it, and
/// so are those above what these maps hold.
void AddCloud(const std::filesystem::path& file, const NdtConfig& ndt, EnvironmentBuilder& builder,
              BuildMapReport& report) {
  std::int64_t used = 0;
  for (const Eigen::Vector3d& p_world : ReadCloud(file)) {
    if (p_world.z() < ndt.ground_clearance_m || p_world.z() > ndt.max_height_m) continue;
    builder.AddPoint(p_world);
    ++used;
  }
  if (used == 0)
    throw std::runtime_error(file.string() + ": got no point between " +
                             std::to_string(ndt.ground_clearance_m) + " m and " +
                             std::to_string(ndt.max_height_m) +
                             " m above z = 0, expected a cloud with z up and the floor at 0");
  report.points += used;
}

void AddRecording(const std::filesystem::path& input, const Configuration& config,
                  const std::optional<std::string>& camera, EnvironmentBuilder& builder,
                  BuildMapReport& report) {
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(input, camera);
  const RecordingMap map = MapRecording(*recording, config.ground, config.ndt, input.string());
  builder.AddCells(map.cells);
  report.frames += map.frames;
  report.frames_without_pose += map.without_pose;
  report.damaged += map.damaged;
}

std::string Describe(const BuildMapOptions& options) {
  if (options.description) return *options.description;
  std::string text;
  for (const std::filesystem::path& input : options.inputs) {
    const std::filesystem::path name =
        input.has_filename() ? input.filename() : input.parent_path().filename();
    text += (text.empty() ? "" : ", ") + name.string();
  }
  return text;
}

}  // namespace

BuildMapReport BuildMap(const BuildMapOptions& options) {
  Configuration config = LoadConfiguration(options.config);
  if (options.cell_size_m) config.ndt.cell_size_m = *options.cell_size_m;
  config.ndt.Validate();

  EnvironmentBuilder builder(BuilderConfig(config.ndt));
  BuildMapReport report;
  for (const std::filesystem::path& input : options.inputs) {
    if (IsCloudFile(input))
      AddCloud(input, config.ndt, builder, report);
    else
      AddRecording(input, config, options.camera, builder, report);
  }
  const EnvironmentMap map = builder.Build();
  if (map.cells.empty())
    throw std::runtime_error(options.inputs.back().string() +
                             ": got no cell from the inputs, expected at least one");
  report.cells = map.cells.size();
  SaveEnvironmentMap(options.output, map, Describe(options));
  return report;
}

}  // namespace fallen
