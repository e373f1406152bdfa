// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ndt_mapper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "fallen/ndt/eigenvalue_floor.hpp"
#include "fallen/ndt/grid_camera.hpp"
#include "fallen/ndt/image_points.hpp"
#include "fallen/ndt/ray_evidence.hpp"

namespace fallen {
namespace {

// Voxel indices stay far within 32 bits; a pose beyond it is a defect of the pose.
constexpr double kMaxTranslation_m = 1e6;
// Departure from a rotation that rounding in the pose's producer explains.
constexpr double kRotationTolerance = 1e-3;

void RequirePose(const Eigen::Isometry3d& T_world_camera) {
  if (!T_world_camera.matrix().allFinite())
    throw std::invalid_argument("ndt: pose of the camera is not finite");
  if (T_world_camera.translation().cwiseAbs().maxCoeff() > kMaxTranslation_m)
    throw std::invalid_argument("ndt: pose of the camera is farther than 1e6 m from the origin");
  if (!T_world_camera.linear().isUnitary(kRotationTolerance))
    throw std::invalid_argument("ndt: pose of the camera holds no rotation");
}

void RequireGround(const GroundEstimate& ground) {
  if (!ground.ok()) return;
  if (!ground.plane.normal.allFinite() || !std::isfinite(ground.plane.offset) ||
      std::abs(ground.plane.normal.norm() - 1) > kRotationTolerance)
    throw std::invalid_argument("ndt: ground plane is not finite or its normal not of unit length");
}

MapFrame FrameOf(const std::optional<Eigen::Isometry3d>& T_world_camera,
                 const GroundEstimate& ground) {
  if (T_world_camera) return MapFrame::kWorld;
  return ground.ok() ? MapFrame::kLevel : MapFrame::kCamera;
}

// Mean of a voxel's points, map frame [m]. The same number whatever the camera does.
Eigen::Vector3d MeanOf(const Voxel& voxel, double cell_size_m) {
  const Eigen::Array3d index(voxel.index.x, voxel.index.y, voxel.index.z);
  const auto& offset = voxel.moments.mean;
  return (index + 0.5) * cell_size_m + Eigen::Array3d(offset[0], offset[1], offset[2]);
}

// Σ of the map frame in the camera frame: R^T Σ R.
SymmetricMatrix3 InCameraFrame(const SymmetricMatrix3& m, const Eigen::Matrix3d& R_map_camera) {
  Eigen::Matrix3d full;
  full << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  const Eigen::Matrix3d turned = R_map_camera.transpose() * full * R_map_camera;
  return {turned(0, 0), turned(0, 1), turned(0, 2), turned(1, 1), turned(1, 2), turned(2, 2)};
}

PointSums<double> SumsOf(const IncomingPoints& points) {
  const auto& s = points.sums;
  return {s[3], {s[0], s[1], s[2]}, {s[4], s[5], s[8], s[6], s[7], s[10]}};
}

}  // namespace

struct NdtMapper::State {
  // What the newest frame says about voxels.
  struct FrameView {
    const DepthImage& image;
    const GridCamera& camera;
    const HeightLimits& limits;
    bool ground_known;
  };

  NdtConfig config;
  VoxelStore store;
  ImagePoints points;
  std::optional<MapFrame> frame;                                  // nothing before the first image
  Eigen::Isometry3d T_map_fixed = Eigen::Isometry3d::Identity();  // of a camera that does not move
  std::int64_t utime = 0;
  std::vector<std::int32_t> changed;  // positions of the voxels whose cells this frame changed

  bool ContinuesMap(std::int64_t new_utime, MapFrame new_frame) const {
    if (!config.accumulate || frame != new_frame || new_utime < utime) return false;
    if (new_frame != MapFrame::kWorld && config.without_pose == PoseMode::kSingleFrames)
      return false;
    // Through double, so that no difference of two times overflows.
    const double gap_s = 1e-6 * (static_cast<double>(new_utime) - static_cast<double>(utime));
    return gap_s <= config.max_time_gap_s;
  }

  bool HorizontalExtent() const { return frame != MapFrame::kCamera; }

