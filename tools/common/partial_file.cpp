// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/common/partial_file.hpp"

#include <unistd.h>

#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace fallen {

PartialFile::PartialFile(std::filesystem::path target) : target_(std::move(target)) {
  const std::filesystem::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(target_.string() + ": cannot be written: got no folder " +
                             folder.string() + ", expected one");
  if (std::filesystem::is_directory(target_))
    throw std::runtime_error(target_.string() + ": got a folder, expected a file to write");
  path_ = target_;
  if (std::filesystem::exists(target_) && !std::filesystem::is_regular_file(target_)) return;
  path_ += ".part" + std::to_string(getpid());
}

PartialFile::~PartialFile() {
  if (path_ == target_) return;
  std::error_code ignored;  // after Commit there is nothing to remove
  std::filesystem::remove(path_, ignored);
}

void PartialFile::Commit() {
  if (path_ == target_) return;
  std::error_code error;
  std::filesystem::rename(path_, target_, error);
  if (error) throw std::runtime_error(target_.string() + ": cannot be written: " + error.message());
}

}  // namespace fallen
