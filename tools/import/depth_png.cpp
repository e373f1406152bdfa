// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/depth_png.hpp"

#include <png.h>

#include <bit>
#include <cstdio>
#include <memory>
#include <string>

#include "tools/import/input_error.hpp"

namespace fallen {
namespace {

constexpr std::size_t kSignatureBytes = 8;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// libpng's two structs, freed together.
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string error;

  PngReader() {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &OnError, &OnWarning);
    if (png) info = png_create_info_struct(png);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  static void OnError(png_structp png, png_const_charp message) {
    static_cast<PngReader*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
  }
  static void OnWarning(png_structp, png_const_charp) {}
};

std::string Describe(png_uint_32 width, png_uint_32 height, int bit_depth, bool is_grey) {
  return std::to_string(width) + " x " + std::to_string(height) + ", " + std::to_string(bit_depth) +
         "-bit " + (is_grey ? "greyscale" : "colour");
}

// libpng reports errors by longjmp: between setjmp and the end of these two functions, no object
// with a destructor may be made.

bool ReadHeader(PngReader& reader, std::FILE* file) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_init_io(reader.png, file);
  png_set_sig_bytes(reader.png, kSignatureBytes);
  png_read_info(reader.png, reader.info);
  return true;
}

bool ReadPixels(PngReader& reader, png_bytep* rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  if constexpr (std::endian::native == std::endian::little) png_set_swap(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

}  // namespace

std::vector<std::uint16_t> ReadDepthPng(const std::filesystem::path& path, int width, int height) {
  const std::string expected =
      Describe(static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16, true);
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw InputError(path, 0, "no readable file", "a PNG of " + expected);
  png_byte signature[kSignatureBytes] = {};
  if (std::fread(signature, 1, kSignatureBytes, file.get()) != kSignatureBytes ||
      png_sig_cmp(signature, 0, kSignatureBytes) != 0)
    throw InputError(path, 0, "no PNG", "a PNG of " + expected);

  PngReader reader;
  if (!reader.png || !reader.info) throw std::bad_alloc();
  if (!ReadHeader(reader, file.get()))
    throw InputError(path, 0, "a damaged PNG (" + reader.error + ")", "a PNG of " + expected);
  const std::string got = Describe(
      png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info),
      png_get_bit_depth(reader.png, reader.info),
      png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_GRAY);
  if (got != expected) throw InputError(path, 0, got, expected);

  std::vector<std::uint16_t> values(static_cast<std::size_t>(width) * height);
  std::vector<png_bytep> rows(static_cast<std::size_t>(height));
  for (int v = 0; v < height; ++v)
    rows[v] = reinterpret_cast<png_bytep>(values.data() + static_cast<std::size_t>(v) * width);
  if (!ReadPixels(reader, rows.data()))
    throw InputError(path, 0, "a damaged PNG (" + reader.error + ")", "a PNG of " + expected);
  return values;
}

}  // namespace fallen
