// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_recording.hpp"

#include <png.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace fallen::testing {
namespace {

// The numbers of `key: value  # comment` lines.
std::map<std::string, double> ReadNumbers(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::map<std::string, double> numbers;
  std::string line;
  while (std::getline(in, line)) {
    const std::size_t colon = line.find(':');
    if (line.starts_with("#") || colon == std::string::npos) continue;
    numbers[line.substr(0, colon)] = std::stod(line.substr(colon + 1));
  }
  return numbers;
}

// Lines of words, without comments.
std::vector<std::vector<std::string>> ReadTable(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::vector<std::string>> table;
  std::string line;
  while (std::getline(in, line)) {
    if (line.starts_with("#")) continue;
    std::istringstream words(line);
    std::vector<std::string> row;
    for (std::string word; words >> word;) row.push_back(word);
    if (!row.empty()) table.push_back(row);
  }
  return table;
}

Eigen::Isometry3d PoseFromRow(const std::vector<std::string>& row) {
  if (row.size() != 8) throw std::runtime_error("groundtruth.txt: expected 8 columns");
  const auto number = [&](std::size_t i) { return std::stod(row[i]); };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(number(1), number(2), number(3));
  pose.linear() = Eigen::Quaterniond(number(7), number(4), number(5), number(6))
                      .normalized()
                      .toRotationMatrix();
  return pose;
}

std::vector<std::uint16_t> ReadPng16(const std::filesystem::path& path, int width, int height) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) throw std::runtime_error(path.string() + ": cannot be opened");
  png_structp png = png_create_read_struct(
      PNG_LIBPNG_VER_STRING, nullptr,
      [](png_structp, png_const_charp message) { throw std::runtime_error(message); }, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file.get());
  png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
  if (png_get_bit_depth(png, info) != 16 || png_get_channels(png, info) != 1 ||
      static_cast<int>(png_get_image_width(png, info)) != width ||
      static_cast<int>(png_get_image_height(png, info)) != height)
    throw std::runtime_error(path.string() + ": not a 16-bit grey image of the camera's size");
  std::vector<std::uint16_t> depth(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
  png_bytepp rows = png_get_rows(png, info);
  for (int v = 0; v < height; ++v)
    std::memcpy(depth.data() + static_cast<std::size_t>(v) * width, rows[v],
                sizeof(std::uint16_t) * static_cast<std::size_t>(width));
  png_destroy_read_struct(&png, &info, nullptr);
  return depth;
}

}  // namespace

std::vector<RecordedFrame> ReadRecording(const std::filesystem::path& directory) {
  if (!std::filesystem::exists(directory)) return {};
  std::map<std::string, double> camera = ReadNumbers(directory / "camera.yaml");
  std::map<std::string, Eigen::Isometry3d> poses;
  for (const auto& row : ReadTable(directory / "groundtruth.txt")) poses[row[0]] = PoseFromRow(row);
  std::vector<RecordedFrame> frames;
  for (const auto& row : ReadTable(directory / "depth.txt")) {
    RecordedFrame& frame = frames.emplace_back();
    frame.image.intrinsics = {static_cast<int>(camera.at("width")),
                              static_cast<int>(camera.at("height")),
                              camera.at("fx"),
                              camera.at("fy"),
                              camera.at("cx"),
                              camera.at("cy")};
    frame.image.depth_unit_m = camera.at("depth_scale");
    frame.image.depth = ReadPng16(directory / row.at(1), frame.image.intrinsics.width,
                                  frame.image.intrinsics.height);
    if (const auto pose = poses.find(row[0]); pose != poses.end())
      frame.T_world_camera = pose->second;
  }
  return frames;
}

}  // namespace fallen::testing