  void MergePoints(Voxel& voxel, IncomingPoints& incoming, bool ground_known) const;
  bool IsForgotten(Voxel& voxel, double new_points, const FrameView& view) const;
  void MergeIncoming(const FrameView& view);
  void UpdateCells();
  void WriteCells(const FrameView& view, std::vector<NdtCell>& cells) const;
};

void NdtMapper::State::MergePoints(Voxel& voxel, IncomingPoints& incoming,
                                   bool ground_known) const {
  const double count = incoming.count();
  voxel.moments = Merge(voxel.moments, MomentsOf(SumsOf(incoming)));
  LimitCount(voxel.moments, config.max_points_per_cell);
  voxel.log_odds = std::min(config.max_log_odds, voxel.log_odds + config.hit_log_odds * count);
  voxel.may_hold_floor |= !ground_known;
  incoming.sums = {};
}

// True for a voxel that goes: out of reach, seen through, or perhaps the floor's.
bool NdtMapper::State::IsForgotten(Voxel& voxel, double new_points, const FrameView& view) const {
  // With that many hits the rays that went through cannot outweigh them.
  const bool is_surely_hit = new_points >= kRaysPerVoxel;
  // Points of this frame are neither out of reach nor, where it is known, the floor's.
  if (is_surely_hit && voxel.moments.count == new_points) return false;
  const GridCamera& camera = view.camera;
  const Eigen::Vector3d mean_from_camera = camera.MeanFromCamera(voxel);
  const double sq_distance = HorizontalExtent() ? mean_from_camera.head<2>().squaredNorm()
                                                : mean_from_camera.squaredNorm();
  if (sq_distance > config.extent_m * config.extent_m) return true;

  const Eigen::Vector3d mean_camera = camera.R_map_camera.transpose() * mean_from_camera;
  if (voxel.may_hold_floor && view.ground_known) {
    const HeightLimits& limits = view.limits;
    const double clearance =
        limits.clearance_m + limits.clearance_per_sq_m * mean_camera.z() * mean_camera.z();
    if (limits.HeightOf(mean_from_camera) < clearance) return true;
  }
  if (is_surely_hit) return false;
  if (voxel.moments.count < config.min_points) {
    if (new_points > 0) return false;
    const Eigen::Vector3d center =
        camera.R_map_camera.transpose() * camera.CenterFromCamera(voxel.index);
    if (RayPassesCenter(view.image, center, config.cell_size_m))
      voxel.log_odds -= config.unseen_miss_log_odds;
  } else if (AnyRayEndsBehind(view.image, mean_camera, config.cell_size_m)) {
    const SymmetricMatrix3 covariance =
        InCameraFrame(voxel.moments.Covariance(), camera.R_map_camera);
    voxel.log_odds -= config.miss_log_odds *
                      CountRaysThrough(view.image, mean_camera, covariance, config.cell_size_m);
  }
  return voxel.log_odds < 0;
}

void NdtMapper::State::MergeIncoming(const FrameView& view) {
  changed.clear();
  for (std::int32_t i = 0; i < store.size();) {
    Voxel& voxel = store.voxels()[i];
    IncomingPoints& incoming = store.incoming()[i];
    const double new_points = incoming.count();
    if (new_points > 0) MergePoints(voxel, incoming, view.ground_known);
    if (IsForgotten(voxel, new_points, view)) {
      store.Remove(i);  // the last voxel comes here, and is next
      continue;
    }
    if (new_points > 0 && voxel.moments.count >= config.min_points) changed.push_back(i);
    ++i;
  }
}

// Makes the cells of the voxels whose points changed. Many are thin as the depth's steps are, and
// so to be floored: that is done side by side.
void NdtMapper::State::UpdateCells() {
  CovarianceLanes lanes;
  std::array<std::int32_t, CovarianceLanes::kCount> thin;
  std::size_t thin_count = 0;
  const auto floor_lanes = [&] {
    FloorEigenvalueLanes(lanes, config.min_eigenvalue_ratio);
    for (std::size_t lane = 0; lane < thin_count; ++lane)
      for (std::size_t k = 0; k < 6; ++k)
        store.voxels()[thin[lane]].cell.covariance[k] =
            static_cast<float>(lanes.coefficients[k][lane]);
    thin_count = 0;
  };
  for (const std::int32_t position : changed) {
    Voxel& voxel = store.voxels()[position];
    const SymmetricMatrix3 covariance = voxel.moments.Covariance();
    voxel.cell.mean = MeanOf(voxel, config.cell_size_m).cast<float>();
    voxel.cell.point_count = static_cast<std::uint32_t>(std::lround(voxel.moments.count));
    if (EigenvaluesSurelyStay(covariance, config.min_eigenvalue_ratio)) {
      for (int k = 0; k < 6; ++k) voxel.cell.covariance[k] = static_cast<float>(covariance[k]);
      continue;
    }
    for (std::size_t k = 0; k < 6; ++k) lanes.coefficients[k][thin_count] = covariance[k];
    thin[thin_count] = position;
    if (++thin_count == thin.size()) floor_lanes();
  }
  if (thin_count > 0) floor_lanes();
}

void NdtMapper::State::WriteCells(const FrameView& view, std::vector<NdtCell>& cells) const {
  cells.clear();
  for (const Voxel& voxel : store.voxels()) {
    if (voxel.moments.count < config.min_points) continue;
    const double height = view.limits.HeightOf(view.camera.MeanFromCamera(voxel));
    if (height < view.limits.clearance_m || height > view.limits.max_height_m) continue;
    cells.push_back(voxel.cell);
    cells.back().occupancy = static_cast<float>(voxel.log_odds);
  }
}

NdtMapper::NdtMapper(const NdtConfig& config) {
  config.Validate();
  state_ = std::make_unique<State>();
  state_->config = config;
}

NdtMapper::~NdtMapper() = default;
NdtMapper::NdtMapper(NdtMapper&&) noexcept = default;
NdtMapper& NdtMapper::operator=(NdtMapper&&) noexcept = default;

void NdtMapper::Reset() {
  state_->store.Clear();
  state_->frame.reset();
}

NdtMap NdtMapper::Update(std::int64_t utime, const DepthImage& image,
                         const std::optional<Eigen::Isometry3d>& T_world_camera,
                         const GroundEstimate& ground_camera) {
  NdtMap map;
  Update(utime, image, T_world_camera, ground_camera, map);
  return map;
}

void NdtMapper::Update(std::int64_t utime, const DepthImage& image,
                       const std::optional<Eigen::Isometry3d>& T_world_camera,
                       const GroundEstimate& ground_camera, NdtMap& map) {
  image.Validate();
  if (T_world_camera) RequirePose(*T_world_camera);
  RequireGround(ground_camera);

  const NdtConfig& config = state_->config;
  const MapFrame frame = FrameOf(T_world_camera, ground_camera);
  if (!state_->ContinuesMap(utime, frame)) {
    Reset();
    // A camera that does not move keeps the frame of its first image, however its floor jitters.
    state_->T_map_fixed = frame == MapFrame::kLevel ? LevelFrameFromGround(ground_camera.plane)
                                                    : Eigen::Isometry3d::Identity();
  }
  state_->frame = frame;
  state_->utime = utime;

  map.cell_size_m = config.cell_size_m;
  map.frame = frame;
  map.T_map_camera = T_world_camera ? *T_world_camera : state_->T_map_fixed;
  map.ground = ground_camera;
  if (map.ground.ok()) map.ground.plane = TransformPlane(map.T_map_camera, ground_camera.plane);

  const GridCamera camera(map.T_map_camera, config.cell_size_m);
  const HeightLimits limits = ground_camera.ok()
                                  ? HeightLimits(ground_camera.plane, camera.R_map_camera, config)
                                  : HeightLimits();
  const State::FrameView view = {image, camera, limits, ground_camera.ok()};
  state_->points.AddTo(state_->store, image, camera, limits, state_->HorizontalExtent(), config);
  state_->MergeIncoming(view);
  state_->UpdateCells();
  state_->WriteCells(view, map.cells);
}

}  // namespace fallen
