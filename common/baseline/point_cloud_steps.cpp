// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/baseline/point_cloud_steps.hpp"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <algorithm>
#include <tuple>

namespace fallen {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr ToPcl(const std::vector<Eigen::Vector3f>& points) {
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

}  // namespace

std::vector<Eigen::Vector3f> ThinPoints(const std::vector<Eigen::Vector3f>& points, double leaf_m) {
  if (points.empty()) return {};
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(ToPcl(points));
  grid.setLeafSize(Eigen::Vector4f::Constant(static_cast<float>(leaf_m)));
  Cloud thinned;
  grid.filter(thinned);
  std::vector<Eigen::Vector3f> result;
  result.reserve(thinned.size());
  for (const pcl::PointXYZ& p : thinned) result.push_back(p.getVector3fMap());
  return result;
}

std::vector<Eigen::Vector3f> EstimateNormals(const std::vector<Eigen::Vector3f>& points,
                                             const Eigen::Vector3f& viewpoint, double radius_m) {
  if (points.empty()) return {};
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(ToPcl(points));
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(radius_m);
  estimation.setViewPoint(viewpoint.x(), viewpoint.y(), viewpoint.z());
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  std::vector<Eigen::Vector3f> result;
  result.reserve(normals.size());
  for (const pcl::Normal& n : normals) {
    const Eigen::Vector3f normal = n.getNormalVector3fMap();
    result.push_back(normal.allFinite() ? normal : Eigen::Vector3f::Zero().eval());
  }
  return result;
}

std::vector<std::vector<std::int32_t>> EuclideanClusters(const std::vector<Eigen::Vector3f>& points,
                                                         double tolerance_m, int min_points) {
  if (points.empty()) return {};
  const Cloud::Ptr cloud = ToPcl(points);
  const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  tree->setInputCloud(cloud);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setInputCloud(cloud);
  extraction.setSearchMethod(tree);
  extraction.setClusterTolerance(tolerance_m);
  extraction.setMinClusterSize(min_points);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);
  std::vector<std::vector<std::int32_t>> clusters;
  for (const pcl::PointIndices& cluster : found) {
    clusters.emplace_back(cluster.indices.begin(), cluster.indices.end());
    std::sort(clusters.back().begin(), clusters.back().end());
  }
  std::sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(b.size(), a[0]) < std::make_tuple(a.size(), b[0]);
  });
  return clusters;
}

}  // namespace fallen
