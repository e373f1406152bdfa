// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "tools/simulate/furniture_catalogue.hpp"

namespace fallen::sim {
namespace {

using Role = FurnitureRole;

const std::map<std::string, Role>& Roles() {
  static const std::map<std::string, Role> roles = [] {
    std::map<std::string, Role> map;
    const auto add = [&](Role role, const char* archive,
                         std::initializer_list<const char*> models) {
      for (const char* model : models) map[std::string(archive) + "/" + model] = role;
    };
    const char *zero = "BlendSwap-CC-0", *by = "BlendSwap-CC-BY", *kator = "KatorLegaz";
    add(Role::kSofa, zero, {"L_shaped_sofa", "sofa", "couch", "couch2", "sofa2", "winchesterSofa"});
    add(Role::kSofa, by, {"cornerSofa", "sofa2", "sofa3", "couch3"});
    add(Role::kSofa, kator, {"futon-couch", "mid-century-bench-sofa", "mid-century-sofa"});
    add(Role::kArmchair, zero, {"armchair", "armchair2", "modernArmchair", "winchesterArmchair"});
    add(Role::kArmchair, by, {"armchair1", "fotel", "armChair2", "leaf_chair"});
    add(Role::kArmchair, kator, {"mid-century-chair", "chair-ottoman"});
    add(Role::kChair, zero,
        {"oakChair", "plasticChair", "sillaBlanca", "chair", "antiqueChair", "chairWithCushion",
         "chair2", "osakaChair", "designChair", "thonet", "silla2", "stool", "stool2",
         "pianoBench"});
    add(Role::kChair, by,
        {"cafe_set_mota_chair", "cafe_set_tonon_chair", "chairWithCushion", "childChair",
         "ella_chair_f", "classSeat", "foldingChair", "plaidChair", "kitchenChair", "chair3",
         "chair4", "green_stool", "wheelchair"});
    add(Role::kChair, kator, {"dining-chair", "office-chair", "cafe-chair", "bar-stool"});
    add(Role::kTable, zero, {"oakTable", "tableWithTablecloth", "table"});
    add(Role::kTable, by, {"cafe_set_mota_table", "cafe_set_tonon_table", "table"});
    add(Role::kTable, kator, {"folding-table", "glass-dining-table", "cafe-table"});
    add(Role::kCoffeeTable, zero, {"bench"});
    add(Role::kCoffeeTable, by, {"coffeeTable"});
    add(Role::kCoffeeTable, kator, {"bench"});
    add(Role::kDesk, zero, {"desk", "lbDesk"});
    add(Role::kDesk, by, {"biurko3", "simpleDesk", "officeTable"});
    add(Role::kDesk, kator, {"custom-desk"});
    add(Role::kBed, zero, {"bed1", "bed2", "bed3", "bedWithTexture"});
    add(Role::kBed, by, {"juniorBed", "lettoCloud", "bunkBed"});
    add(Role::kCabinet, zero,
        {"bedsideTable2", "bookcase", "doubleOven", "shelves", "televisionCabinet",
         "verticalShelves", "wardrobeWithSlidingDoors", "cupboard", "modernVanity", "refrigerator",
         "drawersCabinet", "highCabinet", "largeFridge", "lowerCabinet", "sinkCabinet", "radiator",
         "radiator2", "radiator3"});
    add(Role::kCabinet, by,
        {"bedsideTable", "kitchenDrawersCabinet", "kitchenLowerCabinet", "kitchenSink",
         "kitchenSmallLowerCabinet", "largeStove", "piano", "sef-kasa", "wardrobe",
         "washing_machine", "chest", "tvStand", "bookcase", "dresserWithDrawers", "wardrobe2",
         "workbench"});
    add(Role::kCabinet, kator, {"utility-shelving", "fridge", "filing-cabinet", "full-bookcase"});
    add(Role::kBath, zero, {"toiletsUnit", "washbasin", "bidet", "showerStall"});
    add(Role::kBath, by,
        {"bath_jay_hardy", "toilets_unit_jay_hardy", "washbasin_jay_hardy", "modernToilet",
         "bathroomRadiator"});
    add(Role::kPlant, zero, {"decorativePlant", "plant", "orchids", "plantie"});
    add(Role::kPlant, by,
        {"mediumIndoorPlant", "spatifilum", "yuccaPlant", "decorativePlant", "spider_plant",
         "white_lily"});
    add(Role::kSmall, zero,
        {"crate", "ammoBox", "dustbin", "basketball", "teddyBear", "speaker2", "speaker3", "potty",
         "caballito", "box", "slippers", "tableFan", "riggedFan", "fireExtinguisher",
         "electricGuitar"});
    add(Role::kSmall, by, {"gift", "ballonFoot", "breadBox", "radio"});
    add(Role::kSmall, kator,
        {"recycling-bin", "trunk-large", "bullet-trash-can", "pedestal-vase-lamp"});
    add(Role::kBag, zero, {"briefcase", "handbag"});
    add(Role::kBag, by, {"backpack", "suitcase"});
    add(Role::kDog, by, {"bulldog"});
    add(Role::kCat, by, {"siameseCat"});
    return map;
  }();
  return roles;
}

}  // namespace

std::optional<FurnitureRole> RoleOf(const std::string& model_name) {
  const auto found = Roles().find(model_name);
  if (found == Roles().end()) return std::nullopt;
  return found->second;
}

}  // namespace fallen::sim
