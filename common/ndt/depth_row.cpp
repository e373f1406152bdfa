// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/ndt/depth_row.hpp"

#include <cstring>

#include "fallen/simd/lanes.hpp"
#include "fallen/simd/simd_level.hpp"

namespace fallen {
namespace {

static_assert(kRowPadding % kPortableLanes == 0 && kRowPadding % kAvx2Lanes == 0);

// Voxel along one axis, and the offset from its centre.
template <class Floats, class Ints>
[[gnu::always_inline]] inline void Split(const Floats& p, const RowGeometry& g, Ints& index,
                                         Floats& offset) {
  const Floats scaled = p * g.inverse_cell_size;
  const Ints truncated = __builtin_convertvector(scaled, Ints);
  index = truncated + (scaled < __builtin_convertvector(truncated, Floats));  // true is -1
  offset = p - (__builtin_convertvector(index, Floats) + 0.5f) * g.cell_size_m;
}

template <int kLanes>
[[gnu::always_inline]] inline void PlaceLanes(const std::uint16_t* depth, int u,
                                              const RowDirections& d, const RowGeometry& g,
                                              const RowPoints& points) {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;
  typename Lanes<kLanes>::Shorts raw;
  Load(raw, depth);
  const Ints units = __builtin_convertvector(raw, Ints);
  const Floats z_m = __builtin_convertvector(units, Floats) * g.depth_unit_m;
  Floats ray_x, ray_y, ray_z;
  Load(ray_x, d.x + u);
  Load(ray_y, d.y + u);
  Load(ray_z, d.z + u);
  ray_x = (ray_x + d.row_x) * z_m;
  ray_y = (ray_y + d.row_y) * z_m;
  ray_z = (ray_z + d.row_z) * z_m;
  const Floats sq_distance = ray_x * ray_x + ray_y * ray_y + g.vertical_weight * (ray_z * ray_z);
  Floats x = ray_x + g.camera_x, y = ray_y + g.camera_y, z = ray_z + g.camera_z;
  const Floats height = g.up_x * x + g.up_y * y + g.up_z * z + g.up_offset;
  const Floats clearance = g.clearance_m + g.clearance_per_sq_m * (z_m * z_m);
  const Ints wanted = (units >= g.min_depth) & (units <= g.max_depth) & (units > 0) &
                      (sq_distance <= g.sq_extent) & (height >= clearance) &
                      (height <= g.max_height_m);
  if (!AnyOf(wanted)) {
    const Ints none = Ints{} + kNoPoint;
    Store(none, points.voxel_x + u);
    return;
  }
  const Floats zero = {};
  x = wanted ? x : zero;  // so that no voxel index overflows
  y = wanted ? y : zero;
  z = wanted ? z : zero;
  Ints index_x, index_y, index_z;
  Floats offset_x, offset_y, offset_z;
  Split(x, g, index_x, offset_x);
  Split(y, g, index_y, offset_y);
  Split(z, g, index_z, offset_z);
  index_x = (index_x & wanted) | (~wanted & kNoPoint);
  Store(index_x, points.voxel_x + u);
  Store(index_y, points.voxel_y + u);
  Store(index_z, points.voxel_z + u);
  Store(offset_x, points.x + u);
  Store(offset_y, points.y + u);
  Store(offset_z, points.z + u);
}

template <int kLanes>
[[gnu::always_inline]] inline void PlacePixels(const std::uint16_t* depth, int count,
                                               const RowDirections& directions,
                                               const RowGeometry& geometry,
                                               const RowPoints& points) {
  const RowGeometry g = geometry;  // a copy, so that no store can seem to change it
  int u = 0;
  for (; u + kLanes <= count; u += kLanes) PlaceLanes<kLanes>(depth + u, u, directions, g, points);
  if (u == count) return;
  std::uint16_t rest[kLanes] = {};
  std::memcpy(rest, depth + u, sizeof(std::uint16_t) * (count - u));
  PlaceLanes<kLanes>(rest, u, directions, g, points);
}

void PlacePixelsPortable(const std::uint16_t* depth, int count, const RowDirections& directions,
                         const RowGeometry& geometry, const RowPoints& points) {
  PlacePixels<kPortableLanes>(depth, count, directions, geometry, points);
}

FALLEN_TARGET_AVX2 void PlacePixelsAvx2(const std::uint16_t* depth, int count,
                                        const RowDirections& directions,
                                        const RowGeometry& geometry, const RowPoints& points) {
  PlacePixels<kAvx2Lanes>(depth, count, directions, geometry, points);
}

}  // namespace

void PlaceRow(const std::uint16_t* depth, int count, const RowDirections& directions,
              const RowGeometry& geometry, const RowPoints& points) {
  ChooseSimd(PlacePixelsPortable, PlacePixelsAvx2, PlacePixelsAvx2)(depth, count, directions,
                                                                    geometry, points);
}

}  // namespace fallen
