// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/compose/compose_log.hpp"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "fallen/geometry/ground_plane.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/log_file.hpp"
#include "fallen/service/channels.hpp"
#include "tools/common/partial_file.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/simulate/random.hpp"

namespace fallen {
namespace {

// Twice the gap after which a map starts anew (ndt.max_time_gap_s).
constexpr std::int64_t kStepUs = 10'000'000;
constexpr std::uint8_t kPersonLabel = 1;

std::vector<Frame> LoadFrames(const std::filesystem::path& scene, int wanted) {
  std::vector<Frame> frames;
  const auto source = OpenFrameSource(scene);
  while (std::optional<Frame> frame = source->Next()) frames.push_back(std::move(*frame));
  if (source->damage().count > 0) throw std::runtime_error(source->damage().example);
  const auto count = static_cast<int>(frames.size());
  if (count <= wanted) return frames;
  std::vector<Frame> spread;
  for (int i = 0; i < wanted; ++i) spread.push_back(std::move(frames[i * count / wanted]));
  return spread;
}

GroundTruth TruthOf(const Composition& composition, const OrientedBox& box,
                    const ComposeOptions& options) {
  GroundTruth truth;
  truth.person_box = box;
  truth.person = options.person.stem().string();
  truth.room = options.scene.filename().string();
  truth.objects.push_back({"fallen_person", truth.person, kPersonLabel, box});
  truth.label_width = composition.image.intrinsics.width;
  truth.label_height = composition.image.intrinsics.height;
  for (const std::uint8_t is_person : composition.is_person)
    truth.labels.push_back(is_person ? kPersonLabel : 0);
  return truth;
}

void Write(LogWriter& writer, Composition composition, const OrientedBox& box,
           const Eigen::Isometry3d& T_level_camera, int index, const ComposeOptions& options) {
  const std::string camera = channels::kDefaultCamera;
  const Header header{(index + 1) * kStepUs, index, camera};
  StampedPose pose;
  pose.utime = header.utime;
  writer.Write(header.utime, channels::kRobotPose, EncodeMessage(ToMessage(pose)));
  writer.Write(header.utime, channels::GroundTruth(camera),
               EncodeMessage(ToMessage(header, TruthOf(composition, box, options))));
  const StampedDepthImage depth{header, std::move(composition.image), T_level_camera};
  writer.Write(header.utime, channels::Depth(camera), EncodeMessage(ToMessage(depth)));
}

/// Compositions of one frame: the chosen places at which enough of the person is seen.
int ComposeFrame(const Frame& frame, const Eigen::Isometry3d& T_level_camera,
                 const PersonCloud& person, const ComposeOptions& options, std::uint64_t seed,
                 const std::function<void(Composition, const Place&)>& write) {
  const std::vector<Place> free =
      FindFreePlaces(frame.image, T_level_camera, person.box, options.search);
  int written = 0;
  for (const Place& place : OrderPlaces(free, seed)) {
    if (written == options.places) break;
    CompositionConfig config = options.composition;
    config.noise_seed = sim::MixBits(seed) + static_cast<std::uint64_t>(written);
    Composition composition = Compose(frame.image, T_level_camera, person, place.Pose(), config);
    if (composition.visible_share < options.min_visible_share) continue;
    write(std::move(composition), place);
    ++written;
  }
  return written;
}

}  // namespace

ComposeReport ComposeLog(const ComposeOptions& options) {
  const PersonCloud person = LoadPersonCloud(options.person, options.up, options.floor_cut_m);
  const std::vector<Frame> frames = LoadFrames(options.scene, options.frames);
  PartialFile output(options.log);
  LogWriter writer(output.path());
  ProgressBar progress("compose");
  ComposeReport report;
  for (const Frame& frame : frames) {
    const GroundEstimate ground = EstimateGround(frame.image, frame.T_robot_camera);
    if (!ground.ok()) {
      ++report.without_floor;
    } else {
      const Eigen::Isometry3d T_level_camera = LevelFrameFromGround(ground.plane);
      const int written =
          ComposeFrame(frame, T_level_camera, person, options, options.seed + report.used_frames,
                       [&](Composition composition, const Place& place) {
                         Write(writer, std::move(composition), BoxAt(place, person.box),
                               T_level_camera, report.images++, options);
                       });
      if (written == 0) ++report.without_place;
    }
    progress.Update(static_cast<double>(++report.used_frames) / static_cast<double>(frames.size()));
  }
  if (report.images == 0)
    throw std::runtime_error(
        options.scene.string() + ": got " + std::to_string(report.without_floor) + " of " +
        std::to_string(report.used_frames) +
        " frames without a floor and no free place in the others, expected one");
  writer.Close();
  output.Commit();
  return report;
}

}  // namespace fallen
