// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/zone_file.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "fallen/service/configuration.hpp"
#include "fallen/service/load_files.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ZoneFile : public testing::Test {
 protected:
  ZoneFile() : folder_(testing::TempDir() + "/fallen_zones_" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~ZoneFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::string Complaint(const std::string& text) {
    const std::filesystem::path file = Write("zones.yaml", text);
    try {
      LoadZones(file);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_THAT(what, StartsWith(file.string()));
      EXPECT_EQ(what.find('\n'), std::string::npos);
      return what.substr(file.string().size());
    }
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(ZoneFile, TheExampleLoads) {
  const auto zones = LoadZones(FALLEN_SOURCE_DIR "/config/zones/example.yaml");
  ASSERT_EQ(zones.size(), 2U);
  EXPECT_EQ(zones[0].name, "dog basket");
  EXPECT_EQ(zones[0].kind, ZoneKind::kNever);
  EXPECT_EQ(zones[0].corners.size(), 4U);
  EXPECT_EQ(zones[0].corners[0], Eigen::Vector2d(1.2, -0.4));
  EXPECT_EQ(zones[1].kind, ZoneKind::kBed);
  EXPECT_EQ(zones[1].bed_height_m, 0.35);
}

TEST_F(ZoneFile, WrongZonesAreOneLineWithTheirPlace) {
  const std::string good = "kind: never, corners: [[0, 0], [1, 0], [1, 1]]}\n";
  EXPECT_EQ(Complaint("zones:\n  - {name: a, kind: never, corners: [[0,0],[2,2],[2,0],[0,2]]}\n"),
            ":2: zone 'a': the edges after corners 1 and 3 cross, expected a simple polygon");
  EXPECT_EQ(Complaint("zones:\n  - {name: a, " + good + "  - {name: a, " + good),
            ":3: zones[1].name: got 'a' twice, expected it once");
  EXPECT_THAT(Complaint("zones:\n  - {name: a, knd: never}\n"),
              HasSubstr("zones[0].knd: unknown key"));
  EXPECT_THAT(Complaint("zones:\n  - {name: a, kind: sofa}\n"),
              HasSubstr("zones[0].kind: got 'sofa', expected one of never bed"));
  EXPECT_EQ(Complaint("zones:\n  - {name: a, kind: bed}\n"),
            ":2: zones[0]: got no corners, expected one");
  EXPECT_THAT(Complaint("zones:\n  - {name: a, kind: bed, corners: [[0, 0], [1]]}\n"),
              HasSubstr("a list of 2 values"));
  EXPECT_THAT(Complaint("zoness: []\n"), HasSubstr("zoness: unknown key, expected zones"));
  EXPECT_THAT(Complaint("zones: 5\n"), HasSubstr("zones: got '5', expected a list of zones"));
  EXPECT_THAT(Complaint("zones: [\n"), HasSubstr("no valid YAML"));
}

TEST_F(ZoneFile, IsNamedByTheConfiguration) {
  Write("kitchen.yaml", "zones:\n  - {name: a, kind: bed, corners: [[0, 0], [1, 0], [1, 1]]}\n");
  const auto file = Write("robot.yaml",
                          "files: {zones: kitchen.yaml}\nservice: {robot: r2}\n"
                          "ndt: {without_pose: fixed_camera}\n");
  const AlarmScope scope = LoadAlarmScopeFor(LoadConfiguration(file));
  EXPECT_EQ(scope.zones.size(), 1U);
  EXPECT_EQ(scope.robot, "r2");
  EXPECT_TRUE(scope.has_fixed_cameras);
  EXPECT_TRUE(LoadAlarmScopeFor(Configuration{}).zones.empty());
}

}  // namespace
}  // namespace fallen
