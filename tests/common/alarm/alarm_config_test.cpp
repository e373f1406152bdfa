// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/alarm_config.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

TEST(AlarmConfig, DefaultsAreInRange) { EXPECT_NO_THROW(AlarmConfig{}.Validate()); }

TEST(AlarmConfig, EachFieldThatIsNoNumberIsNamed) {
  AlarmConfig names;
  names.Visit([&](const char* key, double&) {
    AlarmConfig config;
    config.Visit([&](const char* other, double& value) {
      if (std::string(other) == key) value = std::numeric_limits<double>::quiet_NaN();
    });
    try {
      config.Validate();
      ADD_FAILURE() << key;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(std::string(key) + " is nan, must be "));
    }
  });
}

TEST(AlarmConfig, ClearingNeedsLessThanRaising) {
  AlarmConfig config;
  config.clear_log_odds = config.raise_log_odds;
  EXPECT_THROW(config.Validate(), std::invalid_argument);
}

}  // namespace
}  // namespace fallen
