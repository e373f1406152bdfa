// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/distractors.hpp"

#include <cmath>
#include <stdexcept>

#include "tools/simulate/persons.hpp"
#include "tools/simulate/resting_person.hpp"
#include "tools/simulate/smooth_noise.hpp"

namespace fallen::sim {
namespace {

void Rest(TriangleMesh& mesh) {
  const Eigen::AlignedBox3f bounds = mesh.Bounds();
  const Eigen::Vector3f middle = bounds.center();
  mesh.Transform(
      Eigen::Affine3f(Eigen::Translation3f(-middle.x(), -middle.y(), -bounds.min().z())));
}

TriangleMesh FromCatalogue(const FurnitureModel& model, double scale) {
  TriangleMesh mesh = LoadFurnitureMesh(model);
  mesh.Transform(Eigen::Affine3f(Eigen::Scaling(static_cast<float>(scale))));
  return mesh;
}

TriangleMesh MakeCushion(Random& random) {
  const double side = random.Uniform(0.35, 0.6);
  TriangleMesh mesh =
      MakeSuperellipsoid({side, side * random.Uniform(0.7, 1), random.Uniform(0.1, 0.2)}, 1, 0.4,
                         random.Uniform(0.2, 0.9));
  mesh.Transform(Eigen::Affine3f(
      Eigen::AngleAxisf(static_cast<float>(random.Normal(0, 0.15)), Eigen::Vector3f::UnitX())));
  return mesh;
}

TriangleMesh MakeCardboardBox(Random& random) {
  return MakeBox({random.Uniform(0.25, 0.7), random.Uniform(0.2, 0.5), random.Uniform(0.15, 0.5)},
                 random.Uniform(0.4, 0.7));
}

// A soft bag: fatter below, with two handles.
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

TriangleMesh MakeSleepingBag(Random& random) {
  TriangleMesh mesh =
      MakeHeap({random.Uniform(1.5, 2.0), random.Uniform(0.6, 0.8), random.Uniform(0.08, 0.16)},
               0.25, random);
  return mesh;
}

}  // namespace

const std::vector<std::string>& DistractorKinds() {
  static const std::vector<std::string> kinds = {"dog",
                                                 "lying_dog",
                                                 "cat",
                                                 "bag",
                                                 "sports_bag",
                                                 "cushion",
                                                 "box",
                                                 "clothes",
                                                 "blanket",
                                                 "bedding",
                                                 "vacuum_cleaner",
                                                 "rollator",
                                                 "standing_person",
                                                 "sitting_person",
                                                 kResting};
  return kinds;
}

TriangleMesh MakeHeap(const Eigen::Vector3d& size, double fold_length_m, Random& random) {
  constexpr double kSpacing = 0.02;
  const SmoothNoise noise(random.Bits());
  const double roundness = random.Uniform(1.5, 4);
  const int columns = static_cast<int>(size.x() / kSpacing) + 2,
            rows = static_cast<int>(size.y() / kSpacing) + 2;
  TriangleMesh mesh;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = (static_cast<double>(column) / (columns - 1) - 0.5) * size.x();
      const double y = (static_cast<double>(row) / (rows - 1) - 0.5) * size.y();
      // The outline is wavy, and folds are ridges: where noise crosses zero.
      const double wave = 0.25 * noise.At({2.5 * x / size.x(), 2.5 * y / size.y(), 7});
      const double radius = std::hypot(2 * x / size.x(), 2 * y / size.y()) * (1 + wave);
      const double dome = std::max(0.0, 1 - std::pow(radius, roundness));
      const double fold = 1 - std::abs(noise.At({x / fold_length_m, y / fold_length_m, 0}));
      const double bump = noise.At({x / (3 * fold_length_m), y / (3 * fold_length_m), 3});
      const double z = size.z() * std::sqrt(dome) * (0.35 + 0.45 * fold + 0.3 * bump);
      mesh.vertices.push_back(
          {static_cast<float>(x), static_cast<float>(y), static_cast<float>(std::max(0.0, z))});
    }
  }
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const auto a = static_cast<std::uint32_t>(row * columns + column), b = a + 1;
      const auto d = a + static_cast<std::uint32_t>(columns), c = d + 1;
      // What lies flat on the floor is no part of the heap.
      const auto flat = [&](std::uint32_t i) { return mesh.vertices[i].z() <= 0; };
      if (flat(a) && flat(b) && flat(c) && flat(d)) continue;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  mesh.SetAlbedo(random.Uniform(0.2, 0.9));
  return mesh;
}

