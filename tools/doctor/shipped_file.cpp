// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/shipped_file.hpp"

#include <filesystem>

namespace fallen {
namespace {

// build/<preset>/bin/<program> is three folders below the source tree, and a test may be one
// deeper.
constexpr int kMaxFoldersUp = 4;

}  // namespace

std::string FindShippedFile(const std::string& name) {
  std::error_code error;
  std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::filesystem::path installed = folder.parent_path() / "share/fallen" / name;
  if (std::filesystem::exists(installed, error)) return installed.string();
  for (int i = 0; i < kMaxFoldersUp; ++i) {
    folder = folder.parent_path();
    if (std::filesystem::exists(folder / name, error)) return (folder / name).string();
  }
  return "";
}

}  // namespace fallen
