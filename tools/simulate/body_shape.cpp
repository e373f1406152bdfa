// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/simulate/body_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "tools/simulate/random.hpp"
#include "tools/simulate/smooth_noise.hpp"

namespace fallen::sim {
namespace {

enum class Region { kTop, kLegs, kFeet, kBare };

bool StartsWith(const std::string& text, const char* prefix) { return text.rfind(prefix, 0) == 0; }

Region RegionOf(const std::string& bone) {
  for (const char* name : {"spine01", "spine02", "spine03", "spine04", "clavicle", "shoulder",
                           "upperarm", "lowerarm", "breast"})
    if (StartsWith(bone, name)) return Region::kTop;
  for (const char* name : {"root", "spine05", "pelvis", "upperleg", "lowerleg"})
    if (StartsWith(bone, name)) return Region::kLegs;
  for (const char* name : {"foot", "toe"})
    if (StartsWith(bone, name)) return Region::kFeet;
  return Region::kBare;
}

double ThicknessOf(Region region, const BodyShape& shape) {
  switch (region) {
    case Region::kTop:
      return shape.top_thickness_m;
    case Region::kLegs:
      return shape.legs_thickness_m;
    case Region::kFeet:
      return shape.shoe_thickness_m;
    case Region::kBare:
      break;
  }
  return 0;
}

// Weights of one three-way axis of MakeHuman's macro model: minimum, average, maximum.
std::map<std::string, double> ThreeWay(double value, const std::string& axis) {
  return {{"min" + axis, std::max(0.0, -value)},
          {"average" + axis, 1 - std::abs(value)},
          {"max" + axis, std::max(0.0, value)}};
}

// Weights of MakeHuman's macro targets: the product of the weights of the values in their names.
std::map<std::string, double> MacroTargets(const BodyShape& shape, double height) {
  std::map<std::string, double> targets = shape.details;
  const std::string sex = shape.female ? "female" : "male";
  const std::map<std::string, double> ages = {{"young", 1 - shape.old}, {"old", shape.old}};
  const std::map<std::string, double> origins = {{"african", shape.african},
                                                 {"asian", shape.asian},
                                                 {"caucasian", 1 - shape.african - shape.asian}};
  const std::string proportion = shape.proportions < 0 ? "uncommonproportions" : "idealproportions";
  const std::string stature = height < 0 ? "minheight" : "maxheight";
  for (const auto& [age, age_weight] : ages) {
    for (const auto& [origin, share] : origins)
      targets["macrodetails/" + origin + "-" + sex + "-" + age] = share * age_weight;
    for (const auto& [muscle, muscle_weight] : ThreeWay(shape.muscle, "muscle")) {
      for (const auto& [weight, weight_weight] : ThreeWay(shape.weight, "weight")) {
        const std::string build = sex + "-" + age + "-" + muscle + "-" + weight;
        const double product = age_weight * muscle_weight * weight_weight;
        targets["macrodetails/universal-" + build] = product;
        targets["macrodetails/height/" + build + "-" + stature] = product * std::abs(height);
        targets["macrodetails/proportions/" + build + "-" + proportion] =
            product * std::abs(shape.proportions);
      }
    }
  }
  return targets;
}

double StandingHeight(const Eigen::Matrix3Xf& vertices, const std::vector<int>& body) {
  float low = vertices(1, body.front()), high = low;
  for (const int v : body) {
    low = std::min(low, vertices(1, v));
    high = std::max(high, vertices(1, v));
  }
  return high - low;
}

std::vector<int> BodyVertices(const HumanModel& model) {
  std::set<int> vertices;
  for (const HumanQuad& quad : model.quads)
    if (quad.surface == HumanSurface::kBody)
      vertices.insert(quad.vertices.begin(), quad.vertices.end());
  return {vertices.begin(), vertices.end()};
}

Eigen::Matrix3Xf VertexNormals(const HumanModel& model, const Eigen::Matrix3Xf& vertices) {
  Eigen::Matrix3Xf normals = Eigen::Matrix3Xf::Zero(3, vertices.cols());
  for (const HumanQuad& quad : model.quads) {
    const auto& q = quad.vertices;
    const Eigen::Vector3f diagonal_a = vertices.col(q[2]) - vertices.col(q[0]);
    const Eigen::Vector3f diagonal_b = vertices.col(q[3]) - vertices.col(q[1]);
    const Eigen::Vector3f normal = diagonal_a.cross(diagonal_b);
    for (const std::uint32_t v : q) normals.col(v) += normal;
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v)
    if (normals.col(v).norm() > 0) normals.col(v).normalize();
  return normals;
}

// Clothes are the skin moved outwards, by a thickness that varies as cloth does.
Eigen::Matrix3Xf Dress(const HumanModel& model, const BodyShape& shape,
                       const Eigen::Matrix3Xf& skin) {
  constexpr double kWrinkleLength = 0.12;  // [m], between folds of a pullover or trousers
  const Eigen::Matrix3Xf normals = VertexNormals(model, skin);
  const SmoothNoise noise(MixBits(static_cast<std::uint64_t>(shape.id)));
  Eigen::Matrix3Xf dressed = skin;
  for (Eigen::Index v = 0; v < skin.cols(); ++v) {
    double thickness = 0;
    for (int k = 0; k < kInfluencesPerVertex; ++k) {
      const auto bone = static_cast<std::size_t>(model.skin_bones[v][k]);
      thickness += model.skin_weights[v][k] * ThicknessOf(RegionOf(model.bones[bone].name), shape);
    }
    const Eigen::Vector3d place = skin.col(v).cast<double>() / kWrinkleLength;
    dressed.col(v) += normals.col(v) * static_cast<float>(thickness * (1 + noise.At(place)));
  }
  return dressed;
}

std::vector<Eigen::Vector3d> Joints(const HumanModel& model, const Eigen::Matrix3Xf& vertices,
                                    std::vector<int> Bone::*joint) {
  std::vector<Eigen::Vector3d> joints;
  for (const Bone& bone : model.bones) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : bone.*joint) sum += vertices.col(v).cast<double>();
    joints.push_back(sum / static_cast<double>((bone.*joint).size()));
  }
  return joints;
}

}  // namespace

