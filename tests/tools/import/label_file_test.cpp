// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/label_file.hpp"

#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

constexpr char kBox[] = "box: {center: [2, 0, 0.1], size: [1.8, 0.6, 0.3], yaw: 0}";

LabelFile Labels(const std::string& text) {
  const TemporaryFolder folder;
  return ReadLabelFile(folder.Write("labels.yaml", text));
}

std::string ErrorOf(const std::string& text) {
  try {
    Labels(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(LabelFile, APersonAloneIsThereAllTheTime) {
  const LabelFile labels =
      Labels(std::string("room: kitchen\nperson: {present: true, name: anna, ") + kBox + "}\n");
  for (const int frame : {0, 1000}) {
    const auto truth = labels.At(frame, 0.1 * frame);
    ASSERT_TRUE(truth);
    EXPECT_EQ(truth->person, "anna");
    EXPECT_EQ(truth->room, "kitchen");
    EXPECT_EQ(truth->person_box->center.x(), 2);
  }
}

TEST(LabelFile, StretchesSayWhenByFrameOrTime) {
  const LabelFile labels =
      Labels(std::string("stretches:\n  - {frames: [2, 4], person: {present: true, ") + kBox +
             "}}\n  - {seconds: [0.55, 1.0], person: {present: false}}\n");
  EXPECT_FALSE(labels.At(1, 0.1));
  EXPECT_TRUE(labels.At(2, 0.2)->person_box);
  EXPECT_TRUE(labels.At(4, 0.4)->person_box);
  EXPECT_FALSE(labels.At(5, 0.5));
  ASSERT_TRUE(labels.At(6, 0.6));
  EXPECT_FALSE(labels.At(6, 0.6)->person_box);
  EXPECT_FALSE(labels.At(11, 1.1));
}

TEST(LabelFile, NamesTheLineThatIsWrong) {
  const std::string absent = "person: {present: false}}\n";
  EXPECT_THAT(ErrorOf("stretches: none\n"), HasSubstr("labels.yaml:1: got stretches"));
  EXPECT_THAT(ErrorOf("stretches:\n  - {" + absent), HasSubstr("labels.yaml:2: got neither"));
  EXPECT_THAT(ErrorOf("stretches:\n  - {frames: [0, 1], seconds: [0, 1], " + absent),
              HasSubstr("labels.yaml:2: got frames and seconds"));
  EXPECT_THAT(ErrorOf("stretches:\n  - {frames: [4, 2], " + absent),
              HasSubstr("labels.yaml:2: got malformed frames"));
  EXPECT_THAT(ErrorOf("room: [a]\nperson: {present: false}\n"),
              HasSubstr("labels.yaml:1: got room"));
}

}  // namespace
}  // namespace fallen
