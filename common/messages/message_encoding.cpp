// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All encoding is compiled here, without vector instructions for loops (CMakeLists.txt): GCC 12
// makes shuffles of LCM's loops that turn the bytes of numbers round, which take 7 times as long as
// the plain instruction for it.
#include <stdexcept>
#include <string>

#include "fallen/baseline_model_t.hpp"
#include "fallen/clusters_t.hpp"
#include "fallen/depth_image_t.hpp"
#include "fallen/environment_map_t.hpp"
#include "fallen/fall_alarm_ack_t.hpp"
#include "fallen/fall_alarm_t.hpp"
#include "fallen/fallen_persons_t.hpp"
#include "fallen/ground_truth_t.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/model_t.hpp"
#include "fallen/ndt_map_t.hpp"
#include "fallen/pose_t.hpp"
#include "fallen/service_status_t.hpp"

namespace fallen {

template <class Message>
std::vector<std::uint8_t> EncodeMessage(const Message& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  const int size = message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  if (size != static_cast<int>(bytes.size()))
    throw std::invalid_argument(std::string(Message::getTypeName()) + ": cannot be encoded");
  return bytes;
}

template std::vector<std::uint8_t> EncodeMessage(const pose_t&);
template std::vector<std::uint8_t> EncodeMessage(const depth_image_t&);
template std::vector<std::uint8_t> EncodeMessage(const ndt_map_t&);
template std::vector<std::uint8_t> EncodeMessage(const clusters_t&);
template std::vector<std::uint8_t> EncodeMessage(const fallen_persons_t&);
template std::vector<std::uint8_t> EncodeMessage(const ground_truth_t&);
template std::vector<std::uint8_t> EncodeMessage(const service_status_t&);
template std::vector<std::uint8_t> EncodeMessage(const model_t&);
template std::vector<std::uint8_t> EncodeMessage(const baseline_model_t&);
template std::vector<std::uint8_t> EncodeMessage(const environment_map_t&);
template std::vector<std::uint8_t> EncodeMessage(const fall_alarm_t&);
template std::vector<std::uint8_t> EncodeMessage(const fall_alarm_ack_t&);

}  // namespace fallen
