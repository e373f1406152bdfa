// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_scene.hpp"

#include <stdexcept>
#include <string>

namespace fallen {

ClusterScene::ClusterScene(const SegmentedMap& map) : segmented(map) {
  if (!map.ground.ok()) throw std::invalid_argument("cluster_features: the map has no floor");
  heights_m.reserve(map.cells.size());
  member_of_cell.reserve(map.cells.size());
  std::int32_t member = 0;
  for (const ScoredCell& scored : map.cells) {
    heights_m.push_back(
        static_cast<float>(map.ground.plane.SignedHeight(scored.mean.cast<double>())));
    member_of_cell.push_back(member);
    if (scored.cluster >= 0) ++member;
  }
  if (static_cast<std::size_t>(member) != map.members.size())
    throw std::invalid_argument("cluster_features: got " + std::to_string(map.members.size()) +
                                " members for " + std::to_string(member) + " cells in clusters");
  ComputeNormals(map.members, map.iron, normals);
}

}  // namespace fallen
