// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/image_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fallen/simd/lanes.hpp"

namespace fallen {
namespace {

constexpr double kMaxUnits = std::numeric_limits<std::uint16_t>::max();

RowGeometry MakeRowGeometry(const DepthImage& image, const GridCamera& camera,
                            const HeightLimits& limits, bool horizontal_extent,
                            const NdtConfig& config) {
  const auto as_units = [&](double metres) { return metres / image.depth_unit_m; };
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
  geometry.vertical_weight = horizontal_extent ? 0.0f : 1.0f;
  geometry.cell_size_m = static_cast<float>(config.cell_size_m);
  geometry.inverse_cell_size = static_cast<float>(1 / config.cell_size_m);
  return geometry;
}

void AddSums(const RunSums& run, IncomingPoints& incoming) {
  using Quad = Lanes<kPortableLanes>::Floats;
  static_assert(kPortableLanes == 4);
  Quad with_one, with_x, with_y, with_z;
  Load(with_one, run.data());
  Load(with_x, run.data() + 4);
  Load(with_y, run.data() + 8);
  Load(with_z, run.data() + 12);
  const Quad added[] = {with_one, __builtin_shufflevector(with_x, with_y, 0, 1, 5, 6),
                        __builtin_shufflevector(with_x, with_z, 2, 2, 6, 6)};
  for (std::size_t k = 0; k < 3; ++k) {
    Quad sums;
    Load(sums, incoming.sums.data() + 4 * k);
    Store(Quad(sums + added[k]), incoming.sums.data() + 4 * k);
  }
}

}  // namespace

RowPoints ImagePoints::Resize(std::size_t image_width) {
  const std::size_t width = (image_width + kRowPadding - 1) / kRowPadding * kRowPadding;
  for (auto* floats : {&column_x_, &column_y_, &column_z_}) floats->resize(width);
  for (auto* indices : {&voxel_x_, &voxel_y_, &voxel_z_}) indices->resize(1 + width);
  offsets_.resize(4 * width);
  run_first_.resize(width + 1 + kRowPadding);
  run_sums_.resize(width + 1);
  return {voxel_x_.data() + 1, voxel_y_.data() + 1, voxel_z_.data() + 1, offsets_.data()};
}

void ImagePoints::FindColumnDirections(const CameraIntrinsics& pinhole,
                                       const Eigen::Matrix3d& R_map_camera) {
  for (int u = 0; u < pinhole.width; ++u) {
    const Eigen::Vector3d along = R_map_camera.col(0) * ((u - pinhole.cx) / pinhole.fx);
    column_x_[u] = static_cast<float>(along.x());
    column_y_[u] = static_cast<float>(along.y());
    column_z_[u] = static_cast<float>(along.z());
  }
}

void ImagePoints::AddTo(VoxelStore& store, const DepthImage& image, const GridCamera& camera,
                        const HeightLimits& limits, bool horizontal_extent,
                        const NdtConfig& config) {
  if (config.min_range_m / image.depth_unit_m > kMaxUnits) return;
  const RowGeometry geometry = MakeRowGeometry(image, camera, limits, horizontal_extent, config);
  const CameraIntrinsics& pinhole = image.intrinsics;
  const RowPoints points = Resize(pinhole.width);
  FindColumnDirections(pinhole, camera.R_map_camera);
  for (int v = 0; v < pinhole.height; ++v) {
    const Eigen::Vector3d along =
        camera.R_map_camera.col(1) * ((v - pinhole.cy) / pinhole.fy) + camera.R_map_camera.col(2);
    const RowDirections directions = {column_x_.data(),
                                      column_y_.data(),
                                      column_z_.data(),
                                      static_cast<float>(along.x()),
                                      static_cast<float>(along.y()),
                                      static_cast<float>(along.z())};
    const int run_count =
        SumRowRuns(image.depth.data() + static_cast<std::size_t>(v) * pinhole.width, pinhole.width,
                   directions, geometry, points, {run_first_.data(), run_sums_.data()});
    for (int run = 0; run < run_count; ++run) {
      const std::int32_t u = run_first_[run];
      const VoxelIndex local = {points.voxel_x[u], points.voxel_y[u], points.voxel_z[u]};
      std::int32_t& recent = RecentPosition(local);
      recent = store.FindOrAdd(
          {camera.voxel.x + local.x, camera.voxel.y + local.y, camera.voxel.z + local.z}, recent);
      AddSums(run_sums_[run], store.incoming()[recent]);
    }
  }
}

}  // namespace fallen
