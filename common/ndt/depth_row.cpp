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

// Writes x, y, z and 1 of each lane one after the other.
template <int kLanes, class Floats>
[[gnu::always_inline]] inline void StorePoints(const Floats& x, const Floats& y, const Floats& z,
                                               float* to) {
  const Floats one = Floats{} + 1.0f;
  if constexpr (kLanes == 4) {
    const Floats xy_low = __builtin_shufflevector(x, y, 0, 4, 1, 5);
    const Floats xy_high = __builtin_shufflevector(x, y, 2, 6, 3, 7);
    const Floats z1_low = __builtin_shufflevector(z, one, 0, 4, 1, 5);
    const Floats z1_high = __builtin_shufflevector(z, one, 2, 6, 3, 7);
    Store(Floats(__builtin_shufflevector(xy_low, z1_low, 0, 1, 4, 5)), to);
    Store(Floats(__builtin_shufflevector(xy_low, z1_low, 2, 3, 6, 7)), to + 4);
    Store(Floats(__builtin_shufflevector(xy_high, z1_high, 0, 1, 4, 5)), to + 8);
    Store(Floats(__builtin_shufflevector(xy_high, z1_high, 2, 3, 6, 7)), to + 12);
  } else {
    // Within each half of the register, as the processor likes it; then halves are exchanged.
    const Floats xy_low = __builtin_shufflevector(x, y, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats xy_high = __builtin_shufflevector(x, y, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats z1_low = __builtin_shufflevector(z, one, 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats z1_high = __builtin_shufflevector(z, one, 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats p04 = __builtin_shufflevector(xy_low, z1_low, 0, 1, 8, 9, 4, 5, 12, 13);
    const Floats p15 = __builtin_shufflevector(xy_low, z1_low, 2, 3, 10, 11, 6, 7, 14, 15);
    const Floats p26 = __builtin_shufflevector(xy_high, z1_high, 0, 1, 8, 9, 4, 5, 12, 13);
    const Floats p37 = __builtin_shufflevector(xy_high, z1_high, 2, 3, 10, 11, 6, 7, 14, 15);
    Store(Floats(__builtin_shufflevector(p04, p15, 0, 1, 2, 3, 8, 9, 10, 11)), to);
    Store(Floats(__builtin_shufflevector(p26, p37, 0, 1, 2, 3, 8, 9, 10, 11)), to + 8);
    Store(Floats(__builtin_shufflevector(p04, p15, 4, 5, 6, 7, 12, 13, 14, 15)), to + 16);
    Store(Floats(__builtin_shufflevector(p26, p37, 4, 5, 6, 7, 12, 13, 14, 15)), to + 24);
  }
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
  StorePoints<kLanes>(offset_x, offset_y, offset_z, points.offset + 4 * u);
}

template <int kLanes>
[[gnu::always_inline]] inline void PlacePixels(const std::uint16_t* depth, int count,
                                               const RowDirections& directions,
                                               const RowGeometry& g, const RowPoints& points) {
  int u = 0;
  for (; u + kLanes <= count; u += kLanes) PlaceLanes<kLanes>(depth + u, u, directions, g, points);
  if (u == count) return;
  std::uint16_t rest[kLanes] = {};
  std::memcpy(rest, depth + u, sizeof(std::uint16_t) * (count - u));
  PlaceLanes<kLanes>(rest, u, directions, g, points);
}

// Products of a point with 1, x, y and z, of which a register holds kLanes / 4: those of `part`.
template <int kPart>
[[gnu::always_inline]] inline void Products(const Lanes<4>::Floats& p, Lanes<4>::Floats& products) {
  products = p * __builtin_shufflevector(p, p, (kPart + 3) % 4, (kPart + 3) % 4, (kPart + 3) % 4,
                                         (kPart + 3) % 4);
}
template <int kPart>
[[gnu::always_inline]] inline void Products(const Lanes<4>::Floats& p, Lanes<8>::Floats& products) {
  constexpr int kFirst = (2 * kPart + 3) % 4, kSecond = 2 * kPart;
  products = __builtin_shufflevector(p, p, 0, 1, 2, 3, 0, 1, 2, 3) *
             __builtin_shufflevector(p, p, kFirst, kFirst, kFirst, kFirst, kSecond, kSecond,
                                     kSecond, kSecond);
}

// The sums of the run that a row is in.
template <int kLanes>
struct Sums {
  using Floats = typename Lanes<kLanes>::Floats;
  using Ints = typename Lanes<kLanes>::Ints;
  static constexpr int kParts = 16 / kLanes;
  Floats parts[kParts] = {};

  // Begins anew if `starts` is true, which is -1.
  template <int kPart = 0>
  [[gnu::always_inline]] void Add(const Lanes<4>::Floats& point, std::int32_t starts, float* to) {
    if constexpr (kPart < kParts) {
      Floats products;
      Products<kPart>(point, products);
      const Ints keeps = ~(Ints{} + starts);
      parts[kPart] = reinterpret_cast<Floats>(reinterpret_cast<Ints>(parts[kPart]) & keeps);
      parts[kPart] += products;
      Store(parts[kPart], to + kPart * kLanes);
      Add<kPart + 1>(point, starts, to);
    }
  }
};

// Nothing branches on where runs begin, which no processor can foresee: every pixel writes the sums
// of its run so far, and the next pixel of the run writes over them.
template <int kLanes>
[[gnu::always_inline]] inline int SumRuns(const RowPoints& p, int count, const RowRuns& runs) {
  using Ints = typename Lanes<kLanes>::Ints;
  Sums<kLanes> sums;
  int found = 0;
  for (int u = 0; u < count; u += kLanes) {
    Ints x, y, z, before_x, before_y, before_z;
    Load(x, p.voxel_x + u);
    const Ints is_point = x != kNoPoint;
    if (!AnyOf(is_point)) continue;
    Load(y, p.voxel_y + u);
    Load(z, p.voxel_z + u);
    Load(before_x, p.voxel_x + u - 1);
    Load(before_y, p.voxel_y + u - 1);
    Load(before_z, p.voxel_z + u - 1);
    const Ints differs = ((x ^ before_x) | (y ^ before_y) | (z ^ before_z)) != 0;
    std::int32_t starts[kLanes], keeps[kLanes];
    Store(Ints(is_point & differs), starts);
    Store(is_point, keeps);
#pragma GCC unroll 8
    for (int lane = 0; lane < kLanes; ++lane) {
      Lanes<4>::Floats point;
      Load(point, p.offset + 4 * (u + lane));
      runs.first[found] = u + lane;
      found -= starts[lane];  // true is -1
      // What is no point is written behind the last run.
      sums.Add(point, starts[lane], runs.sums[found + keeps[lane]].data());
    }
  }
  return found;
}

template <int kLanes>
[[gnu::always_inline]] inline int PlaceAndSum(const std::uint16_t* depth, int count,
                                              const RowDirections& directions,
                                              const RowGeometry& geometry, const RowPoints& points,
                                              const RowRuns& runs) {
  const RowGeometry g = geometry;  // copies, so that no store can seem to change them
  const RowPoints p = points;
  PlacePixels<kLanes>(depth, count, directions, g, p);
  p.voxel_x[-1] = p.voxel_y[-1] = p.voxel_z[-1] = kNoPoint;
  return SumRuns<kLanes>(p, count, RowRuns(runs));
}

int SumRowRunsPortable(const std::uint16_t* depth, int count, const RowDirections& directions,
                       const RowGeometry& geometry, const RowPoints& points, const RowRuns& runs) {
  return PlaceAndSum<kPortableLanes>(depth, count, directions, geometry, points, runs);
}

FALLEN_TARGET_AVX2 int SumRowRunsAvx2(const std::uint16_t* depth, int count,
                                      const RowDirections& directions, const RowGeometry& geometry,
                                      const RowPoints& points, const RowRuns& runs) {
  return PlaceAndSum<kAvx2Lanes>(depth, count, directions, geometry, points, runs);
}

}  // namespace

#if !defined(__x86_64__)
int SumRowRunsAvx512(const std::uint16_t* depth, int count, const RowDirections& directions,
                     const RowGeometry& geometry, const RowPoints& points, const RowRuns& runs) {
  return SumRowRunsPortable(depth, count, directions, geometry, points, runs);
}
#endif

int SumRowRuns(const std::uint16_t* depth, int count, const RowDirections& directions,
               const RowGeometry& geometry, const RowPoints& points, const RowRuns& runs) {
  return ChooseSimd(SumRowRunsPortable, SumRowRunsAvx2, SumRowRunsAvx512)(depth, count, directions,
                                                                          geometry, points, runs);
}

}  // namespace fallen
