// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fallen/geometry/oriented_box.hpp"
#include "fallen/segmentation/cell_segmentation.hpp"
#include "fallen/segmentation/dbscan.hpp"

namespace fallen {

/// About the length of a tall person, arms not stretched [m].
inline constexpr double kPersonLength_m = 2.0;

/// Finds parts of a cluster that may be a person alone, where the whole is a person joined with the
/// dog beside him or the sofa that he lies against, cluster after cluster in the same memory.
///
/// Goes beyond the paper, which judges whole clusters. Two kinds:
/// - what DBSCAN makes of the members whose score is at least 1/3, and 2/3, of the cluster's high
///   scores (their 95 % quantile),
/// - of a cluster longer or wider than a person, its halves and quarters, by 2-means along the
///   floor.
/// Parts overlap each other; each has at least 40 members and at most 95 % of the whole's.
/// Deterministic.
class ClusterPartFinder {
 public:
  /// @param box  FitUprightBox of the cluster.
  void Find(const SegmentedMap& segmented, const CellCluster& cluster, const OrientedBox& box);

  /// What was found, until the next call: members as positions in `cluster.cells`, ascending.
  std::size_t count() const { return ends_.size(); }
  std::span<const std::int32_t> part(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return std::span(members_).subspan(begin, ends_[i] - begin);
  }

 private:
  class Search;

  std::vector<std::int32_t> members_;  // part by part
  std::vector<std::size_t> ends_;
  PointClusterer clusterer_;
};

/// Makes `part` the cluster of these members of `cluster`, in memory that is there.
void TakeMembers(const CellCluster& cluster, std::span<const std::int32_t> members,
                 CellCluster& part);

}  // namespace fallen
