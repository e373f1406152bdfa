// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "tools/simulate/depth_sensor.hpp"
#include "tools/simulate/robot_path.hpp"
#include "tools/simulate/scenario.hpp"
#include "tools/simulate/scene.hpp"
#include "tools/simulate/settling.hpp"

namespace fallen::sim {

/// Meshes and catalogues that all scenarios share.
struct Assets {
  HumanModel humans;
  FurnitureCatalogue furniture;
};

/// Folder that tools/fetch-assets fills: `given`, else $FALLEN_ASSETS, else assets/ in the source
/// tree.
std::filesystem::path AssetsFolder(const std::optional<std::filesystem::path>& given);
Assets LoadAssets(const std::filesystem::path& folder);

/// One picture with all that is true about it.
struct Frame {
  std::int64_t utime = 0;
  SensorImage image;
  RobotPose true_pose;  ///< where the robot was
  RobotPose told_pose;  ///< where it thinks it was
};

/// A scenario with its scene built and its drive planned; pictures are taken one by one.
class Simulation {
 public:
  /// @throws std::runtime_error if assets are broken or the room has no place for the person.
  Simulation(const Scenario& scenario, const Assets& assets);
  ~Simulation();

  /// Picture `index` in [0, scenario.frames). Thread-safe; depends on nothing but scenario and
  /// index.
  Frame TakeFrame(int index) const;

  /// Of the person that lies within picture `index`, the share that nothing stands before: 0 if
  /// there is none.
  double VisibleShare(int index) const;

  const Scenario& scenario() const { return scenario_; }
  /// At the beginning.
  const Scene& scene() const { return scene_; }
  /// Index of the fallen person in that scene's objects, if there is one.
  std::optional<std::size_t> person_index() const { return person_; }
  /// Whether picture `index` shows a time when somebody lies on the floor.
  bool IsSomebodyLying(int index) const;
  /// What is there in picture `index`.
  const Scene& SceneAt(int index) const;
  const SettledPose& settled() const { return settled_; }
  Placement placement_reached() const { return placement_reached_; }
  const std::vector<RobotPose>& path() const { return path_; }
  /// Mounting that the messages tell; the true one may differ.
  Eigen::Isometry3d told_T_robot_camera() const { return told_T_robot_camera_; }

 private:
  void AddPerson(const Assets& assets, ColumnGrid& grid);
  void AddDistractors(const Assets& assets, ColumnGrid& grid);
  /// Plans what becomes of the person who gets up; `grid` gets the place where that person stands.
  void LetGetUp(const Assets& assets, ColumnGrid& grid);

  std::optional<FloorPose> PlaceDistractor(const TriangleMesh& mesh, const ColumnGrid& grid,
                                           Random& random) const;

  /// What the robot is to look at: the person, else one of the distractors, else nothing.
  const SceneObject* DrawTarget(Random random) const;

  Scenario scenario_;
  Sensor sensor_;
  Scene scene_;
  std::optional<std::size_t> person_;
  SettledPose settled_;
  Placement placement_reached_ = Placement::kFree;
  Eigen::Isometry3d true_T_robot_camera_, told_T_robot_camera_;
  std::vector<RobotPose> path_, told_path_;
  /// The room after the person has got up, with its caster; none if nobody does.
  struct Later {
    Scene scene;
    std::unique_ptr<RayCaster> caster;
  };
  std::optional<Later> later_;
  std::unique_ptr<RayCaster> caster_;

  const RayCaster& CasterAt(int index) const;
};

/// Camera on a robot, looking ahead: T_robot_camera, optical frame.
Eigen::Isometry3d MakeMounting(double height_m, double pitch_rad);

Eigen::Isometry3d ToTransform(const RobotPose& pose);

/// Time of the first picture [us]: 2026-01-01 00:00 UTC.
inline constexpr std::int64_t kEpochUtime = 1767225600000000;

}  // namespace fallen::sim
