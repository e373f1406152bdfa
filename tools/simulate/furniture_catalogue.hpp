// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fallen/geometry/enum_names.hpp"
#include "tools/simulate/triangle_mesh.hpp"

/// Furniture of Debian's package sweethome3d-furniture.
namespace fallen::sim {

/// What a model is good for in a room.
enum class FurnitureRole {
  kSofa,
  kArmchair,
  kChair,
  kTable,
  kCoffeeTable,
  kDesk,
  kBed,
  kCabinet,  ///< stands with its back to a wall: cupboards, shelves, kitchen units, radiators
  kBath,     ///< stands with its back to a wall of a bathroom
  kPlant,
  kSmall,  ///< stands about on the floor: bins, boxes, toys
  kBag,
  kDog,
  kCat,
};

/// Models are split by name, so that a detector is judged on furniture that it was not trained on.
enum class FurniturePool { kTrain, kValidation, kTest, kAll };
constexpr auto EnumNames(FurniturePool) {
  return EnumTable<FurniturePool, 4>{{{FurniturePool::kTrain, "train"},
                                      {FurniturePool::kValidation, "validation"},
                                      {FurniturePool::kTest, "test"},
                                      {FurniturePool::kAll, "all"}}};
}

/// Pool of a model by a stable hash of its name: 60 % train, 20 % validation, 20 % test; two beds
/// are moved, so that there are some in every pool.
FurniturePool PoolOf(const std::string& model_name);

struct FurnitureModel {
  std::string name;  ///< archive and model, e.g. "KatorLegaz/futon-couch"
  FurnitureRole role = FurnitureRole::kSmall;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< width, depth, height [m]
  std::filesystem::path file;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< to apply to the file's vertices
};

struct FurnitureCatalogue {
  std::vector<FurnitureModel> models;  ///< sorted by name

  /// Models of a role in a pool; animals, of which there is one each, are in every pool.
  std::vector<const FurnitureModel*> Select(FurnitureRole role, FurniturePool pool) const;
};

/// Reads the catalogues of the archives and keeps what has a role here.
/// @throws std::runtime_error naming the file that is missing or malformed.
FurnitureCatalogue LoadFurnitureCatalogue(const std::filesystem::path& assets);

/// Role of a model that this project has looked at; nothing for all others (cars, spoons, stairs).
std::optional<FurnitureRole> RoleOf(const std::string& model_name);

/// Loads a model at the size that its catalogue states.
///
/// Frame `furniture`: z up, origin at the middle of the underside, y towards the back.
/// Panes (opacity below a half) are left out: structured light goes through them.
/// @throws std::runtime_error naming the file if it cannot be read.
TriangleMesh LoadFurnitureMesh(const FurnitureModel& model);

}  // namespace fallen::sim
