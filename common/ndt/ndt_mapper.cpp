// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/ndt_mapper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fallen/ndt/depth_row.hpp"
#include "fallen/ndt/ray_evidence.hpp"
#include "fallen/ndt/voxel_store.hpp"

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

// The camera in the voxel grid. Places are told relative to the voxel that the camera is in, so
// that they keep their digits far from the origin of the map.
struct CameraInGrid {
  VoxelIndex voxel;
  Eigen::Vector3d corner;  // map frame [m]
  Eigen::Matrix3d R_map_camera;
  Eigen::Vector3d position;  // of the camera, from the corner of that voxel [m]
  double cell_size_m;

  CameraInGrid(const Eigen::Isometry3d& T_map_camera, double cell_size)
      : R_map_camera(T_map_camera.linear()), cell_size_m(cell_size) {
    const Eigen::Array3d index = (T_map_camera.translation().array() / cell_size).floor();
    voxel = {static_cast<std::int32_t>(index.x()), static_cast<std::int32_t>(index.y()),
             static_cast<std::int32_t>(index.z())};
    position = (T_map_camera.translation().array() - index * cell_size).matrix();
  }

  /// Centre of a voxel relative to the camera, along the axes of the map [m].
  Eigen::Vector3d CenterFromCamera(const VoxelIndex& index) const {
    const Eigen::Vector3d steps(index.x - voxel.x, index.y - voxel.y, index.z - voxel.z);
    return (steps.array() + 0.5).matrix() * cell_size_m - position;
  }

  /// Mean of a voxel's points relative to the camera, along the axes of the map [m].
  Eigen::Vector3d MeanFromCamera(const Voxel& v) const {
    return CenterFromCamera(v.index) +
           Eigen::Vector3d(v.moments.mean[0], v.moments.mean[1], v.moments.mean[2]);
  }
};

// Mean of a voxel's points, map frame [m]. The same number whatever the camera does.
Eigen::Vector3d MeanOf(const Voxel& voxel, double cell_size_m) {
  const Eigen::Array3d index(voxel.index.x, voxel.index.y, voxel.index.z);
  const auto& offset = voxel.moments.mean;
  return (index + 0.5) * cell_size_m + Eigen::Array3d(offset[0], offset[1], offset[2]);
}

// What is the floor's and what is too high, by a point relative to the camera (axes of the map).
struct HeightLimits {
  Eigen::Vector3d up = Eigen::Vector3d::Zero();
  double camera_height_m = 0;
  // Without a floor, every point is at height 0 and within the limits.
  double clearance_m = -1, clearance_per_sq_m = 0, max_height_m = 1;

  HeightLimits() = default;
  HeightLimits(const Plane& ground_camera, const Eigen::Matrix3d& R_map_camera,
               const NdtConfig& config)
      : up(R_map_camera * ground_camera.normal),
        camera_height_m(ground_camera.offset),
        clearance_m(config.ground_clearance_m),
        clearance_per_sq_m(config.ground_clearance_per_sq_m),
        max_height_m(config.max_height_m) {}

  double HeightOf(const Eigen::Vector3d& from_camera) const {
    return up.dot(from_camera) + camera_height_m;
  }
};

// Σ of the map frame in the camera frame: R^T Σ R.
SymmetricMatrix3 InCameraFrame(const SymmetricMatrix3& m, const Eigen::Matrix3d& R_map_camera) {
  Eigen::Matrix3d full;
  full << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  const Eigen::Matrix3d turned = R_map_camera.transpose() * full * R_map_camera;
  return {turned(0, 0), turned(0, 1), turned(0, 2), turned(1, 1), turned(1, 2), turned(2, 2)};
}

// Buffers for the pixels of one image, kept between frames.
struct RowBuffers {
  std::vector<float> column_x, column_y, column_z;  // directions of the rays, column part
  std::vector<std::int32_t> voxel_x, voxel_y, voxel_z;
  std::vector<float> x, y, z;

