// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/ModelCoefficients.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/filters/voxel_grid_covariance.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <vector>

#include "benchmarks.hpp"
#include "lap_times.hpp"

namespace fallen {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

// As our stages have them by default: 5 cm cells, 3 cm to the plane.
constexpr float kLeaf_m = 0.05f;
constexpr double kInlierDistance_m = 0.03;

Cloud::Ptr CloudOf(const DepthImage& image) {
  Cloud::Ptr cloud(new Cloud);
  const CameraIntrinsics& camera = image.intrinsics;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const std::uint16_t depth = image.depth[static_cast<std::size_t>(v) * camera.width + u];
      if (depth == 0) continue;
      const Eigen::Vector3f p = camera.Deproject(u, v, depth * image.depth_unit_m).cast<float>();
      cloud->emplace_back(p.x(), p.y(), p.z());
    }
  return cloud;
}

// Runs `work(cloud)` on the frames' clouds in turn; it returns a number to be kept.
template <class Work>
void RegisterOnClouds(const std::string& name, const std::shared_ptr<BenchSequence>& sequence,
                      const std::shared_ptr<std::vector<Cloud::Ptr>>& clouds, Work work) {
  benchmark::RegisterBenchmark((name + "/" + sequence->size_name()).c_str(),
                               [=](benchmark::State& state) {
                                 if (clouds->empty())
                                   for (std::size_t i = 0; i < sequence->size(); ++i)
                                     clouds->push_back(CloudOf((*sequence)[i].image));
                                 LapTimes laps;
                                 std::size_t step = 0;
                                 for (auto _ : state) {
                                   const Cloud::Ptr& cloud = (*clouds)[sequence->IndexAt(step++)];
                                   laps.Start();
                                   benchmark::DoNotOptimize(work(cloud));
                                   laps.Stop();
                                 }
                                 laps.Report(state);
                                 state.SetLabel(sequence->source());
                               })
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void RegisterPclBenchmarks(const std::shared_ptr<BenchSequence>& sequence) {
  const auto clouds = std::make_shared<std::vector<Cloud::Ptr>>();
  RegisterOnClouds("PclVoxelGrid", sequence, clouds, [](const Cloud::Ptr& cloud) {
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(kLeaf_m, kLeaf_m, kLeaf_m);
    Cloud filtered;
    grid.filter(filtered);
    return filtered.size();
  });
  RegisterOnClouds("PclVoxelGridCovariance", sequence, clouds, [](const Cloud::Ptr& cloud) {
    pcl::VoxelGridCovariance<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(kLeaf_m, kLeaf_m, kLeaf_m);
    grid.filter(false);  // no search tree over the cells
    return grid.getLeaves().size();
  });
  RegisterOnClouds("PclSacSegmentation", sequence, clouds, [](const Cloud::Ptr& cloud) {
    pcl::SACSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setModelType(pcl::SACMODEL_PLANE);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setDistanceThreshold(kInlierDistance_m);
    segmentation.setOptimizeCoefficients(true);
    segmentation.setInputCloud(cloud);
    pcl::PointIndices inliers;
    pcl::ModelCoefficients plane;
    segmentation.segment(inliers, plane);
    return inliers.indices.size();
  });
}

}  // namespace fallen
