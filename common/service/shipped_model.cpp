// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <system_error>

#include "fallen/service/configuration.hpp"
#include "fallen/service/shipped_file.hpp"

namespace fallen {
namespace {

constexpr char kInstalledModels[] = "share/fallen/models";
constexpr char kSourceModels[] = "models";
// build/<preset>/bin/<executable> is three folders below the source tree.
constexpr int kMaxFoldersUp = 4;

}  // namespace

std::filesystem::path ShippedFilePath(const std::string& name, const std::string& variable) {
  if (const char* wanted = std::getenv(variable.c_str()); wanted && *wanted) return wanted;
  std::error_code error;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed =
      executable.parent_path().parent_path() / kInstalledModels / name;
  if (std::filesystem::exists(installed, error)) return installed;
  std::filesystem::path folder = executable.parent_path();
  for (int i = 0; i < kMaxFoldersUp; ++i) {
    folder = folder.parent_path();
    const std::filesystem::path in_source = folder / kSourceModels / name;
    if (std::filesystem::exists(in_source, error)) return in_source;
  }
  return installed;
}

std::filesystem::path ShippedModelPath() { return ShippedFilePath("fallen.model", "FALLEN_MODEL"); }

}  // namespace fallen
