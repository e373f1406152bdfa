// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/classification/cluster_scene.hpp"

#include <stdexcept>

namespace fallen {

ClusterScene::ClusterScene(const SegmentedMap& map) : segmented(map) {
  if (!map.ground.ok()) throw std::invalid_argument("cluster_features: the map has no floor");
  std::vector<NdtCell> cells;
  cells.reserve(map.cells.size());
  heights_m.reserve(map.cells.size());
  for (const ScoredCell& scored : map.cells) {
    cells.push_back(scored.cell);
    heights_m.push_back(
        static_cast<float>(map.ground.plane.SignedHeight(scored.cell.mean.cast<double>())));
  }
  normals = ComputeNormals(cells, map.iron);
}

}  // namespace fallen
