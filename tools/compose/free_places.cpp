// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/free_places.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace fallen {
namespace {

constexpr double kSquareM = 0.1;           // the floor is looked at in squares of this size
constexpr double kFloorNoiseM = 0.04;      // floor is at most so far off its plane ...
constexpr double kFloorNoisePerM = 0.005;  // ... and so much more per squared metre of distance
constexpr double kClearHeightM = 1.8;      // what hangs higher is in nobody's way
constexpr int kMinPointsInWay = 3;         // fewer on a square are noise
constexpr double kMarginM = 0.05;          // around the person
constexpr double kMinFloorShare = 0.5;  // of the footprint: the rest is hidden or outside the image
constexpr double kRingStepM = 0.5;
constexpr double kBearingStepRad = 8 * std::numbers::pi / 180;

/// What is seen of the floor, square by square.
class FloorGrid {
 public:
  FloorGrid(const DepthImage& image, const Eigen::Isometry3d& T_level_camera) {
    const CameraIntrinsics& camera = image.intrinsics;
    std::size_t i = 0;
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u, ++i)
        if (image.depth[i] != 0)
          Add(T_level_camera * camera.Deproject(u, v, image.depth[i] * image.depth_unit_m));
  }

  bool IsFloor(const Eigen::Vector2d& p) const {
    const auto square = squares_.find(Key(p));
    return square != squares_.end() && square->second.floor > 0;
  }
  bool IsOccupied(const Eigen::Vector2d& p) const {
    const auto square = squares_.find(Key(p));
    return square != squares_.end() && square->second.in_way >= kMinPointsInWay;
  }

 private:
  struct Square {
    int floor = 0, in_way = 0;
  };
  static std::pair<int, int> Key(const Eigen::Vector2d& p) {
    return {static_cast<int>(std::floor(p.x() / kSquareM)),
            static_cast<int>(std::floor(p.y() / kSquareM))};
  }
  void Add(const Eigen::Vector3d& p) {
    const double noise_m = kFloorNoiseM + kFloorNoisePerM * p.head<2>().squaredNorm();
    if (p.z() < -noise_m || p.z() > kClearHeightM) return;
    Square& square = squares_[Key(p.head<2>())];
    ++(p.z() <= noise_m ? square.floor : square.in_way);
  }

  std::map<std::pair<int, int>, Square> squares_;
};

bool IsFree(const FloorGrid& grid, const OrientedBox& box) {
  const Eigen::Rotation2Dd R_level_box(box.yaw);
  const Eigen::Vector2d half = box.size.head<2>() / 2 + Eigen::Vector2d::Constant(kMarginM);
  int squares = 0, floor = 0;
  for (double x = -half.x(); x <= half.x(); x += kSquareM / 2)
    for (double y = -half.y(); y <= half.y(); y += kSquareM / 2) {
      const Eigen::Vector2d p = box.center.head<2>() + R_level_box * Eigen::Vector2d(x, y);
      if (grid.IsOccupied(p)) return false;
      ++squares;
      floor += grid.IsFloor(p);
    }
  return floor >= kMinFloorShare * squares;
}

}  // namespace

Eigen::Isometry3d Place::Pose() const {
  return Eigen::Translation3d(distance_m * std::cos(bearing_rad),
                              distance_m * std::sin(bearing_rad), 0) *
         Eigen::AngleAxisd(bearing_rad + turn_rad, Eigen::Vector3d::UnitZ());
}

OrientedBox BoxAt(const Place& place, const OrientedBox& box) {
  return {place.Pose() * box.center, box.size, box.yaw + place.bearing_rad + place.turn_rad};
}

std::vector<Place> FindFreePlaces(const DepthImage& image, const Eigen::Isometry3d& T_level_camera,
                                  const OrientedBox& box, const PlaceSearch& search) {
  const FloorGrid grid(image, T_level_camera);
  const CameraIntrinsics& camera = image.intrinsics;
  const double half_view_rad = std::atan(camera.width / 2.0 / camera.fx);
  const int steps = static_cast<int>(half_view_rad / kBearingStepRad);
  std::vector<Place> places;
  for (double distance_m = search.min_distance_m; distance_m <= search.max_distance_m + 1e-9;
       distance_m += kRingStepM)
    for (int step = -steps; step <= steps; ++step)
      for (const double turn_rad : search.turns_rad) {
        const Place place{distance_m, step * kBearingStepRad, turn_rad};
        if (IsFree(grid, BoxAt(place, box))) places.push_back(place);
      }
  return places;
}

std::vector<Place> OrderPlaces(std::vector<Place> places, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (std::size_t i = places.size(); i > 1; --i) std::swap(places[i - 1], places[random() % i]);
  std::vector<Place> ordered;
  while (!places.empty()) {
    // The one whose distance is least used so far; of several the first.
    const auto uses = [&](const Place& place) {
      return std::count_if(ordered.begin(), ordered.end(), [&](const Place& other) {
        return other.distance_m == place.distance_m;
      });
    };
    const auto best =
        std::min_element(places.begin(), places.end(),
                         [&](const Place& a, const Place& b) { return uses(a) < uses(b); });
    ordered.push_back(*best);
    places.erase(best);
  }
  return ordered;
}

}  // namespace fallen
