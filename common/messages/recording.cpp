// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/recording.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "fallen/messages/guarded_decoding.hpp"
#include "fallen/messages/log_format.hpp"
#include "fallen/service/channels.hpp"

namespace fallen {
namespace {

bool IsDepthImage(const LogEvent& event) {
  return event.data.size() >= sizeof(std::uint64_t) &&
         log_format::ReadBigEndian<std::uint64_t>(event.data.data()) ==
             static_cast<std::uint64_t>(depth_image_t::getHash());
}

std::string List(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string ChooseCamera(const std::filesystem::path& log, const std::string& wanted) {
  const std::vector<std::string> cameras = CamerasIn(log);
  if (cameras.empty())
    throw std::runtime_error(log.string() + ": channels: got no depth images, expected " +
                             channels::Depth(wanted.empty() ? "<CAMERA>" : wanted));
  if (wanted.empty() && cameras.size() == 1) return cameras.front();
  if (wanted.empty())
    throw std::runtime_error(log.string() + ": camera: got none, expected one of " + List(cameras));
  if (std::find(cameras.begin(), cameras.end(), wanted) == cameras.end())
    throw std::runtime_error(log.string() + ": camera: got " + wanted + ", expected one of " +
                             List(cameras));
  return wanted;
}

// Decodes or throws std::invalid_argument.
template <class Message>
Message Decode(const LogEvent& event) {
  Decoded<Message> decoded = DecodeMessage<Message>(event.data);
  if (!decoded) throw std::invalid_argument(decoded.error);
  return std::move(*decoded.message);
}

}  // namespace

std::vector<std::string> CamerasIn(const std::filesystem::path& log) {
  const std::string prefix = channels::Depth("");
  std::set<std::string> cameras;
  LogReader reader(log);
  while (const auto event = reader.Next())
    if (event->channel.rfind(prefix, 0) == 0 && event->channel.size() > prefix.size() &&
        IsDepthImage(*event))
      cameras.insert(event->channel.substr(prefix.size()));
  return {cameras.begin(), cameras.end()};
}

Recording::Recording(const std::filesystem::path& log, const std::string& camera)
    : camera_(ChooseCamera(log, camera)),
      depth_channel_(channels::Depth(camera_)),
      truth_channel_(channels::GroundTruth(camera_)),
      reader_(log) {}

std::optional<RecordedInput> Recording::Next() {
  while (true) {
    const auto event = reader_.Next();
    CountDamage();
    if (!event) return std::nullopt;
    try {
      if (auto input = Convert(*event)) return input;
    } catch (const std::exception& error) {
      ++counts_.refused;
      counts_.newest_problem = event->channel + ": " + error.what();
    }
  }
}

double Recording::progress() const {
  if (reader_.size_bytes() == 0) return 1;
  return static_cast<double>(reader_.position_bytes()) / static_cast<double>(reader_.size_bytes());
}

// Nothing for a channel that is not asked for.
std::optional<RecordedInput> Recording::Convert(const LogEvent& event) {
  if (event.channel == depth_channel_) {
    StampedDepthImage image = FromMessage(Decode<depth_image_t>(event));
    ++counts_.images;
    return image;
  }
  if (event.channel == channels::kRobotPose) {
    const StampedPose pose = FromMessage(Decode<pose_t>(event));
    ++counts_.poses;
    return pose;
  }
  if (event.channel == truth_channel_) {
    const ground_truth_t message = Decode<ground_truth_t>(event);
    RecordedTruth truth{FromMessage(message.header), FromMessage(message)};
    ++counts_.truths;
    return truth;
  }
  return std::nullopt;
}

void Recording::CountDamage() {
  const std::vector<LogDamage>& damage = reader_.damage();
  for (; damage_seen_ < damage.size(); ++damage_seen_) {
    ++counts_.damaged_places;
    counts_.damaged_bytes += damage[damage_seen_].skipped_bytes;
    counts_.newest_problem = "offset " + std::to_string(damage[damage_seen_].offset) + ": " +
                             damage[damage_seen_].reason;
  }
}

}  // namespace fallen
