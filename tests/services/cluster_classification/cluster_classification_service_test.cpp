// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "services/cluster_classification/cluster_classification_service.hpp"

#include <gmock/gmock.h>

#include <random>

#include "fallen/messages/conversions.hpp"
#include "tests/support/memq_service.hpp"
#include "tests/support/synthetic_model.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing_support::MemqLink;
using testing_support::SyntheticModel;

/// Two clusters of 20 cells with descriptors drawn at random.
SegmentedMap TwoClusters() {
  SegmentedMap map;
  map.ground.status = GroundStatus::kOk;
  map.frame = MapFrame::kLevel;
  std::mt19937 generator(3);
  const int dimension = map.iron.dimension();
  for (int cluster = 0; cluster < 2; ++cluster) {
    CellCluster& members = map.clusters.emplace_back();
    members.descriptors.resize(20, dimension);
    for (int i = 0; i < 20; ++i) {
      members.cells.push_back(static_cast<std::int32_t>(map.cells.size()));
      NdtCell& cell = map.members.emplace_back();
      cell.mean =
          Eigen::Vector3f(static_cast<float>(2 * cluster), 0.05F * static_cast<float>(i), 0.1F);
      cell.covariance = {2e-4F, 0, 0, 2e-4F, 0, 1e-5F};
      cell.point_count = 5;
      map.cells.push_back({cell.mean, 0.5F, cluster});
      for (int k = 0; k < dimension; ++k)
        members.descriptors(i, k) = static_cast<float>(generator() % 100) / 1000.0F;
    }
  }
  return map;
}

class ClusterClassificationServiceTest : public testing::Test {
 protected:
  ClusterClassificationServiceTest()
      : service_(link_.lcm(), MemqLink::Options("cluster-classification"),
                 SyntheticModel().clusters, ClassificationConfig{}) {
    link_.Collect("FALLEN_PERSONS_CAMERA");
  }

  MemqLink link_;
  ClusterClassificationService service_;
  const Header header_{1'234'567, 42, "CAMERA"};
};

TEST_F(ClusterClassificationServiceTest, DecisionIsThatOfTheLibraryBitForBit) {
  const Decision decision = ClassifyClusters(TwoClusters(), SyntheticModel().clusters);
  ASSERT_EQ(decision.hypotheses.size(), 2U);
  link_.SendMessage("CLUSTERS_CAMERA", ToMessage(header_, TwoClusters()));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  EXPECT_EQ(link_.answers()[0], EncodeMessage(ToMessage(header_, decision)));
}

TEST_F(ClusterClassificationServiceTest, FrameWithoutClustersIsDecidedToo) {
  link_.SendMessage("CLUSTERS_CAMERA", ToMessage(header_, SegmentedMap{}));
  link_.Exchange(service_.loop());
  ASSERT_EQ(link_.answers().size(), 1U);
  const auto answer = DecodeMessage<fallen_persons_t>(link_.answers()[0]).message.value();
  EXPECT_EQ(answer.count, 0);
  EXPECT_EQ(FromMessage(answer.header), header_);
}

TEST_F(ClusterClassificationServiceTest, DescriptorsOfAnotherKindAreDroppedCountedAndSaid) {
  SegmentedMap other = TwoClusters();
  other.iron.radius_m = 0.3;
  link_.SendMessage("CLUSTERS_CAMERA", ToMessage(header_, other));
  link_.Exchange(service_.loop());
  EXPECT_TRUE(link_.answers().empty());
  const service_status_t status = service_.loop().reporter().Status();
  EXPECT_EQ(status.dropped_damaged, 1);
  EXPECT_EQ(status.state, service_status_t::DEGRADED);
  EXPECT_THAT(status.text, HasSubstr("dropped: "));
}

TEST_F(ClusterClassificationServiceTest, BrokenMessageIsCountedAndItGoesOn) {
  std::vector<std::uint8_t> broken = EncodeMessage(ToMessage(header_, TwoClusters()));
  broken.resize(broken.size() - 9);
  link_.Send("CLUSTERS_CAMERA", broken);
  link_.Exchange(service_.loop());
  EXPECT_EQ(service_.loop().reporter().Status().dropped_damaged, 1);
  link_.SendMessage("CLUSTERS_CAMERA", ToMessage(header_, TwoClusters()));
  link_.Exchange(service_.loop());
  EXPECT_EQ(link_.answers().size(), 1U);
}

}  // namespace
}  // namespace fallen
