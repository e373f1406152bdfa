// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/file_checks.hpp"

#include <exception>

#include "fallen/service/load_files.hpp"

namespace fallen {
namespace {

std::string Quoted(const std::string& path) { return "'" + path + "'"; }

Finding CheckModel(const Configuration& configuration) {
  const std::string check = "model";
  const std::string path =
      configuration.files.model.empty() ? ShippedModelPath().string() : configuration.files.model;
  try {
    LoadModelFor(configuration);
    return Good(check, path + " loads");
  } catch (const std::exception& error) {
    return {check, Verdict::kError, error.what(),
            "fallen-train RECORDING.lcm... -o " + Quoted(path)};
  }
}

Finding CheckEnvironmentMap(const Configuration& configuration) {
  const std::string check = "environment map";
  const std::string& path = configuration.files.environment_map;
  // Without one everything counts as foreground: more work and more false alarms, but no error.
  if (path.empty()) return Good(check, "none is configured, everything is foreground");
  try {
    LoadBackgroundFor(configuration);
    return Good(check, path + " loads");
  } catch (const std::exception& error) {
    return {check, Verdict::kError, error.what(), "fallen-map RECORDING.lcm -o " + Quoted(path)};
  }
}

}  // namespace

CheckedConfiguration CheckConfiguration(const std::optional<std::string>& file) {
  const std::string check = "configuration";
  try {
    return {LoadConfiguration(file), Good(check, file ? *file + " is valid" : "the defaults")};
  } catch (const std::exception& error) {
    return {Configuration(),
            {check, Verdict::kError, error.what(), "${EDITOR:-nano} " + Quoted(*file)}};
  }
}

std::vector<Finding> CheckFiles(const Configuration& configuration) {
  return {CheckModel(configuration), CheckEnvironmentMap(configuration)};
}

}  // namespace fallen