  void Resize(std::size_t image_width) {
    const std::size_t width = (image_width + kRowPadding - 1) / kRowPadding * kRowPadding;
    for (auto* floats : {&column_x, &column_y, &column_z, &x, &y, &z}) floats->resize(width);
    for (auto* indices : {&voxel_x, &voxel_y, &voxel_z}) indices->resize(width);
  }
};

// Where voxels were found a little while ago: depth that jumps to and fro between voxels, and the
// next row, find them again without a search. An entry is a guess, to be checked.
class RecentVoxels {
 public:
  std::int32_t& Slot(const VoxelIndex& local) {
    const auto mix = static_cast<std::uint32_t>(local.x + 37 * local.y + 211 * local.z);
    return positions_[mix % kSlots];
  }

 private:
  static constexpr std::uint32_t kSlots = 2048;  // 8 kB, a part of the first cache
  std::array<std::int32_t, kSlots> positions_{};
};

}  // namespace

struct NdtMapper::State {
  NdtConfig config;
  VoxelStore store;
  RowBuffers rows;
  RecentVoxels recent;
  std::optional<MapFrame> frame;                                  // nothing before the first image
  Eigen::Isometry3d T_map_fixed = Eigen::Isometry3d::Identity();  // of a camera that does not move
  std::int64_t utime = 0;

  bool ContinuesMap(std::int64_t new_utime, MapFrame new_frame) const {
    if (!config.accumulate || frame != new_frame || new_utime < utime) return false;
    if (new_frame != MapFrame::kWorld && config.without_pose == PoseMode::kSingleFrames)
      return false;
    // Through double, so that no difference of two times overflows.
    const double gap_s = 1e-6 * (static_cast<double>(new_utime) - static_cast<double>(utime));
    return gap_s <= config.max_time_gap_s;
  }

  bool HorizontalExtent() const { return frame != MapFrame::kCamera; }

  void AddPoints(const DepthImage& image, const CameraInGrid& camera, const HeightLimits& limits,
                 bool ground_known);
  void AddRow(const RowPoints& points, int width, const VoxelIndex& origin, bool may_hold_floor);
  void MergeIncoming(const DepthImage& image, const CameraInGrid& camera,
                     const HeightLimits& limits, bool ground_known);
  bool IsForgotten(Voxel& voxel, const DepthImage& image, const CameraInGrid& camera,
                   const HeightLimits& limits, bool ground_known) const;
  std::vector<NdtCell> Cells(const CameraInGrid& camera, const HeightLimits& limits) const;
};

