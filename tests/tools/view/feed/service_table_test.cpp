// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/service_table.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "fallen/messages/log_file.hpp"

namespace fallen {
namespace {

using std::chrono::seconds;

const ServiceTable::Clock::time_point kStart{};

std::vector<std::uint8_t> StatusOf(const std::string& service, std::int64_t pid,
                                   std::int8_t state = service_status_t::RUNNING) {
  service_status_t status{};
  status.service = service;
  status.pid = pid;
  status.state = state;
  status.rate_hz = 9.5;
  status.dropped_late = 3;
  return EncodeMessage(status);
}

TEST(ServiceTable, TellsTheNewestOfEachServiceAndHowLongAgo) {
  ServiceTable table;
  table.Take(StatusOf("ndt-mapping", 1), kStart);
  table.Take(StatusOf("cell-segmentation", 2, service_status_t::DEGRADED), kStart + seconds(4));
  const nlohmann::json json = table.ToJson(kStart + seconds(5));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["service"], "cell-segmentation");
  EXPECT_EQ(json[0]["state"], "degraded");
  EXPECT_EQ(json[1]["silent_s"], 5);
  EXPECT_EQ(json[1]["rate_hz"], 9.5);
  EXPECT_EQ(json[1]["dropped_late"], 3);
}

TEST(ServiceTable, AProcessTakesThePlaceOfTheOneBeforeButWorkersStandBesideEachOther) {
  ServiceTable table;
  table.Take(StatusOf("ndt-mapping", 1), kStart);
  table.Take(StatusOf("ndt-mapping", 2), kStart + seconds(1));
  EXPECT_EQ(table.ToJson(kStart + seconds(1)).size(), 2u) << "both are alive";
  table.Take(StatusOf("ndt-mapping", 2), kStart + seconds(10));
  EXPECT_EQ(table.ToJson(kStart + seconds(10)).size(), 1u) << "the first has gone";
}

TEST(ServiceTable, RefusesWhatIsNoStatus) {
  ServiceTable table;
  EXPECT_THROW(table.Take(std::vector<std::uint8_t>(100, 1), kStart), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
