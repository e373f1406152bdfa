// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>

#include "fallen/geometry/depth_image.hpp"
#include "fallen/geometry/enum_names.hpp"
#include "fallen/geometry/ground_plane.hpp"
#include "fallen/ndt/ndt_map.hpp"

/// NDT mapping with accumulation over time and occupancy (the paper, Sec. III-B).
///
/// [Einhorn15]   Einhorn, Gross: Generic NDT mapping in dynamic environments and its application
/// for
///               lifelong SLAM. RAS 69, 2015.
/// [Saarinen13]  Saarinen, Andreasson, Stoyanov, Lilienthal: 3D normal distributions transform
///               occupancy maps. IJRR 32(14), 2013.
namespace fallen {

/// What to do without a robot pose.
enum class PoseMode : std::int32_t {
  kSingleFrames = 0,  ///< frames without a pose stand alone
  kFixedCamera = 1,   ///< the camera does not move: frames without a pose accumulate
};
constexpr auto EnumNames(PoseMode) {
  return EnumTable<PoseMode, 2>{
      {{PoseMode::kSingleFrames, "single_frames"}, {PoseMode::kFixedCamera, "fixed_camera"}}};
}

struct NdtConfig {
  double cell_size_m = 0.05;  ///< the paper, Sec. III-B
  bool accumulate = true;     ///< off: every frame makes a fresh map
  PoseMode without_pose = PoseMode::kSingleFrames;
  int min_points = 4;        ///< points in a voxel before it is a cell, >= 3
  double min_range_m = 0.4;  ///< depth along the optical axis
  double max_range_m = 5.0;
  double ground_clearance_m = 0.04;  ///< points below this height above the floor are floor
  /// Added to the clearance per squared metre of range: depth noise grows with z^2 [1/m].
  double ground_clearance_per_sq_m = 0.003;
  double max_height_m = 1.5;      ///< points higher above the floor are left out
  double extent_m = 6.0;          ///< cells farther from the camera horizontally are forgotten
  int max_points_per_cell = 400;  ///< N_max: beyond it old statistics are scaled down [Einhorn15]
  /// lambda >= ratio * lambda_max, from kLeastEigenvalueRatio to 1 [Saarinen13]
  double min_eigenvalue_ratio = 1e-3;
  double hit_log_odds = 0.405465;      ///< log(0.6 / 0.4) per point
  double miss_log_odds = 0.405465;     ///< weight of a ray that surely passed through the cell
  double unseen_miss_log_odds = 0.05;  ///< for voxels that a ray crosses and that hold no Gaussian
  double max_log_odds = 4.0;           ///< clamp, both signs
  /// Gap in the frames' time after which the map starts anew [s]; a clock that runs back does too.
  double max_time_gap_s = 5.0;

  void Validate() const;
  template <class Visitor>
  void Visit(Visitor&& visit) {
    visit("cell_size_m", cell_size_m);
    visit("accumulate", accumulate);
    visit("without_pose", without_pose);
    visit("min_points", min_points);
    visit("min_range_m", min_range_m);
    visit("max_range_m", max_range_m);
    visit("ground_clearance_m", ground_clearance_m);
    visit("ground_clearance_per_sq_m", ground_clearance_per_sq_m);
    visit("max_height_m", max_height_m);
    visit("extent_m", extent_m);
    visit("max_points_per_cell", max_points_per_cell);
    visit("min_eigenvalue_ratio", min_eigenvalue_ratio);
    visit("hit_log_odds", hit_log_odds);
    visit("miss_log_odds", miss_log_odds);
    visit("unseen_miss_log_odds", unseen_miss_log_odds);
    visit("max_log_odds", max_log_odds);
    visit("max_time_gap_s", max_time_gap_s);
  }
};

/// Turns depth images into an accumulated, ground-free, bounded NDT map.
///
/// Guards: the accumulated voxels, their frame and the time of the last frame. Not thread-safe.
class NdtMapper {
 public:
  /// @throws std::invalid_argument if `config` is out of range.
  explicit NdtMapper(const NdtConfig& config = {});
  ~NdtMapper();
  NdtMapper(NdtMapper&&) noexcept;
  NdtMapper& operator=(NdtMapper&&) noexcept;

  /// Adds one image and returns the map as it is then.
  ///
  /// @param utime           Time of measurement [us].
  /// @param T_world_camera  Pose of the camera at `utime`, or nothing if unknown.
  /// @param ground_camera   Floor in the camera frame. Without one (`!ok()`), nothing is taken away
  ///                        and heights are not known: the map's `ground` says so.
  /// @throws std::invalid_argument if `image` is malformed or the pose is not finite.
  /// Deterministic: the same sequence of calls gives bit-identical maps.
  NdtMap Update(std::int64_t utime, const DepthImage& image,
                const std::optional<Eigen::Isometry3d>& T_world_camera,
                const GroundEstimate& ground_camera);
  /// Likewise, into memory that is there. All of `map` is set but its view.
  void Update(std::int64_t utime, const DepthImage& image,
              const std::optional<Eigen::Isometry3d>& T_world_camera,
              const GroundEstimate& ground_camera, NdtMap& map);

  /// Forgets everything.
  void Reset();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fallen
