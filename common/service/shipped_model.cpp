// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <system_error>

#include "fallen/service/configuration.hpp"

namespace fallen {
namespace {

constexpr char kInstalledModel[] = "share/fallen/models/fallen.model";
constexpr char kSourceModel[] = "models/fallen.model";
// build/<preset>/bin/<executable> is three folders below the source tree.
constexpr int kMaxFoldersUp = 4;

}  // namespace

std::filesystem::path ShippedModelPath() {
  if (const char* wanted = std::getenv("FALLEN_MODEL"); wanted && *wanted) return wanted;
  std::error_code error;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed = executable.parent_path().parent_path() / kInstalledModel;
  if (std::filesystem::exists(installed, error)) return installed;
  std::filesystem::path folder = executable.parent_path();
  for (int i = 0; i < kMaxFoldersUp; ++i) {
    folder = folder.parent_path();
    if (std::filesystem::exists(folder / kSourceModel, error)) return folder / kSourceModel;
  }
  return installed;
}

}  // namespace fallen
