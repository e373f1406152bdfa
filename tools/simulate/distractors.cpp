// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/distractors.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include "tools/simulate/dogs.hpp"
#include "tools/simulate/household.hpp"
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

TriangleMesh MakeSleepingBag(Random& random) {
  return MakeHeap({random.Uniform(1.5, 2.1), random.Uniform(0.6, 0.85), random.Uniform(0.08, 0.2)},
                  random.Uniform(0.15, 0.35), random);
}

TriangleMesh MakeClothes(Random& random) {
  return MakeHeap({random.Uniform(0.4, 0.8), random.Uniform(0.3, 0.6), random.Uniform(0.08, 0.22)},
                  random.Uniform(0.08, 0.15), random);
}

TriangleMesh MakeBlanket(Random& random) {
  return MakeHeap({random.Uniform(0.7, 1.8), random.Uniform(0.4, 1.0), random.Uniform(0.15, 0.4)},
                  random.Uniform(0.12, 0.3), random);
}

// Several heaps that run into each other.
TriangleMesh MakePile(Random& random) {
  TriangleMesh mesh;
  for (int i = random.Integer(2, 4); i > 0; --i) {
    TriangleMesh heap = random.Chance(0.5) ? MakeClothes(random) : MakeBlanket(random);
    heap.Transform(
        Eigen::Translation3f(static_cast<float>(random.Normal(0, 0.35)),
                             static_cast<float>(random.Normal(0, 0.15)), 0) *
        Eigen::AngleAxisf(static_cast<float>(random.Uniform(-3, 3)), Eigen::Vector3f::UnitZ()));
    mesh.Append(heap);
  }
  return mesh;
}

// What needs nothing but chance.
const std::map<std::string, TriangleMesh (*)(Random&)>& Makers() {
  static const std::map<std::string, TriangleMesh (*)(Random&)> makers = {
      {"lying_dog", MakeLyingDog},
      {"sitting_dog", MakeSittingDog},
      {"standing_dog", MakeStandingDog},
      {"sports_bag", MakeSportsBag},
      {"backpack_and_bag", MakeBackpackAndBag},
      {"cushion", MakeCushion},
      {"box", MakeCardboardBox},
      {"clothes", MakeClothes},
      {"blanket", MakeBlanket},
      {"pile", MakePile},
      {"sleeping_bag", MakeSleepingBag},
      {"air_mattress", MakeAirMattress},
      {"suitcase", MakeSuitcase},
      {"rolled_carpet", MakeRolledCarpet},
      {"shoes", MakeShoes},
      {"toys", MakeToys},
      {"laundry_basket", MakeLaundryBasket},
      {"vacuum_cleaner", MakeVacuumCleaner},
      {"rollator", MakeRollator}};
  return makers;
}

const std::map<std::string, Stoop>& Stoops() {
  static const std::map<std::string, Stoop> stoops = {{"kneeling_person", Stoop::kKneeling},
                                                      {"bending_person", Stoop::kBending},
                                                      {"crouching_person", Stoop::kCrouching}};
  return stoops;
}

}  // namespace

const std::vector<std::string>& DistractorKinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names = {"dog", "cat", "bag", kStandingPerson, "sitting_person"};
    for (const auto& [name, make] : Makers()) names.push_back(name);
    for (const auto& [name, kind] : Stoops()) names.push_back(name);
    names.insert(names.end(), {kResting, kSeated});
    return names;
  }();
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
  } else if (const auto maker = Makers().find(kind); maker != Makers().end()) {
    distractor.mesh = maker->second(random);
  } else if (const auto stoop = Stoops().find(kind); stoop != Stoops().end()) {
    distractor.mesh = MakeStoopingPerson(humans, bystander(), stoop->second, random);
  } else if (kind == kStandingPerson) {
    distractor.mesh = MakeStandingPerson(humans, bystander(), random);
  } else if (kind == "sitting_person") {
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
