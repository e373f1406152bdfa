// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/import/tum_directory.hpp"

#include <gmock/gmock.h>

#include "tests/tools/common/tum_fixture.hpp"

namespace fallen {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string ErrorOf(const TumFixture& fixture) {
  try {
    const TumDirectory directory = ReadTumDirectory(fixture.path());
    for (std::size_t i = 0; i < directory.frames.size(); ++i) LoadTumFrame(directory, i, "CAMERA");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadTumDirectory, ReadsCameraAndFrames) {
  const TumFixture fixture;
  const TumDirectory directory = ReadTumDirectory(fixture.path());
  EXPECT_EQ(directory.intrinsics, (CameraIntrinsics{8, 6, 7, 7.5, 3.5, 2.5}));
  EXPECT_EQ(directory.depth_unit_m, 0.001);
  ASSERT_EQ(directory.frames.size(), 3u);
  EXPECT_EQ(directory.frames[2].utime, 300000);
  EXPECT_FALSE(directory.labels);

  const TumMessages messages = LoadTumFrame(directory, 2, "FRONT");
  EXPECT_EQ(messages.depth.header, (Header{300000, 2, "FRONT"}));
  EXPECT_EQ(messages.depth.image.depth, TumFixture::Values(2));
  EXPECT_FALSE(messages.pose);
  EXPECT_FALSE(messages.depth.T_robot_camera);
}

TEST(ReadTumDirectory, InterpolatesPosesAtTheImagesTimes) {
  TumFixture fixture(4);
  // A level camera that looks along +x (q below) and drives 1 m/s; nothing near the last image.
  fixture.Write("groundtruth.txt",
                "# camera\n\n0.05 0.05 0 1 -0.5 0.5 -0.5 0.5\n0.15 0.15 0 1 -0.5 0.5 -0.5 0.5\n"
                "0.2 0.2 0 1 -0.5 0.5 -0.5 0.5\n9 9 0 1 -0.5 0.5 -0.5 0.5\n");
  const TumDirectory directory = ReadTumDirectory(fixture.path());
  const TumMessages first = LoadTumFrame(directory, 0, "CAMERA");
  ASSERT_TRUE(first.pose);
  EXPECT_EQ(first.pose->utime, 100000);
  EXPECT_TRUE(first.pose->translation.isApprox(Eigen::Vector3d(0.1, 0, 0), 1e-9));
  EXPECT_NEAR(first.pose->rotation.angularDistance(Eigen::Quaterniond::Identity()), 0, 1e-9);
  ASSERT_TRUE(first.depth.T_robot_camera);
  EXPECT_TRUE(first.depth.T_robot_camera->translation().isApprox(Eigen::Vector3d(0, 0, 1), 1e-9));
  const Eigen::Vector3d ahead = first.depth.T_robot_camera->linear().col(2);
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d::UnitX(), 1e-9)) << ahead.transpose();

  EXPECT_TRUE(LoadTumFrame(directory, 1, "CAMERA").pose) << "of the same time";
  EXPECT_TRUE(LoadTumFrame(directory, 2, "CAMERA").pose) << "0.1 s after the nearest";
  EXPECT_FALSE(LoadTumFrame(directory, 3, "CAMERA").pose) << "0.2 s after the nearest";
}

TEST(ReadTumDirectory, ReadsLabels) {
  TumFixture fixture;
  fixture.Write("labels.yaml", "scene: kitchen\nperson:\n  present: false\n  note: none\n");
  ASSERT_TRUE(ReadTumDirectory(fixture.path()).TruthOf(0));
  EXPECT_FALSE(ReadTumDirectory(fixture.path()).TruthOf(0)->person_box);

  fixture.Write("labels.yaml",
                "person:\n  present: true\n  box:\n    center: [1, 2, 0.15]\n"
                "    size: [1.8, 0.5, 0.3]\n    yaw: 0.25\n");
  const std::optional<OrientedBox> box = ReadTumDirectory(fixture.path()).TruthOf(0)->person_box;
  ASSERT_TRUE(box);
  EXPECT_EQ(*box, (OrientedBox{{1, 2, 0.15}, {1.8, 0.5, 0.3}, 0.25}));
}

