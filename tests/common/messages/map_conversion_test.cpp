// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "fallen/messages/conversions.hpp"
#include "message_samples.hpp"

namespace fallen {
namespace {

using samples::SampleForeground;
using samples::SampleHeader;
using samples::SampleMap;
using samples::SampleSegmented;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void ExpectEqual(const NdtMap& a, const NdtMap& b) {
  EXPECT_EQ(a.cell_size_m, b.cell_size_m);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.T_map_camera.matrix(), b.T_map_camera.matrix());
  EXPECT_EQ(a.view, b.view);
  EXPECT_EQ(a.ground, b.ground);
  EXPECT_EQ(a.cells, b.cells);
}

template <class Message>
using Spoilers = std::vector<std::pair<const char*, std::function<void(Message&)>>>;

template <class Message, class Convert>
void ExpectEachRefused(const Message& good, const Spoilers<Message>& cases,
                       const Convert& convert) {
  for (const auto& [field, spoil] : cases) {
    Message message = good;
    spoil(message);
    try {
      convert(message);
      ADD_FAILURE() << field << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(),
                  testing::AllOf(testing::StartsWith(field), testing::HasSubstr(": got "),
                                 testing::HasSubstr(", expected ")));
    }
  }
}

TEST(NdtMapConversion, RoundTripIsExact) {
  ExpectEqual(NdtMapFromMessage(ToMessage(SampleHeader(), SampleMap())), SampleMap());
  ExpectEqual(NdtMapFromMessage(ToMessage(SampleHeader(), NdtMap{})), NdtMap{});
  EXPECT_EQ(FromMessage(ToMessage(SampleHeader(), SampleMap()).header), SampleHeader());
}

TEST(NdtMapConversion, ForegroundRoundTripIsExact) {
  const ForegroundMap back = ForegroundFromMessage(ToMessage(SampleHeader(), SampleForeground()));
  ExpectEqual(back.map, SampleMap());
  EXPECT_EQ(back.is_foreground, SampleForeground().is_foreground);
  EXPECT_EQ(back.status, SampleForeground().status);
}

TEST(NdtMapConversion, AnEmptyForegroundIsNoMistake) {
  const ForegroundMap back = ForegroundFromMessage(ToMessage(SampleHeader(), ForegroundMap{}));
  EXPECT_TRUE(back.map.cells.empty());
  EXPECT_TRUE(back.is_foreground.empty());
}

TEST(NdtMapConversion, AMapWithoutFlagsIsNoForeground) {
  EXPECT_THROW(ForegroundFromMessage(ToMessage(SampleHeader(), SampleMap())),
               std::invalid_argument);
  ExpectEqual(NdtMapFromMessage(ToMessage(SampleHeader(), SampleForeground())), SampleMap());
}

