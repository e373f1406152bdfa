// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/lcm_url.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "fallen/service/configuration.hpp"

namespace fallen {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kLargeLimit = 8 << 20;

TEST(LcmUrl, DefaultUrlOnATunedMachineIsFine) {
  EXPECT_EQ(ReceiveBufferWarning(ServiceConfig{}.lcm_url, kLargeLimit), "");
}

TEST(LcmUrl, BufferThatIsNotAskedForWarns) {
  EXPECT_THAT(ReceiveBufferWarning("udpm://239.255.76.67:7667?ttl=0", kLargeLimit),
              HasSubstr("recv_buf_size=4194304"));
  EXPECT_THAT(ReceiveBufferWarning("udpm://239.255.76.67:7667?recv_buf_size=65536", kLargeLimit),
              HasSubstr("65536"));
}

TEST(LcmUrl, SystemThatGrantsLessWarnsAndSaysWhatMendsIt) {
  EXPECT_THAT(ReceiveBufferWarning(ServiceConfig{}.lcm_url, 212992), HasSubstr("sysctl -w"));
}

TEST(LcmUrl, OtherTransportsHaveNoBuffer) {
  EXPECT_EQ(ReceiveBufferWarning("memq://", 1), "");
  EXPECT_EQ(ReceiveBufferOf("tcpq://host:7700"), std::nullopt);
}

TEST(LcmUrl, UnknownKindIsRefused) {
  EXPECT_THROW(RequireKnownLcmUrl("udp://239.255.76.67:7667"), std::invalid_argument);
  EXPECT_THROW(RequireKnownLcmUrl(""), std::invalid_argument);
  EXPECT_NO_THROW(RequireKnownLcmUrl("memq://"));
}

}  // namespace
}  // namespace fallen
