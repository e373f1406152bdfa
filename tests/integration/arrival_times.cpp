// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/arrival_times.hpp"

#include "fallen/header_t.hpp"

namespace fallen::testing_support {
namespace {

constexpr int kHashBytes = 8;

}  // namespace

ArrivalTimes::ArrivalTimes(lcm::LCM& lcm, const std::string& channels) {
  lcm.subscribe(channels, &ArrivalTimes::Receive, this)->setQueueCapacity(0);
}

void ArrivalTimes::Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel) {
  header_t header{};
  if (header._decodeNoHash(buffer->data, kHashBytes,
                           static_cast<int>(buffer->data_size) - kHashBytes) < 0)
    return;
  Frame& frame = frames_[header.seq];
  frame.utime = header.utime;
  frame.arrivals.emplace(channel, buffer->recv_utime);
}

}  // namespace fallen::testing_support
