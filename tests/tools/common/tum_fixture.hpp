// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/grey_png.hpp"

namespace fallen {

/// A small recording directory: frames of 8 x 6 at 0.1 s, 0.2 s, ... whose pixels hold
/// 1000 + 100 * frame + index.
class TumFixture {
 public:
  static constexpr int kWidth = 8;
  static constexpr int kHeight = 6;

  explicit TumFixture(int frames = 3) {
    folder_.Write(
        "camera.yaml",
        "width: 8\nheight: 6\nfx: 7\nfy: 7.5\ncx: 3.5\ncy: 2.5\ndepth_scale: 0.001 # m\n");
    std::string table = "# timestamp filename\n";
    for (int i = 0; i < frames; ++i) {
      const std::string name = "depth/" + std::to_string(i) + ".png";
      table += "0." + std::to_string(i + 1) + " " + name + "\n";
      std::filesystem::create_directories(path() / "depth");
      WriteGreyPng(path() / name, kWidth, kHeight, Values(i));
    }
    folder_.Write("depth.txt", table);
  }

  static std::vector<std::uint16_t> Values(int frame) {
    std::vector<std::uint16_t> values;
    for (int i = 0; i < kWidth * kHeight; ++i)
      values.push_back(static_cast<std::uint16_t>(1000 + 100 * frame + i));
    return values;
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  void Write(const std::string& name, const std::string& text) { folder_.Write(name, text); }

 private:
  TemporaryFolder folder_;
};

}  // namespace fallen