TEST(NdtMapConversion, RefusesEachBadField) {
  const Spoilers<ndt_map_t> cases = {
      {"header_t.utime", [](auto& m) { m.header.utime = -1; }},
      {"ndt_map_t.cell_size_m", [](auto& m) { m.cell_size_m = 0; }},
      {"ndt_map_t.cell_size_m", [](auto& m) { m.cell_size_m = kNan; }},
      {"ndt_map_t.frame", [](auto& m) { m.frame = 3; }},
      {"ndt_map_t.frame", [](auto& m) { m.frame = -1; }},
      {"ndt_map_t.T_map_camera", [](auto& m) { m.T_map_camera[0] = kNan; }},
      {"ndt_map_t.T_map_camera", [](auto& m) { m.T_map_camera[0] += 0.5; }},
      {"ndt_map_t.T_map_camera",
       [](auto& m) {
         for (double& v : m.T_map_camera) v = -v;
       }},
      {"ndt_map_t.T_map_camera", [](auto& m) { m.T_map_camera[3] = 1e7; }},
      {"ndt_map_t.view.width", [](auto& m) { m.view.width = 0; }},
      {"ndt_map_t.view.height", [](auto& m) { m.view.height = 1 << 20; }},
      {"ndt_map_t.view.fx", [](auto& m) { m.view.fx = 0; }},
      {"ndt_map_t.view.fy", [](auto& m) { m.view.fy = kNan; }},
      {"ndt_map_t.view.cx", [](auto& m) { m.view.cx = HUGE_VAL; }},
      {"ndt_map_t.view.cy", [](auto& m) { m.view.cy = kNan; }},
      {"ndt_map_t.view.count", [](auto& m) { m.view.count = 5; }},
      {"ndt_map_t.view.count", [](auto& m) { m.view.count = 5, m.view.depth_mm.pop_back(); }},
      {"ndt_map_t.view.depth_mm", [](auto& m) { m.view.depth_mm[2] = -1; }},
      {"ndt_map_t.ground.status", [](auto& m) { m.ground.status = 9; }},
      {"ndt_map_t.ground.method", [](auto& m) { m.ground.method = -1; }},
      {"ndt_map_t.ground.normal", [](auto& m) { m.ground.normal[1] = kNan; }},
      {"ndt_map_t.ground.normal", [](auto& m) { m.ground.normal[1] = 2; }},
      {"ndt_map_t.ground.offset", [](auto& m) { m.ground.offset = HUGE_VAL; }},
      {"ndt_map_t.ground.point_count", [](auto& m) { m.ground.point_count = -1; }},
      {"ndt_map_t.ground.inlier_count", [](auto& m) { m.ground.inlier_count = 4001; }},
      {"ndt_map_t.cells.count", [](auto& m) { m.cells.count = 6; }},
      {"ndt_map_t.cells.count", [](auto& m) { m.cells.count = -7; }},
      {"ndt_map_t.cells.count", [](auto& m) { m.cells.mean_y.pop_back(); }},
      {"ndt_map_t.cells.count", [](auto& m) { m.cells.point_count.push_back(1); }},
      {"ndt_map_t.cells[2].mean", [](auto& m) { m.cells.mean_x[2] = kNan; }},
      {"ndt_map_t.cells[3].mean", [](auto& m) { m.cells.mean_z[3] = 2e6f; }},
      {"ndt_map_t.cells[3].mean", [](auto& m) { m.cells.mean_z[3] = 2500; }},
      {"ndt_map_t.cells[0].covariance", [](auto& m) { m.cells.covariance_xx[0] = 0; }},
      {"ndt_map_t.cells[6].covariance", [](auto& m) { m.cells.covariance_yy[6] = kNan; }},
      {"ndt_map_t.cells[6].covariance", [](auto& m) { m.cells.covariance_xy[6] = 1; }},
      {"ndt_map_t.cells[6].covariance", [](auto& m) { m.cells.covariance_zz[6] = -1e-4f; }},
      {"ndt_map_t.cells[1].point_count", [](auto& m) { m.cells.point_count[1] = 0; }},
      {"ndt_map_t.cells[1].point_count", [](auto& m) { m.cells.point_count[1] = -5; }},
      {"ndt_map_t.cells[4].occupancy", [](auto& m) { m.cells.occupancy[4] = kNan; }},
      {"ndt_map_t.background_status", [](auto& m) { m.background_status = 3; }},
      {"ndt_map_t.flag_count", [](auto& m) { m.flag_count = 3; }},
      {"ndt_map_t.flag_count", [](auto& m) { m.flag_count = 6, m.is_foreground.pop_back(); }},
      {"ndt_map_t.is_foreground", [](auto& m) { m.is_foreground[2] = 255; }},
  };
  const ndt_map_t good = ToMessage(SampleHeader(), SampleForeground());
  ExpectEachRefused(good, cases, [](const ndt_map_t& m) { ForegroundFromMessage(m); });
  ExpectEachRefused(good, cases, [](const ndt_map_t& m) { NdtMapFromMessage(m); });
}

TEST(NdtMapConversion, ThePositivityCheckAgreesWithEigenvalues) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int accepted = 0;
  for (int round = 0; round < 5000; ++round) {
    ForegroundMap foreground;
    NdtCell cell = samples::SampleCells(1)[0];
    cell.mean.setZero();
    for (float& value : cell.covariance) value = uniform(random);
    for (const int diagonal : {0, 3, 5})
      cell.covariance[diagonal] = std::abs(cell.covariance[diagonal]);
    const Eigen::Vector3d eigenvalues =
        cell.CovarianceMatrix().cast<double>().selfadjointView<Eigen::Upper>().eigenvalues();
    if (std::abs(eigenvalues.minCoeff()) < 1e-9) continue;
    foreground.map.cells = {cell};
    foreground.is_foreground = {1};
    bool is_accepted = true;
    try {
      ToMessage(SampleHeader(), foreground);
    } catch (const std::invalid_argument&) {
      is_accepted = false;
    }
    EXPECT_EQ(is_accepted, eigenvalues.minCoeff() > 0);
    accepted += is_accepted ? 1 : 0;
  }
  EXPECT_GT(accepted, 100);
}

TEST(EnvironmentMapConversion, RoundTripIsExact) {
  const EnvironmentMap map{0.1, samples::SampleCells(20)};
  const environment_map_t message = ToMessage(map, "the kitchen");
  EXPECT_EQ(message.description, "the kitchen");
  EXPECT_EQ(FromMessage(message).cell_size_m, map.cell_size_m);
  EXPECT_EQ(FromMessage(message).cells, map.cells);
}

