// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/map_conversion.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

// Rotations that went through floats or many products are off by less.
constexpr double kRotationTolerance = 1e-3;
constexpr std::int64_t kMaxBins = 64;  // of either kind: 8192 values a descriptor
constexpr double kMaxRadius_m = 10;
constexpr std::int64_t kMaxInt32 = std::numeric_limits<std::int32_t>::max();

// Sylvester's criterion, in double: the products of floats are exact.
bool IsPositiveDefinite(const std::array<float, 6>& covariance) {
  const double xx = covariance[0], xy = covariance[1], xz = covariance[2];
  const double yy = covariance[3], yz = covariance[4], zz = covariance[5];
  const double minor = xx * yy - xy * xy;
  const double determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
  return xx > 0 && minor > 0 && determinant > 0 && std::isfinite(determinant);
}

[[noreturn]] void FailCell(const std::string& cells, std::size_t index, const std::string& field,
                           const std::string& got, const std::string& expected) {
  checks::Fail(cells + "[" + std::to_string(index) + "]." + field, got, expected);
}

void CheckCell(const std::string& cells, std::size_t index, const NdtCell& cell) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(cell.mean[axis]) <= limits::kMaxCoordinate_m))
      FailCell(cells, index, "mean", checks::Text(cell.mean[axis]),
               "at most " + checks::Text(limits::kMaxCoordinate_m) + " m from 0");
  if (!IsPositiveDefinite(cell.covariance))
    FailCell(cells, index, "covariance", "a matrix that is not", "a positive definite one");
  if (cell.point_count < 1 || cell.point_count > kMaxInt32)
    FailCell(cells, index, "point_count",
             checks::Text(std::int64_t{static_cast<std::int32_t>(cell.point_count)}), "> 0");
  if (!std::isfinite(cell.occupancy))
    FailCell(cells, index, "occupancy", checks::Text(cell.occupancy), "a finite number");
}

}  // namespace

ndt_cells_t CellsToMessage(const std::vector<NdtCell>& cells) {
  ndt_cells_t message{};
  const std::size_t count = cells.size();
  if (count > static_cast<std::size_t>(kMaxInt32))
    checks::Fail("ndt_cells_t.count", std::to_string(count), "less than 2^31");
  message.count = static_cast<std::int32_t>(count);
  for (auto* values : {&message.mean_x, &message.mean_y, &message.mean_z, &message.covariance_xx,
                       &message.covariance_xy, &message.covariance_xz, &message.covariance_yy,
                       &message.covariance_yz, &message.covariance_zz, &message.occupancy})
    values->resize(count);
  message.point_count.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const NdtCell& cell = cells[i];
    CheckCell("ndt_cells_t", i, cell);
    message.mean_x[i] = cell.mean.x();
    message.mean_y[i] = cell.mean.y();
    message.mean_z[i] = cell.mean.z();
    message.covariance_xx[i] = cell.covariance[0];
    message.covariance_xy[i] = cell.covariance[1];
    message.covariance_xz[i] = cell.covariance[2];
    message.covariance_yy[i] = cell.covariance[3];
    message.covariance_yz[i] = cell.covariance[4];
    message.covariance_zz[i] = cell.covariance[5];
    message.point_count[i] = static_cast<std::int32_t>(cell.point_count);
    message.occupancy[i] = cell.occupancy;
  }
  return message;
}

std::vector<NdtCell> CellsFromMessage(const std::string& field, const ndt_cells_t& message) {
  for (const auto* values :
       {&message.mean_x, &message.mean_y, &message.mean_z, &message.covariance_xx,
        &message.covariance_xy, &message.covariance_xz, &message.covariance_yy,
        &message.covariance_yz, &message.covariance_zz, &message.occupancy})
    checks::Count(field + ".count", message.count, values->size());
  checks::Count(field + ".count", message.count, message.point_count.size());
  std::vector<NdtCell> cells(static_cast<std::size_t>(message.count));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].mean = {message.mean_x[i], message.mean_y[i], message.mean_z[i]};
    cells[i].covariance = {message.covariance_xx[i], message.covariance_xy[i],
                           message.covariance_xz[i], message.covariance_yy[i],
                           message.covariance_yz[i], message.covariance_zz[i]};
    // A negative number becomes one beyond int32, and is refused as such.
    cells[i].point_count = static_cast<std::uint32_t>(message.point_count[i]);
    cells[i].occupancy = message.occupancy[i];
    CheckCell(field, i, cells[i]);
  }
  return cells;
}

