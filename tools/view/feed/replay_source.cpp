// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/replay_source.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

namespace fallen {

ReplaySource::ReplaySource(Feed& feed, std::unique_ptr<FrameSource> recording, Detector detector,
                           const std::string& name)
    : feed_(feed),
      recording_(std::move(recording)),
      detector_(std::move(detector)),
      report_(feed, name, recording_->camera()) {}

void ReplaySource::Run(const std::atomic<bool>& is_stopping) {
  Damage damage;
  try {
    while (!is_stopping) {
      const std::optional<Frame> frame = recording_->Next();
      if (!frame) break;
      Detect(*frame);
      report_.Progress(recording_->share_done(), recording_->damage());
    }
    damage = recording_->damage();
  } catch (const std::exception& error) {
    damage.Add(error.what());
  }
  report_.End(damage);
}

void ReplaySource::Detect(const Frame& frame) {
  FrameResult result;
  try {
    result = detector_.Detect(frame);
  } catch (const std::invalid_argument&) {
    return;  // nothing to be seen in an image that is none
  }
  Scene scene;
  scene.header = {frame.utime, frame.seq, frame.sensor_name};
  scene.image = frame.image;
  scene.map = std::move(result.foreground);
  scene.segmented = std::move(result.segmented);
  scene.decision = std::move(result.decision);
  scene.milliseconds = result.milliseconds;
  if (const std::optional<GroundTruth> truth = recording_->Truth(frame))
    scene.truth = truth->person_box;
  feed_.Append(scene);
}

}  // namespace fallen
