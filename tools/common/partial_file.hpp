// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace fallen {

/// A file that appears under its name only once it is complete; what was there before stays until
/// then, and nothing is left behind if writing fails. A target that is no regular file (a device, a
/// pipe) is written directly.
class PartialFile {
 public:
  /// @throws std::runtime_error if `target` lies in no directory.
  explicit PartialFile(std::filesystem::path target);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  /// Where to write: beside the target.
  const std::filesystem::path& path() const { return path_; }

  /// Gives the file its name. @throws std::runtime_error if that fails.
  void Commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
};

}  // namespace fallen
