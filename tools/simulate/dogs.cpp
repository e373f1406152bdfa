// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/dogs.hpp"

#include <algorithm>
#include <cmath>

namespace fallen::sim {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Tubes of one coat at one scale; 1 is a Labrador, 0.9 m long without the tail.
class Coat {
 public:
  explicit Coat(Random& random)
      : scale_(random.Uniform(0.7, 1.3)), albedo_(random.Uniform(0.08, 0.8)) {}

  void Tube(Points points, std::vector<double> radii) {
    for (Eigen::Vector3d& p : points) p *= scale_;
    for (double& r : radii) r *= scale_;
    mesh_.Append(MakeTube(points, radii, albedo_));
  }
  void Head(const Eigen::Vector3d& neck, const Eigen::Vector3d& skull, double turn) {
    const Eigen::Vector3d muzzle = skull + Eigen::Vector3d(0.17, turn, -0.04);
    Tube({neck, (neck + skull) / 2 + Eigen::Vector3d(0.02, 0, 0.01), skull}, {0.09, 0.075, 0.075});
    Tube({skull, (skull + muzzle) / 2, muzzle}, {0.08, 0.065, 0.035});
    for (const double side : {-1.0, 1.0})
      Tube({skull + Eigen::Vector3d(-0.01, side * 0.06, 0.05),
            skull + Eigen::Vector3d(-0.02, side * 0.1, -0.03)},
           {0.025, 0.03});
  }
  TriangleMesh Finish() {
    for (Eigen::Vector3f& vertex : mesh_.vertices) vertex.z() = std::max(0.0f, vertex.z());
    return std::move(mesh_);
  }

 private:
  double scale_, albedo_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh MakeLyingDog(Random& random) {
  Coat coat(random);
  const double bend = random.Normal(0, 0.12);
  const bool on_side = random.Chance(0.4);
  const double z = on_side ? 0.12 : 0.15;
  coat.Tube(
      {{-0.38, bend, z}, {-0.2, bend / 2, z + 0.01}, {0.05, 0, z + 0.02}, {0.25, 0, z + 0.02}},
      {0.11, 0.115, 0.135, 0.11});
  const double head_z = on_side ? 0.09 : random.Uniform(0.12, 0.42);
  const double turn = random.Normal(0, 0.15);
  coat.Head({0.25, 0, z + 0.03}, {0.46, turn, head_z}, turn / 2);
  for (const double side : {-1.0, 1.0}) {
    const double y = on_side ? 0.15 : side * 0.11, low = on_side ? 0.06 + 0.05 * side : 0.045;
    const double spread = on_side ? 0.3 : 0.04;
    coat.Tube({{0.18, y * 0.7, z - 0.03}, {0.28, y + spread / 2, low}, {0.5, y + spread, low}},
              {0.06, 0.04, 0.03});
    coat.Tube({{-0.3, y * 0.9, z - 0.01},
               {-0.15, y + spread / 2 + 0.03, low + 0.02},
               {-0.02, y + spread + 0.05, low - 0.01}},
              {0.085, 0.05, 0.03});
  }
  coat.Tube({{-0.45, bend, z}, {-0.6, bend + 0.1, 0.05}, {-0.75, bend + 0.22, 0.03}},
            {0.035, 0.03, 0.02});
  return coat.Finish();
}

TriangleMesh MakeSittingDog(Random& random) {
  Coat coat(random);
  const double chest = random.Uniform(0.45, 0.52), turn = random.Normal(0, 0.12);
  coat.Tube({{-0.3, 0, 0.13}, {-0.18, 0, 0.26}, {0, 0, 0.4}, {0.08, 0, chest}},
            {0.13, 0.135, 0.13, 0.1});
  coat.Head({0.08, 0, chest + 0.03}, {0.17, turn / 2, chest + 0.2}, turn);
  for (const double side : {-1.0, 1.0}) {
    coat.Tube(
        {{0.06, side * 0.09, chest - 0.08}, {0.1, side * 0.1, 0.22}, {0.12, side * 0.1, 0.03}},
        {0.06, 0.04, 0.032});
    coat.Tube({{-0.28, side * 0.13, 0.12}, {-0.08, side * 0.18, 0.17}, {-0.02, side * 0.17, 0.04}},
              {0.1, 0.07, 0.035});
  }
  coat.Tube({{-0.4, 0, 0.06}, {-0.55, 0.05, 0.03}, {-0.68, 0.15, 0.03}}, {0.035, 0.03, 0.02});
  return coat.Finish();
}

TriangleMesh MakeStandingDog(Random& random) {
  Coat coat(random);
  const double back = random.Uniform(0.5, 0.58), turn = random.Normal(0, 0.12);
  const double stride = random.Uniform(-0.16, 0.16);
  coat.Tube({{-0.35, 0, back}, {-0.1, 0, back - 0.02}, {0.15, 0, back - 0.03}, {0.28, 0, back}},
            {0.1, 0.11, 0.135, 0.11});
  coat.Head({0.3, 0, back + 0.04}, {0.45, turn / 2, back + random.Uniform(-0.25, 0.22)}, turn);
  for (const double side : {-1.0, 1.0}) {
    const double front = side * stride, hind = -side * stride, y = side * 0.09;
    coat.Tube({{0.22, y, back - 0.06}, {0.22 + front / 2, y, 0.28}, {0.22 + front, y, 0.03}},
              {0.065, 0.042, 0.032});
    coat.Tube({{-0.32, y, back - 0.04},
               {-0.26 + hind / 2, y, 0.33},
               {-0.38 + hind, y, 0.2},
               {-0.33 + hind, y, 0.03}},
              {0.09, 0.06, 0.036, 0.032});
  }
  coat.Tube({{-0.42, 0, back + 0.04}, {-0.58, 0, back - 0.06}, {-0.68, 0.03, back - 0.2}},
            {0.035, 0.028, 0.02});
  return coat.Finish();
}

}  // namespace fallen::sim
