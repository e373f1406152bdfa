// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <string>

namespace fallen::testing_support {

/// When each frame's messages arrived: the kernel's time of their last packet, so that a listener
/// who is late himself measures no less well.
class ArrivalTimes {
 public:
  struct Frame {
    std::int64_t utime = 0;                        ///< as the messages say [us]
    std::map<std::string, std::int64_t> arrivals;  ///< by channel [us since the epoch]
  };

  /// Listens on `lcm`, which must outlive this and is handled by the caller.
  /// @param channels  Regular expression of those that carry messages with a header.
  ArrivalTimes(lcm::LCM& lcm, const std::string& channels);

  /// By seq.
  const std::map<std::int64_t, Frame>& frames() const { return frames_; }
  void Clear() { frames_.clear(); }

 private:
  void Receive(const lcm::ReceiveBuffer* buffer, const std::string& channel);

  std::map<std::int64_t, Frame> frames_;
};

}  // namespace fallen::testing_support
