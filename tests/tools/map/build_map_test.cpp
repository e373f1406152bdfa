// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/build_map.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "fallen/messages/model_files.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tools/import/import_log.hpp"
#include "tools/map/cloud_file.hpp"
#include "tools/map/map_info.hpp"
#include "tools/map/person_mask.hpp"

namespace fallen {
namespace {

using lying_scene::With;
using testing::HasSubstr;
using testing::StartsWith;

/// Cells of `map` inside the block of the person, which the empty room has none of.
std::ptrdiff_t CellsOfThePerson(const EnvironmentMap& map) {
  OrientedBox box = lying_scene::Person();
  box.size.array() += 0.05;
  return std::count_if(map.cells.begin(), map.cells.end(),
                       [&](const NdtCell& cell) { return box.Contains(cell.mean.cast<double>()); });
}

BuildMapOptions OptionsFor(const std::vector<std::filesystem::path>& inputs,
                           const std::filesystem::path& output) {
  BuildMapOptions options;
  options.inputs = inputs;
  options.output = output;
  return options;
}

TEST(BuildMap, MapsARecordingWithoutFloorInTheWorld) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path() / "room", 4, With::kPerson, true);
  const auto output = folder.path() / "room.map";
  const BuildMapReport report = BuildMap(OptionsFor({folder.path() / "room"}, output));
  EXPECT_EQ(report.frames, 4);
  const EnvironmentMap map = LoadEnvironmentMap(output);
  EXPECT_EQ(map.cells.size(), report.cells);
  EXPECT_EQ(map.description, "room");
  EXPECT_GT(CellsOfThePerson(map), 50) << "nobody said that this is a person";
  EXPECT_GT(map.cells.size(), 200u) << "and there is a wall";
  for (const NdtCell& cell : map.cells) EXPECT_GT(cell.mean.z(), 0.02);
}

TEST(BuildMap, LeavesLabelledPersonsOut) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path() / "room", 4, With::kPerson, true);
  folder.Write("room/labels.yaml",
               "person: {present: true, box: {center: [2.0, 0.1, 0.15], size: [0.45, 1.6, 0.3], "
               "yaw: 0.3}}\n");
  ImportDirectory(folder.path() / "room", folder.path() / "room.lcm", "CAMERA");
  for (const char* input : {"room", "room.lcm"}) {
    const auto output = folder.path() / "room.map";
    BuildMap(OptionsFor({folder.path() / input}, output));
    const EnvironmentMap map = LoadEnvironmentMap(output);
    EXPECT_EQ(CellsOfThePerson(map), 0) << input;
    EXPECT_GT(map.cells.size(), 200u) << input;
  }
}

TEST(BuildMap, TakesCloudsWithoutTheirFloorAndMergesInputs) {
  const TemporaryFolder folder;
  std::string pcd =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 60\nHEIGHT 1\n"
      "POINTS 60\nDATA ascii\n";
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 20\nproperty double x\nproperty double y\nproperty "
      "double z\nend_header\n";
  const auto row = [](double x, int i, double z) {
    return std::to_string(x + 0.002 * i) + " " + std::to_string(0.01 + 0.0015 * (i * 7 % 20)) +
           " " + std::to_string(z) + "\n";
  };
  for (int i = 0; i < 20; ++i) {
    pcd += row(1.001, i, 0.51);  // a patch
    pcd += row(1.001, i, 0.01);  // on the floor
    pcd += row(1.001, i, 2.51);  // under the ceiling
    ply += row(2.001, i, 0.71);
  }
  const auto output = folder.path() / "clouds.map";
  const BuildMapReport report =
      BuildMap(OptionsFor({folder.Write("a.pcd", pcd), folder.Write("b.PLY", ply)}, output));
  EXPECT_EQ(report.points, 40);
  const EnvironmentMap map = LoadEnvironmentMap(output);
  ASSERT_EQ(map.cells.size(), 2u);
  EXPECT_NEAR(map.cells[0].mean.x(), 1.02, 1e-4);
  EXPECT_NEAR(map.cells[0].mean.z(), 0.51, 1e-4);
  EXPECT_NEAR(map.cells[1].mean.x(), 2.02, 1e-4);
  EXPECT_EQ(map.description, "a.pcd, b.PLY");
}

