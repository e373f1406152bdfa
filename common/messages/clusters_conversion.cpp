// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/map_part_conversion.hpp"

namespace fallen {
namespace {

const std::string kClusters = "clusters_t";
const std::string kMembers = kClusters + ".members";
const std::string kOthers = kClusters + ".other";

void CheckBackgroundStatus(const clusters_t& message) {
  checks::InRange(kClusters + ".background_status", message.background_status, 0,
                  static_cast<int>(BackgroundStatus::kNoPose));
}

[[noreturn]] void FailEmptyCluster(std::size_t cluster) {
  checks::Fail("clusters_t.cluster", "no cell in cluster " + std::to_string(cluster),
               "clusters without gaps");
}

// Members with all that is known of them, of the others the mean.
void ScoredCellsToMessage(const SegmentedMap& segmented, clusters_t& message) {
  message.cell_count = static_cast<std::int32_t>(segmented.cells.size());
  message.score.reserve(segmented.cells.size());
  message.cluster.reserve(segmented.cells.size());
  std::size_t member = 0;
  for (const ScoredCell& scored : segmented.cells) {
    checks::Score(kClusters + ".score", scored.score);
    message.score.push_back(scored.score);
    message.cluster.push_back(scored.cluster);
    if (scored.cluster >= 0) {
      if (member == segmented.members.size() || segmented.members[member].mean != scored.mean)
        checks::Fail(kMembers, "no cell " + std::to_string(member) + " or another",
                     "the cells in clusters, in the order of all cells");
      CheckNearCamera(kMembers, member++, scored.mean, segmented.T_map_camera);
      continue;
    }
    CheckNearCamera(kOthers, message.other_mean_x.size(), scored.mean, segmented.T_map_camera);
    message.other_mean_x.push_back(scored.mean.x());
    message.other_mean_y.push_back(scored.mean.y());
    message.other_mean_z.push_back(scored.mean.z());
  }
  checks::Count(kMembers + ".count", static_cast<std::int64_t>(segmented.members.size()), member);
  message.members = CellsToMessage(segmented.members);
  message.other_count = static_cast<std::int32_t>(message.other_mean_x.size());
}

void ScoredCellsFromMessage(const clusters_t& message, SegmentedMap& segmented) {
  checks::Count(kClusters + ".cell_count", message.cell_count, message.score.size());
  checks::Count(kClusters + ".cell_count", message.cell_count, message.cluster.size());
  for (const auto* means : {&message.other_mean_x, &message.other_mean_y, &message.other_mean_z})
    checks::Count(kClusters + ".other_count", message.other_count, means->size());
  segmented.members = CellsFromMessage(kMembers, message.members);
  std::size_t members = 0;
  for (const std::int32_t cluster : message.cluster) members += cluster >= 0;
  checks::Count(kMembers + ".count", message.members.count, members);
  checks::Count(kClusters + ".other_count", message.other_count, message.cluster.size() - members);
  segmented.cells.reserve(message.cluster.size());
  std::size_t member = 0, other = 0;
  for (std::size_t i = 0; i < message.cluster.size(); ++i) {
    checks::Score(kClusters + ".score", message.score[i]);
    ScoredCell scored{{}, message.score[i], message.cluster[i]};
    if (scored.cluster >= 0) {
      scored.mean = segmented.members[member].mean;
      CheckNearCamera(kMembers, member++, scored.mean, segmented.T_map_camera);
    } else {
      scored.mean = {message.other_mean_x[other], message.other_mean_y[other],
                     message.other_mean_z[other]};
      CheckNearCamera(kOthers, other++, scored.mean, segmented.T_map_camera);
    }
    segmented.cells.push_back(scored);
  }
}

// Descriptors in the order of the cells; that each cluster lists its own cells, and has some, is
// checked on the way.
std::vector<std::vector<float>> DescriptorsToMessage(const SegmentedMap& segmented, int dimension) {
  std::vector<std::vector<float>> rows;
  std::vector<std::size_t> next(segmented.clusters.size(), 0);
  for (std::size_t i = 0; i < segmented.cells.size(); ++i) {
    const std::int32_t cluster = segmented.cells[i].cluster;
    if (cluster == -1) continue;
    if (cluster < 0 || static_cast<std::size_t>(cluster) >= segmented.clusters.size())
      checks::Fail("clusters_t.cluster", std::to_string(cluster),
                   "-1 or less than " + std::to_string(segmented.clusters.size()));
    const CellCluster& members = segmented.clusters[cluster];
    const std::size_t row = next[cluster]++;
    if (row >= members.cells.size() || members.cells[row] != static_cast<std::int32_t>(i) ||
        static_cast<std::size_t>(members.descriptors.rows()) < members.cells.size() ||
        members.descriptors.cols() != dimension)
      checks::Fail("clusters_t.descriptor",
                   "cluster " + std::to_string(cluster) + " without cell " + std::to_string(i),
                   "each cluster's cells, ascending, with a descriptor each");
    const auto values = members.descriptors.row(static_cast<Eigen::Index>(row));
    rows.emplace_back(values.data(), values.data() + dimension);
    checks::AllFinite("clusters_t.descriptor", std::span<const float>(rows.back()));
  }
  for (std::size_t c = 0; c < next.size(); ++c) {
    if (next[c] == 0) FailEmptyCluster(c);
    if (next[c] != segmented.clusters[c].cells.size())
      checks::Fail("clusters_t.cluster",
                   std::to_string(segmented.clusters[c].cells.size()) + " cells in cluster " +
                       std::to_string(c),
                   std::to_string(next[c]) + ", those that name it");
  }
  return rows;
}

// Cells of each cluster, ascending.
std::vector<CellCluster> ClustersFromMessage(const clusters_t& message) {
  std::vector<CellCluster> clusters;
  const auto count = static_cast<std::int64_t>(message.cluster.size());
  for (std::size_t i = 0; i < message.cluster.size(); ++i) {
    const std::int32_t cluster = message.cluster[i];
    if (cluster < -1 || cluster >= count)
      checks::Fail("clusters_t.cluster[" + std::to_string(i) + "]", std::to_string(cluster),
                   "-1 to " + std::to_string(count - 1));
    if (cluster < 0) continue;
    if (static_cast<std::size_t>(cluster) >= clusters.size()) clusters.resize(cluster + 1);
    clusters[cluster].cells.push_back(static_cast<std::int32_t>(i));
  }
  for (std::size_t c = 0; c < clusters.size(); ++c)
    if (clusters[c].cells.empty()) FailEmptyCluster(c);
  return clusters;
}

void FillDescriptors(const clusters_t& message, std::vector<CellCluster>& clusters) {
  std::size_t members = 0;
  for (CellCluster& cluster : clusters) {
    cluster.descriptors.resize(static_cast<Eigen::Index>(cluster.cells.size()), message.dimension);
    members += cluster.cells.size();
  }
  checks::Count("clusters_t.descriptor_count", message.descriptor_count, message.descriptor.size());
  checks::Count("clusters_t.descriptor_count (cells in clusters)", message.descriptor_count,
                members);
  std::vector<Eigen::Index> next(clusters.size(), 0);
  std::size_t row = 0;
  for (const std::int32_t cluster : message.cluster) {
    if (cluster < 0) continue;
    const std::vector<float>& values = message.descriptor[row++];
    checks::Count("clusters_t.dimension", message.dimension, values.size());
    checks::AllFinite("clusters_t.descriptor", std::span<const float>(values));
    std::copy(values.begin(), values.end(),
              clusters[cluster].descriptors.row(next[cluster]++).data());
  }
}

}  // namespace

clusters_t ToMessage(const Header& header, const SegmentedMap& segmented) {
  clusters_t message{};
  MapPartToMessage(kClusters, header, segmented, message);
  message.background_status = static_cast<std::int32_t>(segmented.background);
  CheckBackgroundStatus(message);
  message.iron = IronToMessage(segmented.iron);
  ScoredCellsToMessage(segmented, message);
  message.dimension = segmented.iron.dimension();
  message.descriptor = DescriptorsToMessage(segmented, message.dimension);
  message.descriptor_count = static_cast<std::int32_t>(message.descriptor.size());
  return message;
}

SegmentedMap FromMessage(const clusters_t& message) {
  SegmentedMap segmented;
  MapPartFromMessage(kClusters, message, segmented);
  CheckBackgroundStatus(message);
  segmented.background = static_cast<BackgroundStatus>(message.background_status);
  segmented.iron = IronFromMessage(kClusters, message.iron);
  checks::InRange(kClusters + ".dimension", message.dimension, segmented.iron.dimension(),
                  segmented.iron.dimension());

  segmented.clusters = ClustersFromMessage(message);
  ScoredCellsFromMessage(message, segmented);
  FillDescriptors(message, segmented.clusters);
  return segmented;
}

}  // namespace fallen
