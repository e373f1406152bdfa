// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_scene.hpp"

#include <stdexcept>

namespace fallen {

ClusterScene::ClusterScene(const SegmentedMap& map) : segmented(map) {
  if (!map.ground.ok()) throw std::invalid_argument("cluster_features: the map has no floor");
  KeptVector<NdtCell> members;
  heights_m.reserve(map.cells.size());
  for (const ScoredCell& scored : map.cells) {
    if (scored.cluster >= 0) members.push_back(scored.cell);
    heights_m.push_back(
        static_cast<float>(map.ground.plane.SignedHeight(scored.cell.mean.cast<double>())));
  }
  KeptVector<CellNormal> of_members;
  ComputeNormals(members, map.iron, of_members);
  normals.resize(map.cells.size());
  auto next = of_members.begin();
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (map.cells[i].cluster >= 0) normals[i] = *next++;
}

}  // namespace fallen