// From pixels to sums in voxels. Neighbouring pixels mostly fall into one voxel: their sums are
// made in registers, and the voxel is looked up once a run.
void NdtMapper::State::AddPoints(const DepthImage& image, const CameraInGrid& camera,
                                 const HeightLimits& limits, bool ground_known) {
  const CameraIntrinsics& pinhole = image.intrinsics;
  const auto as_units = [&](double metres) { return metres / image.depth_unit_m; };
  constexpr double kMaxUnits = std::numeric_limits<std::uint16_t>::max();
  if (as_units(config.min_range_m) > kMaxUnits) return;
  RowGeometry geometry;
  geometry.depth_unit_m = static_cast<float>(image.depth_unit_m);
  geometry.min_depth = static_cast<std::uint16_t>(std::ceil(as_units(config.min_range_m)));
  geometry.max_depth =
      static_cast<std::uint16_t>(std::min(kMaxUnits, std::floor(as_units(config.max_range_m))));
  geometry.camera_x = static_cast<float>(camera.position.x());
  geometry.camera_y = static_cast<float>(camera.position.y());
  geometry.camera_z = static_cast<float>(camera.position.z());
  geometry.up_x = static_cast<float>(limits.up.x());
  geometry.up_y = static_cast<float>(limits.up.y());
  geometry.up_z = static_cast<float>(limits.up.z());
  geometry.up_offset = static_cast<float>(limits.camera_height_m - limits.up.dot(camera.position));
  geometry.clearance_m = static_cast<float>(limits.clearance_m);
  geometry.clearance_per_sq_m = static_cast<float>(limits.clearance_per_sq_m);
  geometry.max_height_m = static_cast<float>(limits.max_height_m);
  geometry.sq_extent = static_cast<float>(config.extent_m * config.extent_m);
  geometry.vertical_weight = HorizontalExtent() ? 0.0f : 1.0f;
  geometry.cell_size_m = static_cast<float>(config.cell_size_m);
  geometry.inverse_cell_size = static_cast<float>(1 / config.cell_size_m);

  rows.Resize(pinhole.width);
  for (int u = 0; u < pinhole.width; ++u) {
    const Eigen::Vector3d along = camera.R_map_camera.col(0) * ((u - pinhole.cx) / pinhole.fx);
    rows.column_x[u] = static_cast<float>(along.x());
    rows.column_y[u] = static_cast<float>(along.y());
    rows.column_z[u] = static_cast<float>(along.z());
  }
  const RowPoints points = {rows.voxel_x.data(), rows.voxel_y.data(), rows.voxel_z.data(),
                            rows.x.data(),       rows.y.data(),       rows.z.data()};
  for (int v = 0; v < pinhole.height; ++v) {
    const Eigen::Vector3d along =
        camera.R_map_camera.col(1) * ((v - pinhole.cy) / pinhole.fy) + camera.R_map_camera.col(2);
    const RowDirections directions = {rows.column_x.data(),          rows.column_y.data(),
                                      rows.column_z.data(),          static_cast<float>(along.x()),
                                      static_cast<float>(along.y()), static_cast<float>(along.z())};
    PlaceRow(image.depth.data() + static_cast<std::size_t>(v) * pinhole.width, pinhole.width,
             directions, geometry, points);
    AddRow(points, pinhole.width, camera.voxel, !ground_known);
  }
}

void NdtMapper::State::AddRow(const RowPoints& points, int width, const VoxelIndex& origin,
                              bool may_hold_floor) {
  const RowPoints p = points;  // a copy, and so not changed by what is written below
  for (int u = 0; u < width;) {
    const VoxelIndex local = {p.voxel_x[u], p.voxel_y[u], p.voxel_z[u]};
    if (local.x == kNoPoint) {
      ++u;
      continue;
    }
    PointSums<float> run;
    do {
      run.Add(p.x[u], p.y[u], p.z[u]);
      ++u;
    } while (u < width &&
             ((p.voxel_x[u] ^ local.x) | (p.voxel_y[u] ^ local.y) | (p.voxel_z[u] ^ local.z)) == 0);
    std::int32_t& known = recent.Slot(local);
    const std::int32_t position =
        store.FindOrAdd({origin.x + local.x, origin.y + local.y, origin.z + local.z}, known);
    known = position;
    Voxel& voxel = store.voxels()[position];
    voxel.incoming.Add(run);
    voxel.may_hold_floor |= may_hold_floor;
  }
}