TEST(ReadTumDirectory, NamesFileAndPlaceOfWhatIsWrong) {
  struct Case {
    const char* file;
    const char* text;
    const char* error;
  };
  const Case cases[] = {
      {"camera.yaml", "width: 8\n", "camera.yaml:1: got no height, expected the key height"},
      {"camera.yaml", "width: 8\nheight: six\n", "camera.yaml:2: got height \"six\""},
      {"camera.yaml", "width: 8\nheight: 6\nfx: -7\nfy: 7\ncx: 3\ncy: 2\ndepth_scale: 0.001\n",
       "camera.yaml:3: got fx \"-7\", expected a number > 0"},
      {"camera.yaml", "width: 8\nheight: 6\nfx: .nan\n", "camera.yaml:3: got fx \".nan\""},
      {"camera.yaml", "width: 8\nheight: 6\nfx: 7\nfy: 7\ncx: 3\ncy: 2\ndepth_scale: 5000\n",
       "camera.yaml:7: got depth_scale 5000, expected metres per unit"},
      {"camera.yaml", "width: 0\nheight: 6\nfx: 7\nfy: 7\ncx: 3\ncy: 2\ndepth_scale: 0.001\n",
       "camera.yaml"},
      {"camera.yaml", "width: [8\n", "camera.yaml:"},
      {"camera.yaml", "8 6\n", "camera.yaml: got no map"},
      {"depth.txt", "# nothing\n", "depth.txt: got no image"},
      {"depth.txt", "0.1 depth/7.png\n", "7.png: got no readable file"},
      {"depth.txt", "0.2 depth/0.png\n0.1 depth/1.png\n", "depth.txt:2: got timestamp 0.1"},
      {"groundtruth.txt", "0.1 0 0 1 0 0 0\n", "groundtruth.txt:1: got \"0.1 0 0 1 0 0 0\""},
      {"groundtruth.txt", "#\n0.1 0 nan 1 0 0 0 1\n", "groundtruth.txt:2: got ty \"nan\""},
      {"groundtruth.txt", "0.1 0 0 1 0 0 0 2\n",
       "groundtruth.txt:1: got a quaternion of length 2.000000, expected length 1"},
      {"labels.yaml", "people: 1\n", "labels.yaml:1: got no person"},
      {"labels.yaml", "person:\n  present: maybe\n", "labels.yaml:2: got present \"maybe\""},
      {"labels.yaml", "person:\n  present: true\n", "labels.yaml:2: got no box"},
      {"labels.yaml", "person:\n  present: true\n  box:\n    center: [1, 2]\n",
       "labels.yaml:4: got a malformed center"},
      {"labels.yaml",
       "person:\n  present: true\n  box: {center: [1, 2, 3], size: [1, 0, 1], yaw: 0}\n",
       "labels.yaml:3: got an edge <= 0"},
  };
  for (const Case& wrong : cases) {
    TumFixture fixture;
    fixture.Write(wrong.file, wrong.text);
    EXPECT_THAT(ErrorOf(fixture), HasSubstr(wrong.error)) << wrong.text;
  }
}

TEST(ReadTumDirectory, NeedsTheDirectoryAndItsTwoFiles) {
  EXPECT_THROW(ReadTumDirectory("/nowhere"), std::runtime_error);
  for (const char* name : {"camera.yaml", "depth.txt"}) {
    const TumFixture fixture;
    std::filesystem::remove(fixture.path() / name);
    EXPECT_THAT(ErrorOf(fixture), AllOf(HasSubstr(name), HasSubstr("no readable file")));
  }
}

}  // namespace
}  // namespace fallen
