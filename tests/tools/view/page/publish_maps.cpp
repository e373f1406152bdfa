// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// usage: publish_maps LCM_URL CELLS SECONDS
// What the services would say about a big map at 10 Hz: as many ellipsoids as told, a person among
// them.
#include <chrono>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <random>
#include <thread>

#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "tests/support/seen_place.hpp"

namespace {

using namespace fallen;

/// Cells all over a room of 6 x 6 m, up to 2 m high, flat and long ones in any direction.
std::vector<NdtCell> DrawCells(int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<NdtCell> cells(static_cast<std::size_t>(count));
  for (NdtCell& cell : cells) {
    cell.mean = {6 * unit(random), 6 * unit(random) - 3, 2 * unit(random)};
    Eigen::Matrix3f axes;
    for (float& value : axes.reshaped()) value = 0.03f * (unit(random) - 0.5f);
    const Eigen::Matrix3f covariance =
        axes * axes.transpose() + 1e-6f * Eigen::Matrix3f::Identity();
    cell.covariance = {covariance(0, 0), covariance(0, 1), covariance(0, 2),
                       covariance(1, 1), covariance(1, 2), covariance(2, 2)};
    cell.point_count = 20;
    cell.occupancy = 1;
  }
  return cells;
}

void Publish(lcm::LCM& lcm, const std::string& channel, const auto& message) {
  const std::vector<std::uint8_t> bytes = EncodeMessage(message);
  lcm.publish(channel, bytes.data(), static_cast<unsigned>(bytes.size()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  lcm::LCM lcm(argv[1]);
  NdtMap map;
  map.frame = MapFrame::kWorld;
  map.cells = DrawCells(std::atoi(argv[2]));
  const int frames = 10 * std::atoi(argv[3]);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < frames; ++i) {
    map.T_map_camera = seen_place::LookAt({-0.5 + 0.001 * i, 0, 1.1}, {3, 0, 0});
    Decision decision = seen_place::Empty(map.T_map_camera);
    map.view = decision.view;
    seen_place::AddCluster(decision, {3, 0, 0.15}, 0.99);
    const Header header{1'700'000'000'000'000 + 100'000 * i, i, "CAMERA"};
    Publish(lcm, "NDT_MAP_CAMERA", ToMessage(header, map));
    Publish(lcm, "FALLEN_PERSONS_CAMERA", ToMessage(header, decision));
    std::this_thread::sleep_until(start + std::chrono::milliseconds(100) * (i + 1));
  }
}
