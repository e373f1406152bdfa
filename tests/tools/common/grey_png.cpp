// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/tools/common/grey_png.hpp"

#include <png.h>

#include <cstdio>
#include <stdexcept>

namespace fallen {

void WriteGreyPng(const std::filesystem::path& path, int width, int height,
                  const std::vector<std::uint16_t>& values, const PngFormat& format) {
  const int channels = format.colour ? 3 : 1;
  const int bytes = format.bit_depth / 8;
  std::vector<png_byte> data;
  for (const std::uint16_t value : values)
    for (int c = 0; c < channels; ++c) {
      if (bytes == 2) data.push_back(static_cast<png_byte>(value >> 8));
      data.push_back(static_cast<png_byte>(value & 0xff));
    }
  std::vector<png_bytep> rows;
  for (int v = 0; v < height; ++v)
    rows.push_back(data.data() + static_cast<std::size_t>(v) * width * channels * bytes);

  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) throw std::runtime_error("cannot write " + path.string());
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
               format.bit_depth, format.colour ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
               format.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

}  // namespace fallen
