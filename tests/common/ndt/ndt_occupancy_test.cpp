// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "fallen/ndt/ndt_mapper.hpp"
#include "ray_cast_scene.hpp"

// What has gone must leave the map; what is still there must stay, whatever noise and angle do.
namespace fallen {
namespace {

constexpr std::int64_t kFrame_us = 100000;  // 10 Hz

using Index = std::array<int, 3>;

Index IndexOf(const NdtCell& cell) {
  const Eigen::Array3d cells = cell.mean.cast<double>().array() / 0.05;
  return {static_cast<int>(std::floor(cells.x())), static_cast<int>(std::floor(cells.y())),
          static_cast<int>(std::floor(cells.z()))};
}

// A camera that films a scene at 10 Hz and maps it.
class Filming {
 public:
  explicit Filming(int width = 320, const NdtConfig& config = {})
      : mapper_(config), camera_(PrimeSenseIntrinsics(width, width * 3 / 4)) {}

  // Points the camera; what follows is filmed from there.
  void Look(const RayCastScene& scene, const Eigen::Isometry3d& T_world_camera) {
    clean_ = RenderDepth(scene, camera_, T_world_camera);
    T_world_camera_ = T_world_camera;
  }
  const NdtMap& Film() { return Film(T_world_camera_); }
  const NdtMap& Film(const Eigen::Isometry3d& T_world_camera_believed) {
    image_ = WithSensorNoise(clean_, noise_);
    return Map(T_world_camera_believed);
  }
  void Film(int frames) {
    for (int i = 0; i < frames; ++i) Film();
  }
  const NdtMap& FilmNothing() {
    std::fill(image_.depth.begin(), image_.depth.end(), std::uint16_t{0});
    return Map(T_world_camera_);
  }
  const NdtMap& map() const { return map_; }
  std::mt19937& noise() { return noise_; }

 private:
  const NdtMap& Map(const Eigen::Isometry3d& T_world_camera) {
    GroundEstimate ground;
    ground.status = GroundStatus::kOk;
    ground.plane = TransformPlane(T_world_camera.inverse(), Plane{});
    map_ = mapper_.Update(utime_ += kFrame_us, image_, T_world_camera, ground);
    return map_;
  }

  NdtMapper mapper_;
  CameraIntrinsics camera_;
  std::mt19937 noise_{7};
  Eigen::Isometry3d T_world_camera_;
  DepthImage clean_, image_;
  NdtMap map_;
  std::int64_t utime_ = 0;
};

int CellsNear(const NdtMap& map, const Eigen::Vector3d& center, double radius_m) {
  int count = 0;
  for (const NdtCell& cell : map.cells)
    count += (cell.mean.cast<double>() - center).head<2>().norm() < radius_m ? 1 : 0;
  return count;
}

// Cells with so many points that the surface is certain.
std::set<Index> CertainCells(const NdtMap& map, unsigned min_points, double max_distance_m) {
  std::set<Index> certain;
  for (const NdtCell& cell : map.cells)
    if (cell.point_count >= min_points &&
        (map.T_map_camera.inverse() * cell.mean.cast<double>()).norm() < max_distance_m)
      certain.insert(IndexOf(cell));
  return certain;
}

int Lost(const std::set<Index>& expected, const NdtMap& map) {
  std::set<Index> present;
  for (const NdtCell& cell : map.cells) present.insert(IndexOf(cell));
  int lost = 0;
  for (const Index& index : expected) lost += present.contains(index) ? 0 : 1;
  return lost;
}

TEST(NdtOccupancy, SomebodyWhoGetsUpLeavesTheMapWithinASecondOrTwo) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.4);
  for (const double distance_m : {1.6, 2.4, 3.4}) {
    SCOPED_TRACE(distance_m);
    Filming filming;
    RayCastScene room = FurnishedRoom();
    const Eigen::Vector3d place(distance_m, 0, 0);
    room.ellipsoids = LyingPerson(place, 1.3);
    filming.Look(room, pose);
    filming.Film(30);
    const int lying = CellsNear(filming.map(), place, 0.5);
    ASSERT_GT(lying, 60);
    room.ellipsoids.clear();
    filming.Look(room, pose);
    filming.Film(10);
    EXPECT_LE(CellsNear(filming.map(), place, 0.5), lying / 20) << "of " << lying;
    filming.Film(10);
    EXPECT_EQ(CellsNear(filming.map(), place, 0.5), 0) << "of " << lying;
  }
}

TEST(NdtOccupancy, SomebodyWhoIsHiddenStaysInTheMap) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.4);
  Filming filming;
  RayCastScene room = FurnishedRoom();
  const Eigen::Vector3d place(2.6, 0, 0);
  room.ellipsoids = LyingPerson(place, 1.3);
  filming.Look(room, pose);
  filming.Film(10);
  const int lying = CellsNear(filming.map(), place, 0.5);
  room.boxes.push_back({{1.2, -1.2, 0.0}, {1.3, 1.2, 0.9}});  // something drives in between
  filming.Look(room, pose);
  filming.Film(30);
  EXPECT_GE(CellsNear(filming.map(), place, 0.5), lying);
}