void CheckNearCamera(const std::string& field, std::size_t index, const Eigen::Vector3f& mean,
                     const Eigen::Isometry3d& T_map_camera) {
  const Eigen::Vector3d from_camera = mean.cast<double>() - T_map_camera.translation();
  for (const double distance : from_camera)
    if (!(std::abs(distance) <= limits::kMaxLocalDistance_m))
      FailCell(field, index, "mean", checks::Text(std::abs(distance)) + " m from the camera",
               "at most " + checks::Text(limits::kMaxLocalDistance_m) + " m along each axis");
}

ground_t GroundToMessage(const GroundEstimate& ground) {
  ground_t message{};
  message.status = static_cast<std::int32_t>(ground.status);
  message.method = static_cast<std::int32_t>(ground.method);
  std::copy_n(ground.plane.normal.data(), 3, message.normal);
  message.offset = ground.plane.offset;
  message.inlier_count = ground.inlier_count;
  message.point_count = ground.point_count;
  GroundFromMessage("ground_t", message);
  return message;
}

GroundEstimate GroundFromMessage(const std::string& owner, const ground_t& message) {
  checks::InRange(owner + ".ground.status", message.status, 0,
                  static_cast<int>(GroundStatus::kNoMounting));
  checks::InRange(owner + ".ground.method", message.method, 0,
                  static_cast<int>(GroundMethod::kVDisparity));
  checks::AllFinite(owner + ".ground.normal", std::span<const double>(message.normal));
  const Eigen::Vector3d normal(message.normal);
  checks::InRange(owner + ".ground.normal's length", normal.norm(), 1 - kRotationTolerance,
                  1 + kRotationTolerance);
  checks::InRange(owner + ".ground.offset", message.offset, -limits::kMaxCoordinate_m * 2,
                  limits::kMaxCoordinate_m * 2);  // of a plane through the farthest corner
  checks::InRange(owner + ".ground.point_count", message.point_count, 0, kMaxInt32);
  checks::InRange(owner + ".ground.inlier_count", message.inlier_count, 0, message.point_count);
  GroundEstimate ground;
  ground.status = static_cast<GroundStatus>(message.status);
  ground.method = static_cast<GroundMethod>(message.method);
  ground.plane = {normal, message.offset};
  ground.inlier_count = message.inlier_count;
  ground.point_count = message.point_count;
  return ground;
}

iron_t IronToMessage(const IronConfig& iron) {
  iron_t message{};
  message.radius_m = iron.radius_m;
  message.distance_bins = iron.distance_bins;
  message.angle_bins = iron.angle_bins;
  message.max_ball_ratio = iron.max_ball_ratio;
  message.min_needle_ratio = iron.min_needle_ratio;
  message.min_neighbors = iron.min_neighbors;
  IronFromMessage("iron_t", message);
  return message;
}

IronConfig IronFromMessage(const std::string& owner, const iron_t& message) {
  checks::Positive(owner + ".iron.radius_m", message.radius_m);
  checks::InRange(owner + ".iron.radius_m", message.radius_m, 0.0, kMaxRadius_m);
  checks::InRange(owner + ".iron.distance_bins", message.distance_bins, 1, kMaxBins);
  checks::InRange(owner + ".iron.angle_bins", message.angle_bins, 1, kMaxBins);
  checks::InRange(owner + ".iron.max_ball_ratio", message.max_ball_ratio, 0.0, 1.0);
  checks::InRange(owner + ".iron.min_needle_ratio", message.min_needle_ratio, 0.0, 1.0);
  checks::InRange(owner + ".iron.min_neighbors", message.min_neighbors, 0, kMaxInt32);
  IronConfig iron;
  iron.radius_m = message.radius_m;
  iron.distance_bins = message.distance_bins;
  iron.angle_bins = message.angle_bins;
  iron.max_ball_ratio = message.max_ball_ratio;
  iron.min_needle_ratio = message.min_needle_ratio;
  iron.min_neighbors = message.min_neighbors;
  return iron;
}

void TransformToMessage(const Eigen::Isometry3d& transform, double (&message)[12]) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) message[4 * row + column] = transform(row, column);
}

Eigen::Isometry3d TransformFromMessage(const std::string& field, const double (&message)[12]) {
  checks::AllFinite(field, std::span<const double>(message));
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) transform(row, column) = message[4 * row + column];
  const Eigen::Matrix3d rotation = transform.linear();
  const double error =
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kRotationTolerance) || !(rotation.determinant() > 0))
    checks::Fail(field, "a matrix that is no rotation", "one");
  for (int axis = 0; axis < 3; ++axis)
    checks::InRange(field, transform(axis, 3), -limits::kMaxCoordinate_m, limits::kMaxCoordinate_m);
  return transform;
}

void CheckCellSize(const std::string& owner, double cell_size_m) {
  checks::InRange(owner + ".cell_size_m", cell_size_m, limits::kMinCellSize_m,
                  limits::kMaxCellSize_m);
}

}  // namespace fallen
