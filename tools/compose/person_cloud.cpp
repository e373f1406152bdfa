// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/person_cloud.hpp"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tools/map/cloud_file.hpp"

namespace fallen {
namespace {

constexpr std::size_t kMinPoints = 50;
constexpr double kFloorQuantile = 0.005;  // of the heights: a few stray points may lie deeper
constexpr int kNormalNeighbors = 12;
// The distance to the sixth neighbour tells how dense points are; with a sigma of 0.7 of it about
// six splats overlap everywhere on a surface, see RenderSplats.
constexpr int kSpacingNeighbor = 6;
constexpr double kSigmaPerSpacing = 0.7;
constexpr double kMinSigmaM = 0.003;
constexpr double kMaxSigmaM = 0.035;  // points sparser than limbs are thick make no surface
constexpr double kBoxMarginM = 0.02;
constexpr double kRimM = 0.05;  // so far above the cut points are continued below it
constexpr double kRimStepM = 0.01;

Eigen::Matrix3d UprightRotation(CloudUp up) {
  Eigen::Matrix3d R_upright_cloud = Eigen::Matrix3d::Identity();
  if (up == CloudUp::kMinusY) R_upright_cloud << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return R_upright_cloud;
}

double FloorHeight(const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> heights;
  for (const Eigen::Vector3d& p : points) heights.push_back(p.z());
  const auto nth = heights.begin() +
                   static_cast<std::ptrdiff_t>(kFloorQuantile * static_cast<double>(points.size()));
  std::nth_element(heights.begin(), nth, heights.end());
  return *nth;
}

/// The upright box along the points' longest direction, from the floor at z = 0.
OrientedBox BoxAround(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p.head<2>() / static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector3d& p : points)
    scatter += (p.head<2>() - mean) * (p.head<2>() - mean).transpose();
  OrientedBox box;
  box.yaw = 0.5 * std::atan2(2 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  const Eigen::Rotation2Dd R_level_box(box.yaw);
  Eigen::AlignedBox2d extent;
  double top_m = 0;
  for (const Eigen::Vector3d& p : points) {
    extent.extend(R_level_box.inverse() * p.head<2>());
    top_m = std::max(top_m, p.z());
  }
  box.center << R_level_box * extent.center(), (top_m + kBoxMarginM) / 2;
  box.size << extent.sizes() + Eigen::Vector2d::Constant(2 * kBoxMarginM), top_m + kBoxMarginM;
  return box;
}

std::vector<Splat> MakeSplats(const std::vector<Eigen::Vector3d>& points) {
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3d& p : points)
    cloud->push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  std::vector<Splat> splats;
  std::vector<int> neighbors;
  std::vector<float> sq_distances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    tree.nearestKSearch((*cloud)[i], kNormalNeighbors + 1, neighbors, sq_distances);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int k : neighbors) mean += points[k] / static_cast<double>(neighbors.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const int k : neighbors) scatter += (points[k] - mean) * (points[k] - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    const double spacing_m = std::sqrt(sq_distances[kSpacingNeighbor]);
    splats.push_back({points[i], solver.eigenvectors().col(0),
                      std::clamp(kSigmaPerSpacing * spacing_m, kMinSigmaM, kMaxSigmaM)});
  }
  return splats;
}

void ContinueToFloor(double floor_cut_m, std::vector<Eigen::Vector3d>& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p = points[i];
    if (p.z() > floor_cut_m + kRimM) continue;
    for (p.z() -= kRimStepM; p.z() > 0; p.z() -= kRimStepM)
      if (p.z() < floor_cut_m) points.push_back(p);
  }
}

}  // namespace

PersonCloud MakePersonCloud(const std::vector<Eigen::Vector3d>& points, CloudUp up,
                            double floor_cut_m) {
  if (points.size() < kMinPoints)
    throw std::invalid_argument(
        "got " + std::to_string(points.size()) +
        " points, expected a lying person's: " + std::to_string(kMinPoints) + " or more");
  std::vector<Eigen::Vector3d> upright;
  for (const Eigen::Vector3d& p : points) upright.push_back(UprightRotation(up) * p);
  const Eigen::Vector3d middle = BoxAround(upright).center;
  const Eigen::Translation3d to_floor(-middle.x(), -middle.y(), floor_cut_m - FloorHeight(upright));
  const Eigen::AngleAxisd to_bearing(-std::atan2(middle.y(), middle.x()), Eigen::Vector3d::UnitZ());
  const Eigen::Isometry3d T_person_upright = to_bearing * to_floor;
  for (Eigen::Vector3d& p : upright) p = T_person_upright * p;
  ContinueToFloor(floor_cut_m, upright);
  return {MakeSplats(upright), BoxAround(upright)};
}

PersonCloud LoadPersonCloud(const std::filesystem::path& file, CloudUp up, double floor_cut_m) {
  try {
    return MakePersonCloud(ReadCloud(file), up, floor_cut_m);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

}  // namespace fallen