TriangleMesh MakeLyingDog(Random& random) {
  const double scale = random.Uniform(0.75, 1.25);  // 1: a Labrador, 0.9 m without the tail
  const double albedo = random.Uniform(0.12, 0.8);
  const double bend = random.Normal(0, 0.12);
  const bool on_side = random.Chance(0.4);
  TriangleMesh mesh;
  const auto tube = [&](std::vector<Eigen::Vector3d> points, std::vector<double> radii) {
    for (Eigen::Vector3d& p : points) p *= scale;
    for (double& r : radii) r *= scale;
    mesh.Append(MakeTube(points, radii, albedo));
  };
  const double z = on_side ? 0.12 : 0.15;
  tube({{-0.38, bend, z}, {-0.2, bend / 2, z + 0.01}, {0.05, 0, z + 0.02}, {0.25, 0, z + 0.02}},
       {0.11, 0.115, 0.135, 0.11});
  const double head_z = on_side ? 0.09 : random.Uniform(0.12, 0.42);
  const double turn = random.Normal(0, 0.15);
  tube({{0.25, 0, z + 0.03}, {0.36, turn / 2, (z + head_z) / 2 + 0.03}, {0.46, turn, head_z}},
       {0.09, 0.075, 0.075});
  tube({{0.44, turn, head_z}, {0.55, turn * 1.3, head_z - 0.01}, {0.64, turn * 1.5, head_z - 0.03}},
       {0.08, 0.07, 0.035});
  for (const double side : {-1.0, 1.0}) {
    const double y = on_side ? 0.15 : side * 0.11, low = on_side ? 0.06 + 0.05 * side : 0.045;
    const double spread = on_side ? 0.3 : 0.04;
    tube({{0.18, y * 0.7, z - 0.03}, {0.28, y + spread / 2, low}, {0.5, y + spread, low}},
         {0.06, 0.04, 0.03});
    tube({{-0.3, y * 0.9, z - 0.01},
          {-0.15, y + spread / 2 + 0.03, low + 0.02},
          {-0.02, y + spread + 0.05, low - 0.01}},
         {0.085, 0.05, 0.03});
    tube({{0.45, turn + side * 0.06, head_z + 0.05}, {0.44, turn + side * 0.1, head_z - 0.02}},
         {0.025, 0.03});
  }
  tube({{-0.45, bend, z}, {-0.6, bend + 0.1, 0.05}, {-0.75, bend + 0.22, 0.03}},
       {0.035, 0.03, 0.02});
  for (Eigen::Vector3f& vertex : mesh.vertices) vertex.z() = std::max(0.0f, vertex.z());
  return mesh;
}

TriangleMesh MakeVacuumCleaner(Random& random) {
  TriangleMesh mesh =
      MakeSuperellipsoid({random.Uniform(0.38, 0.5), 0.29, random.Uniform(0.2, 0.28)}, 0.6, 0.7,
                         random.Uniform(0.15, 0.7));
  Rest(mesh);
  for (const double side : {-1.0, 1.0})
    mesh.Append(
        MakeTube({{-0.12, side * 0.13, 0.075}, {-0.12, side * 0.16, 0.075}}, {0.075, 0.075}, 0.2));
  // The hose lies in a loop and ends in a pipe with a nozzle.
  std::vector<Eigen::Vector3d> hose = {{0.2, 0, 0.15}};
  const double radius = random.Uniform(0.25, 0.4), start = random.Uniform(-1.5, -0.5);
  for (double angle = start; angle < start + 4.5; angle += 0.3)
    hose.push_back({0.45 + radius * std::cos(angle), radius * std::sin(angle), 0.03});
  mesh.Append(MakeTube(hose, std::vector<double>(hose.size(), 0.022), 0.25));
  const Eigen::Vector3d end = hose.back(), away(std::cos(start + 5.5), std::sin(start + 5.5), 0);
  mesh.Append(MakeTube({end, end + 0.9 * away}, {0.018, 0.018}, 0.6));
  TriangleMesh nozzle = MakeBox({0.1, 0.27, 0.05}, 0.25);
  const Eigen::Vector3d place = end + 0.95 * away;
  nozzle.Transform(
      Eigen::Translation3f(static_cast<float>(place.x()), static_cast<float>(place.y()), 0.025f) *
      Eigen::AngleAxisf(static_cast<float>(start + 5.5), Eigen::Vector3f::UnitZ()));
  mesh.Append(nozzle);
  return mesh;
}

