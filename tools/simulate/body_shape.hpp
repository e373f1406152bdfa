// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "tools/simulate/human_model.hpp"

namespace fallen::sim {

/// What a person looks like, apart from the pose.
struct BodyShape {
  int id = 0;
  bool female = false;
  double old = 0;                         ///< 0 young, 1 old
  double muscle = 0;                      ///< -1 least, 1 most
  double weight = 0;                      ///< -1 least, 1 most
  double height_m = 1.7;                  ///< standing, barefoot
  double proportions = 0;                 ///< -1 uncommon, 1 ideal
  double african = 0, asian = 0;          ///< shares; the rest is caucasian
  std::map<std::string, double> details;  ///< further morph targets

  /// Height of what lies flat by that of the rigid body: flesh gives way and a chest settles.
  double flatness = 1;
  double top_thickness_m = 0.01;   ///< of the clothes on trunk and arms
  double legs_thickness_m = 0.01;  ///< of the trousers
  double shoe_thickness_m = 0.005;
  bool skirt = false;
  bool long_hair = false;
  double top_albedo = 0.6, legs_albedo = 0.5, hair_albedo = 0.3;
};

/// The body called `id`: always the same, whatever else is drawn.
BodyShape DrawBodyShape(int id);

/// A body of a shape, standing in MakeHuman's rest pose.
struct RestBody {
  BodyShape shape;
  Eigen::Matrix3Xf skin;     ///< all vertices of the base mesh [m], rest frame
  Eigen::Matrix3Xf dressed;  ///< the same with clothes on
  std::vector<Eigen::Vector3d> bone_heads;
  std::vector<Eigen::Vector3d> bone_tails;
  /// Vertices of the body proper, without helpers.
  std::vector<int> body_vertices;
  double height_m = 0;  ///< reached
};

/// Morphs the base mesh. @throws std::runtime_error if a target is missing.
RestBody MakeRestBody(const HumanModel& model, const BodyShape& shape);

/// Triangles to draw of a body: body, and skirt and hair where worn. Indices into the base mesh.
struct BodySurface {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint8_t> albedo;
};
BodySurface MakeBodySurface(const HumanModel& model, const BodyShape& shape);

}  // namespace fallen::sim
