// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/household.hpp"

#include <cmath>
#include <numbers>

namespace fallen::sim {
namespace {

void Put(TriangleMesh part, double x, double y, double z, double yaw, TriangleMesh& mesh) {
  part.Transform((Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                  Eigen::Affine3d::Identity())
                     .cast<float>());
  mesh.Append(part);
}

TriangleMesh Tilted(TriangleMesh mesh, double angle, const Eigen::Vector3d& axis) {
  mesh.Transform(Eigen::Affine3d(Eigen::AngleAxisd(angle, axis)).cast<float>());
  return mesh;
}

}  // namespace

TriangleMesh MakeCushion(Random& random) {
  const double side = random.Uniform(0.35, 0.6);
  const TriangleMesh mesh =
      MakeSuperellipsoid({side, side * random.Uniform(0.7, 1), random.Uniform(0.1, 0.2)}, 1, 0.4,
                         random.Uniform(0.2, 0.9));
  return Tilted(mesh, random.Normal(0, 0.15), Eigen::Vector3d::UnitX());
}

TriangleMesh MakeCardboardBox(Random& random) {
  return MakeBox({random.Uniform(0.25, 0.7), random.Uniform(0.2, 0.5), random.Uniform(0.15, 0.5)},
                 random.Uniform(0.4, 0.7));
}

TriangleMesh MakeSportsBag(Random& random) {
  const double length = random.Uniform(0.45, 0.75), height = random.Uniform(0.22, 0.32);
  const double albedo = random.Uniform(0.15, 0.7);
  TriangleMesh mesh =
      MakeSuperellipsoid({length, height * random.Uniform(0.9, 1.3), height}, 0.6, 0.6, albedo);
  const double h = height / 2;
  for (const double side : {-0.06, 0.06})
    mesh.Append(MakeTube({{-0.15, side, h * 0.8},
                          {-0.1, side, h + 0.08},
                          {0.1, side, h + 0.1},
                          {0.15, side, h * 0.8}},
                         {0.012, 0.012, 0.012, 0.012}, albedo));
  return mesh;
}

TriangleMesh MakeBackpackAndBag(Random& random) {
  const double width = random.Uniform(0.28, 0.36), depth = random.Uniform(0.18, 0.26);
  const double height = random.Uniform(0.42, 0.6), albedo = random.Uniform(0.08, 0.7);
  TriangleMesh backpack = MakeSuperellipsoid({width, depth, height}, 0.7, 0.5, albedo);
  Put(MakeSuperellipsoid({width * 0.7, 0.1, height * 0.4}, 0.6, 0.5, albedo), 0, -depth / 2,
      -height * 0.15, 0, backpack);
  const bool fallen_over = random.Chance(0.6);
  backpack = Tilted(backpack, fallen_over ? -std::numbers::pi / 2 : random.Normal(0, 0.15),
                    Eigen::Vector3d::UnitX());
  const double rest = fallen_over ? depth / 2 + 0.02 : height / 2;
  TriangleMesh bag = MakeSportsBag(random), mesh;
  const double bag_rest = -bag.Bounds().min().z();
  Put(bag, 0, 0, bag_rest, random.Normal(0, 0.2), mesh);
  Put(backpack, 0.33 + width / 2 + random.Uniform(-0.05, 0.12), random.Normal(0, 0.1), rest,
      random.Uniform(-1.6, 1.6), mesh);
  return mesh;
}

TriangleMesh MakeAirMattress(Random& random) {
  const double length = random.Uniform(1.8, 2.05), height = random.Uniform(0.1, 0.24);
  const double width = random.Chance(0.7) ? random.Uniform(0.6, 1.0) : random.Uniform(1.2, 1.45);
  const double albedo = random.Uniform(0.1, 0.7);
  TriangleMesh mesh = MakeSuperellipsoid({length, width, 0.8 * height}, 0.3, 0.15, albedo);
  const int chambers = static_cast<int>(width / 0.12);
  for (int i = 0; i < chambers; ++i) {
    const double y = ((i + 0.5) / chambers - 0.5) * (width - 0.05), r = 0.4 * width / chambers;
    mesh.Append(MakeTube(
        {{-length / 2 + 0.08, y, 0.5 * height - r}, {length / 2 - 0.08, y, 0.5 * height - r}},
        {r, r}, albedo));
  }
  if (random.Chance(0.4))
    Put(MakeCushion(random), length / 2 - 0.25, random.Normal(0, 0.1), height * 0.7,
        std::numbers::pi / 2, mesh);
  return mesh;
}

TriangleMesh MakeSuitcase(Random& random) {
  const double width = random.Uniform(0.35, 0.52), depth = random.Uniform(0.2, 0.32);
  const double height = random.Uniform(0.5, 0.78), albedo = random.Uniform(0.08, 0.7);
  TriangleMesh mesh = MakeSuperellipsoid({width, depth, height}, 0.2, 0.2, albedo);
  for (const double side : {-0.4, 0.4}) {
    const double x = side * width;
    mesh.Append(
        MakeTube({{x, 0.3 * depth, -height / 2 - 0.02}, {x, 0.36 * depth, -height / 2 - 0.02}},
                 {0.03, 0.03}, 0.2));
  }
  if (random.Chance(0.4))
    mesh.Append(MakeTube({{-0.1, 0.4 * depth, height / 2},
                          {-0.1, 0.4 * depth, height / 2 + 0.4},
                          {0.1, 0.4 * depth, height / 2 + 0.4},
                          {0.1, 0.4 * depth, height / 2}},
                         {0.01, 0.014, 0.014, 0.01}, 0.3));
  const bool laid_down = random.Chance(0.5);
  return laid_down ? Tilted(mesh, std::numbers::pi / 2, Eigen::Vector3d::UnitX()) : mesh;
}

TriangleMesh MakeRolledCarpet(Random& random) {
  const double length = random.Uniform(0.9, 2.2), radius = random.Uniform(0.07, 0.16);
  const double sag = random.Normal(0, 0.06);
  return MakeTube(
      {{-length / 2, sag, 0}, {-length / 6, 0, 0}, {length / 6, 0, 0}, {length / 2, sag, 0}},
      {radius, radius, radius, radius}, random.Uniform(0.1, 0.8));
}

TriangleMesh MakeShoes(Random& random) {
  TriangleMesh mesh;
  for (int pair = random.Integer(1, 4); pair > 0; --pair) {
    const double albedo = random.Uniform(0.08, 0.8), length = random.Uniform(0.22, 0.32);
    const double x = random.Uniform(-0.35, 0.35), y = random.Uniform(-0.25, 0.25);
    const double shaft = random.Chance(0.25) ? random.Uniform(0.2, 0.35) : 0.1;
    for (const double side : {-0.06, 0.06}) {
      const double yaw = random.Normal(0, 0.3);
      Put(MakeSuperellipsoid({length, 0.1, 0.1}, 0.8, 0.7, albedo), x, y + side, 0.05, yaw, mesh);
      Put(MakeSuperellipsoid({0.12, 0.09, shaft}, 0.4, 0.8, albedo), x - 0.3 * length, y + side,
          shaft / 2, yaw, mesh);
    }
  }
  return mesh;
}

TriangleMesh MakeToys(Random& random) {
  TriangleMesh mesh;
  for (int i = random.Integer(3, 10); i > 0; --i) {
    const double x = random.Normal(0, 0.35), y = random.Normal(0, 0.3);
    const double size = random.Uniform(0.05, 0.25), albedo = random.Uniform(0.2, 0.9);
    const double yaw = random.Uniform(-3, 3);
    if (random.Chance(0.5))
      Put(MakeBox({size, size * random.Uniform(0.3, 1), size * 0.7}, albedo), x, y, size * 0.35,
          yaw, mesh);
    else
      Put(MakeSuperellipsoid({size, size, size}, 1, 1, albedo), x, y, size / 2, yaw, mesh);
  }
  return mesh;
}

TriangleMesh MakeLaundryBasket(Random& random) {
  const double length = random.Uniform(0.45, 0.65), width = random.Uniform(0.35, 0.45);
  const double height = random.Uniform(0.25, 0.55), albedo = random.Uniform(0.3, 0.9);
  TriangleMesh mesh = MakeSuperellipsoid({length, width, height}, 0.15, 0.4, albedo);
  for (int i = random.Integer(0, 3); i > 0; --i)
    Put(MakeSuperellipsoid({random.Uniform(0.2, 0.4), random.Uniform(0.2, 0.35), 0.16}, 1, 0.8,
                           random.Uniform(0.2, 0.9)),
        random.Normal(0, 0.06), random.Normal(0, 0.04), height / 2, random.Uniform(-2, 2), mesh);
  return mesh;
}

}  // namespace fallen::sim
