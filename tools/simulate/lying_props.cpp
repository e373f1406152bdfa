// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/lying_props.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/simulate/distractors.hpp"
#include "tools/simulate/household.hpp"
#include "tools/simulate/smooth_noise.hpp"

namespace fallen::sim {
namespace {

void Move(TriangleMesh& mesh, double x, double y, double z) {
  mesh.Transform(Eigen::Affine3f(
      Eigen::Translation3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z))));
}

void AddBox(TriangleMesh& mesh, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
            double albedo) {
  TriangleMesh box = MakeBox(high - low, albedo);
  const Eigen::Vector3d middle = (low + high) / 2;
  Move(box, middle.x(), middle.y(), middle.z());
  mesh.Append(box);
}

}  // namespace

TriangleMesh MakeSeatBelowLegs(const TriangleMesh& person, Random& random) {
  constexpr double kDepth = 0.4;      // of the seat that the lower legs lie on [m]
  constexpr double kLowestLeg = 0.2;  // [m]: below that it is the rest of the body
  const double end = person.Bounds().min().x();
  std::vector<double> heights;
  double y_sum = 0;
  for (const Eigen::Vector3f& vertex : person.vertices) {
    if (vertex.x() > end + 0.8 * kDepth || vertex.z() < kLowestLeg) continue;
    heights.push_back(vertex.z());
    y_sum += vertex.y();
  }
  if (heights.empty()) return {};
  constexpr double kShare = 0.25;  // of the legs' surface that lies on the seat or below its edge
  const auto count = static_cast<double>(heights.size());
  const auto place = heights.begin() + static_cast<std::ptrdiff_t>(kShare * count);
  std::nth_element(heights.begin(), place, heights.end());
  const double top = *place, y = y_sum / count;
  const double half = random.Uniform(0.22, 0.6), albedo = random.Uniform(0.1, 0.8);
  const double low = end - random.Uniform(0, 0.3), high = end + kDepth;
  TriangleMesh seat;
  if (half > 0.32 || random.Chance(0.3)) {
    AddBox(seat, {low, y - half, 0.02}, {high, y + half, top}, albedo);
    return seat;
  }
  AddBox(seat, {low, y - half, top - 0.04}, {high, y + half, top}, albedo);
  for (const double x : {low + 0.03, high - 0.03})
    for (const double side : {-half + 0.03, half - 0.03})
      seat.Append(MakeTube({{x, y + side, 0.02}, {x, y + side, top - 0.03}}, {0.02, 0.02}, albedo));
  if (random.Chance(0.6))
    AddBox(seat, {low - 0.03, y - half, top}, {low, y + half, top + random.Uniform(0.3, 0.5)},
           albedo);
  return seat;
}

TriangleMesh MakeBackrest(const TriangleMesh& person, Random& random) {
  const double height = random.Uniform(0.35, 1.1), half = random.Uniform(0.25, 0.9);
  double back = 0;
  for (const Eigen::Vector3f& vertex : person.vertices)
    if (vertex.z() < height) back = std::max<double>(back, vertex.x());
  const double y = random.Normal(0, 0.3 * half);
  TriangleMesh rest;
  AddBox(rest, {back, y - half, 0}, {back + random.Uniform(0.3, 0.7), y + half, height},
         random.Uniform(0.1, 0.8));
  return rest;
}

TriangleMesh MakeObstacle(const TriangleMesh& person, Random& random) {
  TriangleMesh obstacle;
  switch (random.Index(5)) {
    case 0:
      obstacle = MakeRollator(random);
      obstacle.Transform(Eigen::Affine3f(
          Eigen::AngleAxisf(static_cast<float>(std::numbers::pi / 2), Eigen::Vector3f::UnitX())));
      break;
    case 1:
      obstacle = MakeCardboardBox(random);
      break;
    case 2:
      obstacle = MakeRolledCarpet(random);
      break;
    case 3:
      obstacle = MakeSuitcase(random);
      break;
    default:
      obstacle = MakeSportsBag(random);
  }
  obstacle.Transform(Eigen::Affine3f(
      Eigen::AngleAxisf(static_cast<float>(random.Uniform(-3, 3)), Eigen::Vector3f::UnitZ())));
  const Eigen::AlignedBox3f bounds = obstacle.Bounds();
  Move(obstacle, person.Bounds().min().x() - bounds.max().x() - 0.01,
       random.Normal(0, 0.15) - bounds.center().y(), -bounds.min().z());
  return obstacle;
}

TriangleMesh MakeBlanketOver(const TriangleMesh& person, Random& random) {
  constexpr double kSpacing = 0.025, kSlope = 1.3;  // [m]; of cloth that hangs off a limb
  const double upper = random.Uniform(-0.25, 0.35);
  const double thickness = random.Uniform(0.008, 0.03), fold = random.Uniform(0.005, 0.025);
  Eigen::AlignedBox2d covered;
  for (const Eigen::Vector3f& vertex : person.vertices)
    if (vertex.x() < upper) covered.extend(vertex.head<2>().cast<double>());
  if (covered.isEmpty()) return {};
  const Eigen::Vector2d low = covered.min().array() - random.Uniform(0.05, 0.3);
  const int columns = static_cast<int>((upper - low.x()) / kSpacing) + 1;
  const int rows =
      static_cast<int>((covered.max().y() + random.Uniform(0.05, 0.3) - low.y()) / kSpacing) + 1;
  std::vector<double> height(static_cast<std::size_t>(rows * columns), 0);
  const auto at = [&](int row, int column) -> double& {
    return height[static_cast<std::size_t>(row * columns + column)];
  };
  for (const Eigen::Vector3f& vertex : person.vertices) {
    const int row = static_cast<int>((vertex.y() - low.y()) / kSpacing);
    const int column = static_cast<int>((vertex.x() - low.x()) / kSpacing);
    if (vertex.x() >= upper || row < 0 || column < 0 || row >= rows || column >= columns) continue;
    at(row, column) = std::max<double>(at(row, column), vertex.z());
  }
  // Cloth spans what lies between: it sinks no steeper than its slope. Two sweeps, there and back.
  const double drop = kSlope * kSpacing;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (row > 0) at(row, column) = std::max(at(row, column), at(row - 1, column) - drop);
      if (column > 0) at(row, column) = std::max(at(row, column), at(row, column - 1) - drop);
    }
  for (int row = rows - 1; row >= 0; --row)
    for (int column = columns - 1; column >= 0; --column) {
      if (row + 1 < rows) at(row, column) = std::max(at(row, column), at(row + 1, column) - drop);
      if (column + 1 < columns)
        at(row, column) = std::max(at(row, column), at(row, column + 1) - drop);
    }
  const SmoothNoise noise(random.Bits());
  TriangleMesh blanket;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = low.x() + column * kSpacing, y = low.y() + row * kSpacing;
      const double folds = fold * (1 + noise.At({x / 0.2, y / 0.2, 0}));
      blanket.vertices.push_back(
          Eigen::Vector3d(x, y, at(row, column) + thickness + folds).cast<float>());
    }
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const auto a = static_cast<std::uint32_t>(row * columns + column), b = a + 1;
      const auto d = a + static_cast<std::uint32_t>(columns), c = d + 1;
      blanket.triangles.push_back({a, b, c});
      blanket.triangles.push_back({a, c, d});
    }
  blanket.SetAlbedo(random.Uniform(0.1, 0.9));
  return blanket;
}

}  // namespace fallen::sim