TEST(NdtOccupancy, PixelsWithoutDepthAreNoEvidence) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.4);
  Filming filming;
  RayCastScene room = FurnishedRoom();
  room.ellipsoids = LyingPerson({2, 0, 0}, 1.3);
  filming.Look(room, pose);
  filming.Film(5);
  const std::vector<NdtCell> before = filming.map().cells;
  for (int i = 0; i < 30; ++i) filming.FilmNothing();
  EXPECT_EQ(filming.map().cells, before);
}

TEST(NdtOccupancy, DepthNoiseEatsNoCells) {
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.4);
  Filming filming;
  RayCastScene room = FurnishedRoom();
  room.ellipsoids = LyingPerson({2, 0, 0}, 1.3);
  filming.Look(room, pose);
  filming.Film(20);
  const std::set<Index> certain = CertainCells(filming.map(), 100, 4.0);
  ASSERT_GT(certain.size(), 300u);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(Lost(certain, filming.Film()), 0) << i;
}

// Across a table's top from 8 cm above it: rays meet it at 1 to 5 degrees.
TEST(NdtOccupancy, GrazingRaysEatNoCells) {
  RayCastScene scene;
  scene.boxes = {{{0.5, -1.0, 0.0}, {3.5, 1.0, 0.6}}, {{4.4, -3.0, 0.0}, {4.5, 3.0, 2.5}}};
  Filming filming;
  const Eigen::Isometry3d above = LookingDown({0, 0, 1.2}, 0, 0.4);
  filming.Look(scene, above);
  filming.Film(20);
  const std::set<Index> certain = CertainCells(filming.map(), 100, 3.2);
  ASSERT_GT(certain.size(), 300u);
  for (int i = 0; i < 20; ++i) {
    filming.Look(scene, LookingDown({0.03 * i, 0, 0.68}, 0, 0.0));
    filming.Film(3);
  }
  EXPECT_LE(Lost(certain, filming.map()), 0.01 * static_cast<double>(certain.size()))
      << "of " << certain.size();
}

// A camera whose pose is told 3 mm and 0.1 degrees wrong sees the wall past the edges of a box.
TEST(NdtOccupancy, DepthEdgesEatNoCells) {
  RayCastScene scene;
  scene.boxes = {{{2.0, -0.3, 0.0}, {2.5, 0.3, 0.5}}, {{4.4, -3.0, 0.0}, {4.5, 3.0, 2.5}}};
  Filming filming;
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.3);
  std::normal_distribution<double> gaussian;
  filming.Look(scene, pose);
  const auto film = [&]() -> const NdtMap& {
    Eigen::Isometry3d believed = pose;
    Eigen::Vector3d shift, turn;
    for (int k = 0; k < 3; ++k) shift[k] = 0.003 * gaussian(filming.noise());
    believed.translation() += shift;
    believed.rotate(
        Eigen::AngleAxisd(0.0017 * gaussian(filming.noise()), Eigen::Vector3d::UnitY()));
    return filming.Film(believed);
  };
  for (int i = 0; i < 20; ++i) film();
  const std::set<Index> certain = CertainCells(filming.map(), 60, 3.2);
  ASSERT_GT(certain.size(), 100u);
  for (int i = 0; i < 50; ++i) {
    const int lost = Lost(certain, film());
    ASSERT_LE(lost, 0.01 * static_cast<double>(certain.size())) << i << " of " << certain.size();
  }
}

// Points that were noise fill voxels that never become cells: those go too, if slowly.
TEST(NdtOccupancy, VoxelsWithoutAGaussianAreForgotten) {
  NdtConfig config;
  config.min_points = 20;
  Filming filming(160, config);
  RayCastScene scene;
  scene.boxes = {{{3.0, -3.0, 0.0}, {3.1, 3.0, 2.5}}};
  RayCastScene with_speck = scene;
  with_speck.ellipsoids = {{{1.5, 0, 0.9}, Eigen::Matrix3d::Identity() / 0.012}};
  const Eigen::Isometry3d pose = LookingDown({0, 0, 1.0}, 0, 0.1);
  filming.Look(with_speck, pose);
  filming.Film();
  EXPECT_EQ(CellsNear(filming.map(), {1.5, 0, 0}, 0.3), 0) << "too few points for a cell";
  filming.Look(scene, pose);
  filming.Film(100);
  // Had the voxel kept its points, these few more would make it a cell.
  filming.Look(with_speck, pose);
  filming.Film();
  EXPECT_EQ(CellsNear(filming.map(), {1.5, 0, 0}, 0.3), 0);
}

}  // namespace
}  // namespace fallen
