// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "tools/view/feed/frame_archive.hpp"

namespace fallen {

/// All frames of a recording, compressed, in a file without a name that goes with the process.
class FileArchive : public FrameArchive {
 public:
  /// @param folder  Where there is room: about 100 KB a frame.
  /// @throws std::runtime_error if no file can be made there.
  explicit FileArchive(const std::filesystem::path& folder);
  ~FileArchive() override;
  FileArchive(const FileArchive&) = delete;
  FileArchive& operator=(const FileArchive&) = delete;

  /// @throws std::runtime_error if the disk is full.
  void Append(std::shared_ptr<const Bytes> frame) override;
  std::int64_t first() const override { return 0; }
  std::int64_t count() const override { return static_cast<std::int64_t>(places_.size()); }
  std::shared_ptr<const Bytes> Read(std::int64_t index) override;

 private:
  struct Place {
    std::int64_t offset = 0;
    std::size_t compressed_bytes = 0;
    std::size_t bytes = 0;
  };
  std::filesystem::path folder_;
  int file_ = -1;
  std::vector<Place> places_;
  std::int64_t end_ = 0;
};

}  // namespace fallen
