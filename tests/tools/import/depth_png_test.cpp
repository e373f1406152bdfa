// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/depth_png.hpp"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/grey_png.hpp"
#include "tools/import/input_error.hpp"

namespace fallen {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kWidth = 5;
constexpr int kHeight = 3;

std::vector<std::uint16_t> Values() {
  std::vector<std::uint16_t> values;
  for (int i = 0; i < kWidth * kHeight; ++i) values.push_back(static_cast<std::uint16_t>(i * 4321));
  return values;
}

std::string ErrorOf(const std::filesystem::path& file) {
  try {
    ReadDepthPng(file, kWidth, kHeight);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadDepthPng, GivesEveryValueOfAllSixteenBits) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  WriteGreyPng(file, kWidth, kHeight, Values());
  EXPECT_EQ(ReadDepthPng(file, kWidth, kHeight), Values());
}

TEST(ReadDepthPng, ReadsInterlacedImages) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  PngFormat format;
  format.interlaced = true;
  WriteGreyPng(file, kWidth, kHeight, Values(), format);
  EXPECT_EQ(ReadDepthPng(file, kWidth, kHeight), Values());
}

TEST(ReadDepthPng, SaysWhatItGotInPlaceOfADepthImage) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  EXPECT_THAT(ErrorOf(file), HasSubstr("no readable file"));

  folder.Write("a.png", "not a picture");
  EXPECT_THAT(ErrorOf(file), AllOf(HasSubstr("a.png"), HasSubstr("no PNG")));

  WriteGreyPng(file, kWidth, kHeight, Values(), {.bit_depth = 8});
  EXPECT_THAT(ErrorOf(file), AllOf(HasSubstr("got 5 x 3, 8-bit greyscale"),
                                   HasSubstr("expected 5 x 3, 16-bit greyscale")));

  WriteGreyPng(file, kWidth, kHeight, Values(), {.colour = true});
  EXPECT_THAT(ErrorOf(file), HasSubstr("got 5 x 3, 16-bit colour"));

  WriteGreyPng(file, kHeight, kWidth, Values());
  EXPECT_THAT(ErrorOf(file), HasSubstr("got 3 x 5, 16-bit greyscale"));
}

TEST(ReadDepthPng, NoticesATruncatedFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  WriteGreyPng(file, kWidth, kHeight, Values());
  const std::string whole = ReadText(file);
  for (std::size_t size = 0; size + 13 < whole.size(); ++size) {  // without IEND nothing is missing
    folder.Write("a.png", whole.substr(0, size));
    EXPECT_NE(ErrorOf(file), "no error") << size << " of " << whole.size() << " bytes";
  }
}

}  // namespace
}  // namespace fallen