// True for a voxel that goes: out of reach, seen through, or perhaps the floor's.
bool NdtMapper::State::IsForgotten(Voxel& voxel, const DepthImage& image,
                                   const CameraInGrid& camera, const HeightLimits& limits,
                                   bool ground_known) const {
  // With that many hits the rays that went through cannot outweigh them.
  const bool is_surely_hit = voxel.incoming.count >= kRaysPerVoxel;
  // Points of this frame are neither out of reach nor, where it is known, the floor's.
  if (is_surely_hit && voxel.moments.count == voxel.incoming.count) return false;
  const Eigen::Vector3d mean_from_camera = camera.MeanFromCamera(voxel);
  const double sq_distance = HorizontalExtent() ? mean_from_camera.head<2>().squaredNorm()
                                                : mean_from_camera.squaredNorm();
  if (sq_distance > config.extent_m * config.extent_m) return true;

  const Eigen::Vector3d mean_camera = camera.R_map_camera.transpose() * mean_from_camera;
  if (voxel.may_hold_floor && ground_known) {
    const double clearance =
        limits.clearance_m + limits.clearance_per_sq_m * mean_camera.z() * mean_camera.z();
    if (limits.HeightOf(mean_from_camera) < clearance) return true;
  }
  if (is_surely_hit) return false;
  if (voxel.moments.count < config.min_points) {
    if (voxel.incoming.count > 0) return false;
    const Eigen::Vector3d center =
        camera.R_map_camera.transpose() * camera.CenterFromCamera(voxel.index);
    if (RayPassesCenter(image, center, config.cell_size_m))
      voxel.log_odds -= config.unseen_miss_log_odds;
  } else {
    const SymmetricMatrix3 covariance =
        InCameraFrame(voxel.moments.Covariance(), camera.R_map_camera);
    voxel.log_odds -=
        config.miss_log_odds * CountRaysThrough(image, mean_camera, covariance, config.cell_size_m);
  }
  return voxel.log_odds < 0;
}

void NdtMapper::State::MergeIncoming(const DepthImage& image, const CameraInGrid& camera,
                                     const HeightLimits& limits, bool ground_known) {
  for (Voxel& voxel : store.voxels()) {
    if (voxel.incoming.count == 0) continue;
    voxel.moments = Merge(voxel.moments, MomentsOf(voxel.incoming));
    LimitCount(voxel.moments, config.max_points_per_cell);
    voxel.log_odds =
        std::min(config.max_log_odds, voxel.log_odds + config.hit_log_odds * voxel.incoming.count);
  }
  store.RemoveIf(
      [&](Voxel& voxel) { return IsForgotten(voxel, image, camera, limits, ground_known); });
  for (Voxel& voxel : store.voxels()) voxel.incoming = {};
}

std::vector<NdtCell> NdtMapper::State::Cells(const CameraInGrid& camera,
                                             const HeightLimits& limits) const {
  std::vector<NdtCell> cells;
  cells.reserve(store.voxels().size());
  for (const Voxel& voxel : store.voxels()) {
    if (voxel.moments.count < config.min_points) continue;
    const Eigen::Vector3d mean_from_camera = camera.MeanFromCamera(voxel);
    const double height = limits.HeightOf(mean_from_camera);
    if (height < limits.clearance_m || height > limits.max_height_m) continue;
    NdtCell& cell = cells.emplace_back();
    cell.mean = MeanOf(voxel, config.cell_size_m).cast<float>();
    const SymmetricMatrix3 covariance =
        FloorEigenvalues(voxel.moments.Covariance(), config.min_eigenvalue_ratio);
    for (int k = 0; k < 6; ++k) cell.covariance[k] = static_cast<float>(covariance[k]);
    cell.point_count = static_cast<std::uint32_t>(std::lround(voxel.moments.count));
    cell.occupancy = static_cast<float>(voxel.log_odds);
  }
  return cells;
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

  NdtMap map;
  map.cell_size_m = config.cell_size_m;
  map.frame = frame;
  map.T_map_camera = T_world_camera ? *T_world_camera : state_->T_map_fixed;
  map.ground = ground_camera;
  if (map.ground.ok()) map.ground.plane = TransformPlane(map.T_map_camera, ground_camera.plane);

  const CameraInGrid camera(map.T_map_camera, config.cell_size_m);
  const HeightLimits limits = ground_camera.ok()
                                  ? HeightLimits(ground_camera.plane, camera.R_map_camera, config)
                                  : HeightLimits();
  state_->AddPoints(image, camera, limits, ground_camera.ok());
  state_->MergeIncoming(image, camera, limits, ground_camera.ok());
  map.cells = state_->Cells(camera, limits);
  return map;
}

}  // namespace fallen