TEST(EnvironmentMapConversion, RefusesEachBadField) {
  const Spoilers<environment_map_t> cases = {
      {"environment_map_t.cell_size_m", [](auto& m) { m.cell_size_m = -1; }},
      {"environment_map_t.description", [](auto& m) { m.description = "\x02"; }},
      {"environment_map_t.cells.count", [](auto& m) { m.cells.count = 3; }},
      {"environment_map_t.cells[1].mean", [](auto& m) { m.cells.mean_x[1] = kNan; }},
  };
  ExpectEachRefused(ToMessage(EnvironmentMap{0.1, samples::SampleCells(2)}, ""), cases,
                    [](const environment_map_t& m) { FromMessage(m); });
}

TEST(ClustersConversion, RoundTripIsExact) {
  const SegmentedMap value = SampleSegmented();
  const SegmentedMap back = FromMessage(ToMessage(SampleHeader(), value));
  EXPECT_EQ(back.cell_size_m, value.cell_size_m);
  EXPECT_EQ(back.frame, value.frame);
  EXPECT_EQ(back.T_map_camera.matrix(), value.T_map_camera.matrix());
  EXPECT_EQ(back.view, value.view);
  EXPECT_EQ(back.ground, value.ground);
  EXPECT_EQ(back.background, value.background);
  EXPECT_EQ(back.iron, value.iron);
  EXPECT_EQ(back.cells, value.cells);
  EXPECT_EQ(back.members, value.members);
  ASSERT_EQ(back.clusters.size(), value.clusters.size());
  for (std::size_t c = 0; c < back.clusters.size(); ++c) {
    EXPECT_EQ(back.clusters[c].cells, value.clusters[c].cells);
    EXPECT_EQ(back.clusters[c].descriptors, value.clusters[c].descriptors);
  }
}

TEST(ClustersConversion, NoClustersAndNoCellsAreNoMistake) {
  SegmentedMap value = SampleSegmented();
  value.clusters.clear();
  value.members.clear();
  for (auto& cell : value.cells) cell.cluster = -1;
  EXPECT_EQ(FromMessage(ToMessage(SampleHeader(), value)).cells, value.cells);
  EXPECT_TRUE(FromMessage(ToMessage(SampleHeader(), SegmentedMap{})).cells.empty());
}

TEST(ClustersConversion, OnlyCellsInClustersSendMoreThanTheirMean) {
  const clusters_t message = ToMessage(SampleHeader(), SampleSegmented());
  EXPECT_EQ(message.cell_count, 7);
  EXPECT_EQ(message.members.count, 5);
  EXPECT_EQ(message.other_count, 2);
  EXPECT_EQ(message.descriptor_count, 5);
}

void DropOther(clusters_t& message) {
  for (auto* means : {&message.other_mean_x, &message.other_mean_y, &message.other_mean_z})
    means->pop_back();
  --message.other_count;
}

TEST(ClustersConversion, RefusesEachBadField) {
  const Spoilers<clusters_t> cases = {
      {"header_t.seq", [](auto& m) { m.header.seq = -1; }},
      {"clusters_t.cell_size_m", [](auto& m) { m.cell_size_m = 1e9; }},
      {"clusters_t.frame", [](auto& m) { m.frame = 3; }},
      {"clusters_t.T_map_camera", [](auto& m) { m.T_map_camera[5] = 0; }},
      {"clusters_t.view.count", [](auto& m) { m.view.count = -6; }},
      {"clusters_t.ground.status", [](auto& m) { m.ground.status = -1; }},
      {"clusters_t.background_status", [](auto& m) { m.background_status = -1; }},
      {"clusters_t.iron.radius_m", [](auto& m) { m.iron.radius_m = 0; }},
      {"clusters_t.iron.distance_bins", [](auto& m) { m.iron.distance_bins = 0; }},
      {"clusters_t.iron.angle_bins", [](auto& m) { m.iron.angle_bins = 1 << 30; }},
      {"clusters_t.iron.max_ball_ratio", [](auto& m) { m.iron.max_ball_ratio = 1.5; }},
      {"clusters_t.iron.min_needle_ratio", [](auto& m) { m.iron.min_needle_ratio = kNan; }},
      {"clusters_t.iron.min_neighbors", [](auto& m) { m.iron.min_neighbors = -1; }},
      {"clusters_t.dimension", [](auto& m) { m.dimension = 11; }},
      {"clusters_t.members[0].mean", [](auto& m) { m.members.mean_x[0] = kNan; }},
      {"clusters_t.members[0].mean", [](auto& m) { m.members.mean_x[0] = 5000; }},
      {"clusters_t.members[2].covariance", [](auto& m) { m.members.covariance_yy[2] = -1; }},
      {"clusters_t.members.count", [](auto& m) { m.members.count = 4; }},
      {"clusters_t.members.count", [](auto& m) { m.cluster[1] = -1; }},
      {"clusters_t.other[1].mean", [](auto& m) { m.other_mean_z[1] = kNan; }},
      {"clusters_t.other[0].mean", [](auto& m) { m.other_mean_y[0] = 5000; }},
      {"clusters_t.other_count", [](auto& m) { m.other_count = 3; }},
      {"clusters_t.other_count", [](auto& m) { m.other_mean_z.pop_back(); }},
      {"clusters_t.other_count", [](auto& m) { DropOther(m); }},
      {"clusters_t.cell_count", [](auto& m) { m.cell_count = 8; }},
      {"clusters_t.cell_count", [](auto& m) { m.score.pop_back(); }},
      {"clusters_t.score", [](auto& m) { m.score[3] = 1.5f; }},
      {"clusters_t.score", [](auto& m) { m.score[3] = kNan; }},
      {"clusters_t.cluster[0]", [](auto& m) { m.cluster[0] = -2; }},
      {"clusters_t.cluster[0]", [](auto& m) { m.cluster[0] = 7; }},
      {"clusters_t.cluster", [](auto& m) { m.cluster[0] = 4; }},
      {"clusters_t.descriptor_count", [](auto& m) { m.descriptor_count = 4; }},
      {"clusters_t.members.count", [](auto& m) { m.cluster[0] = 1; }},
      {"clusters_t.dimension", [](auto& m) { m.descriptor[2].pop_back(); }},
      {"clusters_t.descriptor", [](auto& m) { m.descriptor[2][3] = kNan; }},
  };
  ExpectEachRefused(ToMessage(SampleHeader(), SampleSegmented()), cases,
                    [](const clusters_t& m) { FromMessage(m); });
}