TEST(BuildMap, HeedsCellSizeAndDescription) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path() / "room", 1, With::kNobody, true);
  BuildMapOptions options = OptionsFor({folder.path() / "room"}, folder.path() / "room.map");
  options.cell_size_m = 0.1;
  options.description = "the living room";
  const BuildMapReport report = BuildMap(options);
  EXPECT_EQ(LoadEnvironmentMap(options.output).cell_size_m, 0.1);
  const std::string info = DescribeMapFile(options.output);
  EXPECT_THAT(info, HasSubstr("description: the living room\n"));
  EXPECT_THAT(info, HasSubstr("cells: " + std::to_string(report.cells) + "\n"));
  EXPECT_THAT(info, HasSubstr("cell_size_m: 0.1\n"));
  EXPECT_THAT(info, HasSubstr("x_m: 3."));
}

TEST(RemovePersons, TakesLabelledPixelsAndBoxesAndNothingElse) {
  DepthImage image;
  image.intrinsics = {4, 1, 1, 1, 0, 0};
  image.depth = {1000, 1000, 1000, 1000};  // at x = 0, 1, 2, 3 m
  GroundTruth truth;
  truth.objects = {{"person", "stands", 3, {{50, 0, 0}, {1, 1, 1}, 0}},
                   {"furniture", "chair", 4, {{1, 0, 1}, {1, 1, 1}, 0}}};
  truth.label_width = 4;
  truth.label_height = 1;
  truth.labels = {0, 4, 3, 0};
  truth.person_box = OrientedBox{{3.5, 0, 1}, {0.9, 1, 1}, 0};  // ends 5 cm before x = 3
  EXPECT_EQ(RemovePersons(image, truth, Eigen::Isometry3d::Identity()), 2);
  EXPECT_EQ(image.depth, (std::vector<std::uint16_t>{1000, 1000, 0, 0}));
}

TEST(FallenMap, PrintsWhatItBuiltAndWhatAMapHolds) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path() / "room", 2, With::kNobody, true);
  const std::string map = (folder.path() / "room.map").string();
  const ProgramOutcome built =
      RunProgram("fallen-map", {(folder.path() / "room").string(), "-o", map});
  EXPECT_EQ(built.status, 0);
  EXPECT_THAT(built.err, HasSubstr("frames 2 without_pose 0 damaged 0"));
  const ProgramOutcome info = RunProgram("fallen-map", {"--info", map});
  EXPECT_EQ(info.status, 0);
  EXPECT_THAT(info.out, StartsWith("description: room\ncells: "));
}

TEST(FallenMap, AWrongCallOrInputIsOneLineAndStatusTwo) {
  const TemporaryFolder folder;
  lying_scene::WriteDirectory(folder.path() / "lost", 2, With::kNobody, false);
  lying_scene::WriteDirectory(folder.path() / "room", 1, With::kNobody, true);
  const std::string lost = (folder.path() / "lost").string();
  const std::string room = (folder.path() / "room").string();
  const std::string output = (folder.path() / "out.map").string();
  const std::string broken = folder.Write("broken.ply", "ply\nformat ascii 1.0\nelement").string();
  const std::string no_points =
      folder
          .Write("none.pcd",
                 "VERSION .7\nFIELDS a\nSIZE 4\nTYPE F\nCOUNT 1\nWIDTH 1\nHEIGHT 1\n"
                 "POINTS 1\nDATA ascii\n1\n")
          .string();
  const std::vector<std::vector<std::string>> calls = {{},
                                                       {room},
                                                       {"-o", output},
                                                       {lost, "-o", output},
                                                       {broken, "-o", output},
                                                       {no_points, "-o", output},
                                                       {"/nowhere.pcd", "-o", output},
                                                       {"/nowhere.lcm", "-o", output},
                                                       {room, "-o", output, "--cell-size", "0"},
                                                       {room, "-o", "/nowhere/out.map"},
                                                       {"--info", room},
                                                       {"--info", output}};
  for (const std::vector<std::string>& call : calls) {
    const ProgramOutcome outcome = RunProgram("fallen-map", call);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(IsOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, StartsWith("fallen-map: "));
    EXPECT_FALSE(std::filesystem::exists(output));
  }
  EXPECT_THAT(RunProgram("fallen-map", calls[3]).err, HasSubstr("without a pose"));
}

}  // namespace
}  // namespace fallen
