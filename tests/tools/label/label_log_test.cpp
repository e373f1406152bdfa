// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/label/label_log.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/import/import_log.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

/// A log of six frames past a lying block, without truth.
class LabelLogTest : public testing::Test {
 protected:
  LabelLogTest() {
    options_.log = Log("drive", true);
    options_.output = folder_ / "labelled.lcm";
  }

  std::filesystem::path Log(const std::string& name, bool with_poses) {
    lying_scene::WriteDirectory(folder_ / name, 6, lying_scene::With::kPerson, with_poses);
    const std::filesystem::path log = folder_ / (name + ".lcm");
    ImportDirectory(folder_ / name, log, "CAMERA");
    return log;
  }

  static std::string Stretch(const std::string& range, double shift_m) {
    const OrientedBox box = lying_scene::Person();
    std::ostringstream text;
    text << "  - {" << range << ", person: {present: true, name: anna, box: {center: ["
         << box.center.x() + shift_m << ", " << box.center.y() << ", " << box.center.z()
         << "], size: [" << box.size.x() + 0.04 << ", " << box.size.y() + 0.04 << ", "
         << box.size.z() + 0.04 << "], yaw: " << box.yaw << "}}}\n";
    return text.str();
  }

  LabelReport Label(const std::string& labels) {
    options_.truth = folder_.Write("labels.yaml", labels);
    return LabelLog(options_);
  }

  std::string ErrorOf(const std::string& labels) {
    try {
      Label(labels);
    } catch (const std::runtime_error& error) {
      EXPECT_FALSE(std::filesystem::exists(options_.output));
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
  LabelOptions options_;
};

TEST_F(LabelLogTest, WritesTheTruthOfTheStretchesIntoACopy) {
  const LabelReport report = Label("room: lab\nstretches:\n" + Stretch("frames: [1, 3]", 0) +
                                   "  - {seconds: [0.45, 9], person: {present: false}}\n");
  EXPECT_EQ(report.frames, 6);
  EXPECT_EQ(report.labelled, 4);
  EXPECT_EQ(report.with_person, 3);
  EXPECT_EQ(report.positive, 3);
  EXPECT_THAT(report.frames_to_show, testing::ElementsAre(1, 2, 3, 5));

  const auto before = OpenFrameSource(options_.log), after = OpenFrameSource(options_.output);
  for (int number = 0; const auto frame = after->Next(); ++number) {
    EXPECT_EQ(frame->image.depth, before->Next()->image.depth);
    const auto truth = after->Truth(*frame);
    ASSERT_EQ(truth.has_value(), number != 0 && number != 4) << number;
    if (!truth) continue;
    EXPECT_EQ(truth->room, "lab");
    EXPECT_EQ(truth->person, number < 4 ? "anna" : "");
    EXPECT_EQ(truth->person_box.has_value(), number < 4);
  }
}

TEST_F(LabelLogTest, LabelsAnewWhatWasLabelled) {
  Label("stretches:\n" + Stretch("frames: [0, 5]", 0));
  options_.log = options_.output;
  options_.output = folder_ / "again.lcm";
  Label("person: {present: false}\n");
  const auto source = OpenFrameSource(options_.output);
  int frames = 0;
  for (; const auto frame = source->Next(); ++frames)
    EXPECT_FALSE(source->Truth(*frame)->person_box);
  EXPECT_EQ(frames, 6);
}

TEST_F(LabelLogTest, RefusesWhatCannotBeMeant) {
  EXPECT_THAT(ErrorOf("stretches:\n" + Stretch("frames: [6, 9]", 0)),
              HasSubstr("labels.yaml:2: got a stretch without a frame"));
  EXPECT_THAT(ErrorOf("stretches:\n" + Stretch("frames: [0, 5]", 30)),
              HasSubstr("labels.yaml:2: got a box without a cell"));
  options_.log = Log("lost", false);
  EXPECT_THAT(ErrorOf("stretches:\n" + Stretch("frames: [0, 5]", 0)),
              HasSubstr("labels.yaml:2: got a box, but no pose"));
}

TEST_F(LabelLogTest, ThePreviewShowsEachStretch) {
  const auto labels = folder_.Write("labels.yaml", "stretches:\n" + Stretch("frames: [2, 2]", 0));
  const ProgramOutcome outcome = RunProgram(
      "fallen-label", {options_.log.string(), "--truth", labels.string(), "-o",
                       options_.output.string(), "--preview", (folder_ / "look").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("frames 6 labelled 1 with_person 1 positive 1"));
  EXPECT_THAT(ReadText(folder_ / "look" / "frame-2.png"), testing::StartsWith("\x89PNG"));
  const ProgramOutcome wrong = RunProgram(
      "fallen-label", {options_.log.string(), "--truth", "/nowhere.yaml", "-o", "x.lcm"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_TRUE(IsOneLine(wrong.err)) << wrong.err;
}

}  // namespace
}  // namespace fallen
