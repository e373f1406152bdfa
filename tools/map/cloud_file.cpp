// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/cloud_file.hpp"

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

std::string LowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

pcl::PCLPointCloud2 Load(const std::filesystem::path& file) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // one line about an error is ours
  pcl::PCLPointCloud2 cloud;
  const int status = LowerExtension(file) == ".ply" ? pcl::io::loadPLYFile(file.string(), cloud)
                                                    : pcl::io::loadPCDFile(file.string(), cloud);
  if (status < 0)
    throw std::runtime_error(file.string() +
                             ": got no cloud that can be read, expected PLY or PCD");
  return cloud;
}

/// Reads one coordinate. PCL's own conversion to points leaves doubles at zero, without an error.
class Coordinate {
 public:
  Coordinate(const pcl::PCLPointCloud2& cloud, const std::string& name,
             const std::filesystem::path& file) {
    for (const pcl::PCLPointField& field : cloud.fields) {
      if (field.name != name) continue;
      is_double_ = field.datatype == pcl::PCLPointField::FLOAT64;
      if (!is_double_ && field.datatype != pcl::PCLPointField::FLOAT32) break;
      offset_ = field.offset;
      return;
    }
    throw std::runtime_error(file.string() + ": got no " + name +
                             " of float or double, expected points with x, y and z");
  }

  std::size_t end() const { return offset_ + (is_double_ ? sizeof(double) : sizeof(float)); }

  double At(const std::uint8_t* point) const {
    return is_double_ ? Read<double>(point) : static_cast<double>(Read<float>(point));
  }

 private:
  template <class T>
  T Read(const std::uint8_t* point) const {
    T value;
    std::memcpy(&value, point + offset_, sizeof value);
    return value;
  }

  std::size_t offset_ = 0;
  bool is_double_ = false;
};

}  // namespace

bool IsCloudFile(const std::filesystem::path& file) {
  const std::string extension = LowerExtension(file);
  return extension == ".ply" || extension == ".pcd";
}

std::vector<Eigen::Vector3d> ReadCloud(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error(file.string() + ": got no such file, expected a PLY or PCD cloud");
  const pcl::PCLPointCloud2 cloud = Load(file);
  const Coordinate x(cloud, "x", file);
  const Coordinate y(cloud, "y", file);
  const Coordinate z(cloud, "z", file);
  const std::size_t count = static_cast<std::size_t>(cloud.width) * cloud.height;
  const std::size_t step = cloud.point_step;
  if (std::max({x.end(), y.end(), z.end()}) > step || cloud.data.size() < count * step)
    throw std::runtime_error(file.string() + ": got " + std::to_string(cloud.data.size()) +
                             " bytes of points, expected " + std::to_string(count * step));

  std::vector<Eigen::Vector3d> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* point = cloud.data.data() + i * step;
    const Eigen::Vector3d p(x.At(point), y.At(point), z.At(point));
    if (p.allFinite()) points.push_back(p);
  }
  return points;
}

}  // namespace fallen
