// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <span>

#include "tools/common/partial_file.hpp"

namespace fallen {

/// Writes pictures as a film (H.264 in MP4) through the ffmpeg program.
class FilmWriter {
 public:
  /// @param width, height  Of every picture, even [px].
  /// @throws std::runtime_error if ffmpeg is not there or the file cannot be written.
  FilmWriter(const std::filesystem::path& film, int width, int height, double pictures_per_second);
  /// Without Close, nothing is left.
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  /// Pixels are 0x..RRGGBB, row-major. @throws std::runtime_error if ffmpeg has given up.
  void Add(std::span<const std::uint32_t> pixels);

  /// Ends the film and gives the file its name. @throws std::runtime_error if ffmpeg failed.
  void Close();

 private:
  int WaitForEnd();

  PartialFile file_;
  pid_t ffmpeg_ = -1;
  int pipe_ = -1;
};

}  // namespace fallen