TriangleMesh MakeRollator(Random& random) {
  const double width = random.Uniform(0.5, 0.6), length = random.Uniform(0.55, 0.68);
  const double handle = random.Uniform(0.8, 0.95);
  const std::vector<double> pipe = {0.013, 0.013};
  TriangleMesh mesh;
  for (const double side : {-0.5, 0.5}) {
    const double y = side * width;
    mesh.Append(MakeTube({{length / 2, y, 0.1}, {0.0, y, 0.55}, {-length * 0.35, y, handle}},
                         {0.013, 0.013, 0.013}, 0.6));
    mesh.Append(MakeTube({{-length / 2, y, 0.1}, {0.0, y, 0.55}}, pipe, 0.6));
    mesh.Append(MakeTube({{-length * 0.35, y, handle}, {-length * 0.35 - 0.14, y, handle - 0.02}},
                         {0.018, 0.018}, 0.2));
    for (const double x : {-length / 2, length / 2})
      mesh.Append(MakeTube({{x, y - 0.012, 0.1}, {x, y + 0.012, 0.1}}, {0.095, 0.095}, 0.2));
  }
  TriangleMesh seat = MakeBox({0.24, width * 0.9, 0.025}, 0.3);
  seat.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, 0.55f)));
  mesh.Append(seat);
  if (random.Chance(0.5)) {
    TriangleMesh basket = MakeBox({0.22, width * 0.7, 0.2}, 0.4);
    basket.Transform(Eigen::Affine3f(Eigen::Translation3f(0.12f, 0, 0.38f)));
    mesh.Append(basket);
  }
  return mesh;
}

Distractor MakeDistractor(const std::string& kind, const FurnitureCatalogue& catalogue,
                          const HumanModel& humans, FurniturePool pool, Random& random) {
  Distractor distractor{kind, kind, {}};
  const auto from_catalogue = [&](FurnitureRole role, double scale) {
    const auto models = catalogue.Select(role, pool);
    if (models.empty()) return false;
    const FurnitureModel* model = random.Pick(models);
    distractor.name = model->name;
    distractor.mesh = FromCatalogue(*model, scale);
    return true;
  };
  // Bodies of distractors are none of the numbered ones that recordings are split by.
  constexpr int kFirstBystander = 1000000;
  const auto bystander = [&] { return DrawBodyShape(kFirstBystander + random.Index(1000)); };
  if (kind == "dog") {
    from_catalogue(FurnitureRole::kDog, random.Uniform(0.8, 1.4));
  } else if (kind == "cat") {
    from_catalogue(FurnitureRole::kCat, random.Uniform(0.8, 1.1));
  } else if (kind == "bag") {
    if (!from_catalogue(FurnitureRole::kBag, 1)) distractor.mesh = MakeSportsBag(random);
  } else if (kind == "lying_dog") {
    distractor.mesh = MakeLyingDog(random);
  } else if (kind == "sports_bag") {
    distractor.mesh = MakeSportsBag(random);
  } else if (kind == "cushion") {
    distractor.mesh = MakeCushion(random);
  } else if (kind == "box") {
    distractor.mesh = MakeCardboardBox(random);
  } else if (kind == "clothes") {
    distractor.mesh =
        MakeHeap({random.Uniform(0.4, 0.8), random.Uniform(0.3, 0.6), random.Uniform(0.08, 0.22)},
                 random.Uniform(0.08, 0.15), random);
  } else if (kind == "blanket") {
    distractor.mesh =
        MakeHeap({random.Uniform(0.7, 1.6), random.Uniform(0.5, 1.0), random.Uniform(0.15, 0.4)},
                 random.Uniform(0.12, 0.3), random);
  } else if (kind == "bedding") {
    distractor.mesh = MakeSleepingBag(random);
  } else if (kind == "vacuum_cleaner") {
    distractor.mesh = MakeVacuumCleaner(random);
  } else if (kind == "rollator") {
    distractor.mesh = MakeRollator(random);
  } else if (kind == "standing_person") {
    distractor.mesh = MakeStandingPerson(humans, bystander(), random);
  } else if (kind == "sitting_person") {
    // On a stool of its own; people on sofas would need the sofa's seat.
    const double seat = random.Uniform(0.42, 0.5);
    distractor.mesh = MakeSittingPerson(humans, bystander(), seat, random);
    TriangleMesh stool = MakeSuperellipsoid({0.42, 0.42, 0.06}, 0.3, 0.3, 0.5);
    stool.Transform(Eigen::Affine3f(Eigen::Translation3f(0, 0, static_cast<float>(seat) - 0.03f)));
    for (const double x : {-0.16, 0.16})
      for (const double y : {-0.16, 0.16})
        stool.Append(MakeTube({{x, y, 0.02}, {x, y, seat - 0.04}}, {0.02, 0.02}, 0.5));
    distractor.mesh.Append(stool);
  } else {
    throw std::invalid_argument("distractors: got " + kind + ", expected a known kind");
  }
  Rest(distractor.mesh);
  return distractor;
}

}  // namespace fallen::sim