TEST(ClustersConversion, WritingRefusesClustersThatDoNotAgreeWithTheirCells) {
  SegmentedMap value = SampleSegmented();
  value.clusters[0].cells.pop_back();
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  value.clusters[0].cells.push_back(6);
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  value.cells[0].cluster = 2;
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  value.clusters[1].descriptors.conservativeResize(Eigen::NoChange, 11);
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  value.members.pop_back();
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  value.members.push_back(value.members[0]);
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
  value = SampleSegmented();
  std::swap(value.members[0], value.members[1]);
  EXPECT_THROW(ToMessage(SampleHeader(), value), std::invalid_argument);
}

TEST(FallenPersonsConversion, RoundTripIsExact) {
  EXPECT_EQ(FromMessage(ToMessage(SampleHeader(), samples::SampleDecision())),
            samples::SampleDecision());
  EXPECT_EQ(FromMessage(ToMessage(SampleHeader(), Decision{})), Decision{});
}

TEST(FallenPersonsConversion, RefusesEachBadField) {
  const std::string prefix = "fallen_persons_t.hypotheses";
  const Spoilers<fallen_persons_t> cases = {
      {"header_t.utime", [](auto& m) { m.header.utime = -1; }},
      {"fallen_persons_t.frame", [](auto& m) { m.frame = 5; }},
      {"fallen_persons_t.T_map_camera", [](auto& m) { m.T_map_camera[0] += 0.5; }},
      {"fallen_persons_t.view.count", [](auto& m) { m.view.depth_mm.clear(); }},
      {"fallen_persons_t.min_probability", [](auto& m) { m.min_probability = 1.5; }},
      {"fallen_persons_t.min_probability", [](auto& m) { m.min_probability = kNan; }},
      {"fallen_persons_t.count", [](auto& m) { m.count = 3; }},
      {"fallen_persons_t.count", [](auto& m) { m.count = -2; }},
      {"fallen_persons_t.hypotheses.centroid", [](auto& m) { m.hypotheses[1].centroid[2] = kNan; }},
      {"fallen_persons_t.hypotheses.box.size", [](auto& m) { m.hypotheses[1].box.size[2] = -1; }},
      {"fallen_persons_t.hypotheses.probability",
       [](auto& m) { m.hypotheses[1].probability = -0.1; }},
      {"fallen_persons_t.hypotheses.mahalanobis_distance",
       [](auto& m) { m.hypotheses[0].mahalanobis_distance = -1; }},
      {"fallen_persons_t.hypotheses.cell_count", [](auto& m) { m.hypotheses[0].cell_count = 0; }},
      {"fallen_persons_t.hypotheses.mean_score", [](auto& m) { m.hypotheses[0].mean_score = 2; }},
      {"fallen_persons_t.hypotheses.is_person", [](auto& m) { m.hypotheses[0].is_person = 2; }},
      {"fallen_persons_t.hypotheses.is_person", [](auto& m) { m.hypotheses[0].is_person = 0; }},
      {"fallen_persons_t.hypotheses.is_person", [](auto& m) { m.hypotheses[1].is_person = 1; }},
  };
  ExpectEachRefused(ToMessage(SampleHeader(), samples::SampleDecision()), cases,
                    [](const fallen_persons_t& m) { FromMessage(m); });
}

}  // namespace
}  // namespace fallen
