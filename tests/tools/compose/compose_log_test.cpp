// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/compose_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "tests/support/temporary_folder.hpp"
#include "tests/tools/common/lying_scene.hpp"
#include "tests/tools/compose/half_cylinder.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {
namespace {

std::string Pcd(const std::vector<Eigen::Vector3d>& points) {
  const std::string count = std::to_string(points.size());
  std::string text = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                     count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count +
                     "\nDATA ascii\n";
  for (const Eigen::Vector3d& p : points) {
    char line[80];
    std::snprintf(line, sizeof line, "%.4f %.4f %.4f\n", p.x(), p.y(), p.z());
    text += line;
  }
  return text;
}

class ComposingLogs : public testing::Test {
 protected:
  void SetUp() override {
    lying_scene::WriteDirectory(folder_.path() / "scene", 3, lying_scene::With::kNobody, false);
    options_.person = folder_.Write("body.pcd", Pcd(HalfCylinder()));
    options_.scene = folder_.path() / "scene";
    options_.log = folder_.path() / "composed.lcm";
    options_.places = 2;
  }

  TemporaryFolder folder_;
  ComposeOptions options_;
};

TEST_F(ComposingLogs, EveryImageHasAPoseATruthAndAPerson) {
  options_.composition.noise_scale = 0;
  const ComposeReport report = ComposeLog(options_);
  EXPECT_EQ(report.used_frames, 3);
  EXPECT_EQ(report.images, 6);
  const auto log = OpenFrameSource(options_.log);
  int images = 0;
  while (const auto frame = log->Next()) {
    ++images;
    ASSERT_TRUE(frame->T_world_robot && frame->T_robot_camera);
    const auto truth = log->Truth(*frame);
    ASSERT_TRUE(truth && truth->person_box);
    EXPECT_EQ(truth->person, "body");
    EXPECT_EQ(truth->room, "scene");
    // Without noise every labelled pixel lies in the box, up to a step of the depth.
    OrientedBox box = *truth->person_box;
    box.size += Eigen::Vector3d::Constant(0.06);
    const CameraIntrinsics& camera = frame->image.intrinsics;
    int labelled = 0;
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u) {
        const std::size_t i = static_cast<std::size_t>(v) * camera.width + u;
        if (truth->labels[i] != truth->person_label()) continue;
        ++labelled;
        const double z_m = frame->image.depth[i] * frame->image.depth_unit_m;
        ASSERT_TRUE(box.Contains(*frame->T_world_robot * *frame->T_robot_camera *
                                 camera.Deproject(u, v, z_m)));
      }
    EXPECT_GT(labelled, 500);
  }
  EXPECT_EQ(images, report.images);
}

TEST_F(ComposingLogs, SameSeedSameLog) {
  ComposeLog(options_);
  const std::string first = ReadText(options_.log);
  ComposeLog(options_);
  EXPECT_EQ(ReadText(options_.log), first);
}

TEST_F(ComposingLogs, NoPlaceIsAnError) {
  options_.search.min_distance_m = options_.search.max_distance_m = 9;  // behind the wall
  EXPECT_THROW(ComposeLog(options_), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(options_.log));
}

}  // namespace
}  // namespace fallen