BodyShape DrawBodyShape(int id) {
  Random random = Random::Stream(static_cast<std::uint64_t>(id), "body");
  BodyShape shape;
  shape.id = id;
  shape.female = random.Chance(0.5);
  shape.old = random.Uniform();
  shape.muscle = random.BoundedNormal(-0.4 * shape.old, 0.35);
  shape.weight = random.Uniform(-0.85, 0.9);
  // Mean and spread of adults in Germany (Mikrozensus 2017: 1.66 m and 1.79 m), older ones shorter.
  const double mean_height = (shape.female ? 1.66 : 1.79) - 0.05 * shape.old;
  shape.height_m = std::clamp(random.BoundedNormal(mean_height, 0.085), 1.45, 1.95);
  shape.proportions = random.Uniform(-0.5, 0.8);
  shape.african = random.Chance(0.2) ? random.Uniform() : 0;
  shape.asian = random.Chance(0.2) ? random.Uniform() * (1 - shape.african) : 0;
  const auto either = [&](const char* less, const char* more, double sigma) {
    const double value = random.BoundedNormal(0, sigma);
    shape.details[value < 0 ? less : more] = std::abs(value);
  };
  either("torso/torso-scale-depth-decr", "torso/torso-scale-depth-incr", 0.35);
  either("torso/torso-scale-horiz-decr", "torso/torso-scale-horiz-incr", 0.2);
  either("torso/torso-vshape-less", "torso/torso-vshape-more", 0.3);
  either("stomach/stomach-tone-decr", "stomach/stomach-tone-incr", 0.4);
  either("buttocks/buttocks-volume-decr", "buttocks/buttocks-volume-incr", 0.4);
  // A fourth wears something loose: a dressing gown, a pullover, wide trousers.
  shape.top_thickness_m = random.Uniform(0.003, 0.018);
  shape.legs_thickness_m = random.Uniform(0.003, 0.015);
  if (random.Chance(0.25)) shape.top_thickness_m += random.Uniform(0.01, 0.03);
  if (random.Chance(0.2)) shape.legs_thickness_m += random.Uniform(0.01, 0.025);
  shape.shoe_thickness_m = random.Chance(0.5) ? random.Uniform(0.006, 0.012) : 0.002;
  shape.skirt = shape.female && random.Chance(0.12);  // ankle-long: MakeHuman's helper
  shape.long_hair = random.Chance(shape.female ? 0.6 : 0.05);
  shape.flatness = random.Uniform(0.64, 1.0);
  shape.top_albedo = random.Uniform(0.08, 0.9);
  shape.legs_albedo = random.Uniform(0.10, 0.8);
  shape.hair_albedo = random.Uniform(0.04, 0.5);
  return shape;
}

RestBody MakeRestBody(const HumanModel& model, const BodyShape& shape) {
  RestBody body;
  body.shape = shape;
  body.body_vertices = BodyVertices(model);
  const auto morphed = [&](double height) -> Eigen::Matrix3Xf {
    return model.base_vertices + model.MorphOffsets(MacroTargets(shape, height));
  };
  body.skin = morphed(0);
  const double plain = StandingHeight(body.skin, body.body_vertices);
  const double side = shape.height_m < plain ? -1 : 1;
  const double extreme = StandingHeight(morphed(side), body.body_vertices);
  // Height grows linearly with the weight of a height target.
  const double share = std::clamp((shape.height_m - plain) / (extreme - plain), 0.0, 1.0);
  body.skin = morphed(side * share);
  body.height_m = StandingHeight(body.skin, body.body_vertices);
  body.bone_heads = Joints(model, body.skin, &Bone::head_vertices);
  body.bone_tails = Joints(model, body.skin, &Bone::tail_vertices);
  body.dressed = Dress(model, shape, body.skin);
  return body;
}

BodySurface MakeBodySurface(const HumanModel& model, const BodyShape& shape) {
  constexpr double kSkinAlbedo = 0.6;  // near infrared, little different between skin colours
  const auto byte = [](double albedo) {
    return static_cast<std::uint8_t>(std::lround(255 * albedo));
  };
  BodySurface surface;
  for (const HumanQuad& quad : model.quads) {
    double albedo = kSkinAlbedo;
    if (quad.surface == HumanSurface::kOther) continue;
    if (quad.surface == HumanSurface::kSkirt) {
      if (!shape.skirt) continue;
      albedo = shape.legs_albedo;
    } else if (quad.surface == HumanSurface::kHair) {
      if (!shape.long_hair) continue;
      albedo = shape.hair_albedo;
    } else {
      const auto bone = static_cast<std::size_t>(model.skin_bones[quad.vertices[0]][0]);
      const Region region = RegionOf(model.bones[bone].name);
      if (region == Region::kTop) albedo = shape.top_albedo;
      if (region == Region::kLegs || region == Region::kFeet) albedo = shape.legs_albedo;
    }
    const auto& q = quad.vertices;
    surface.triangles.push_back({q[0], q[1], q[2]});
    surface.triangles.push_back({q[0], q[2], q[3]});
    surface.albedo.insert(surface.albedo.end(), 2, byte(albedo));
  }
  return surface;
}

}  // namespace fallen::sim
