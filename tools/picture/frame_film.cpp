// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/picture/frame_film.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "tools/common/progress_bar.hpp"
#include "tools/picture/canvas.hpp"
#include "tools/picture/film_writer.hpp"
#include "tools/picture/frame_picture.hpp"

namespace fallen {
namespace {

/// Next frame that can be decided about, with what was found in it.
std::optional<ViewedFrame> NextFrame(FrameSource& recording, Detector& detector,
                                     const std::string& name, std::int64_t& index) {
  for (; std::optional<Frame> frame = recording.Next(); ++index) {
    FrameResult result;
    try {
      result = detector.Detect(*frame);
    } catch (const std::invalid_argument&) {
      continue;  // nothing to be seen in an image that is none
    }
    const std::optional<GroundTruth> truth = recording.Truth(*frame);
    ViewedFrame viewed{name, index++, std::move(*frame), std::move(result), {}};
    if (truth) viewed.truth = truth->person_box;
    return viewed;
  }
  return std::nullopt;
}

double RateOf(const ViewedFrame& first, const std::optional<ViewedFrame>& second) {
  constexpr double kUsual = 10;
  if (!second || second->frame.utime <= first.frame.utime) return kUsual;
  return std::clamp(1e6 / static_cast<double>(second->frame.utime - first.frame.utime), 1.0, 60.0);
}

}  // namespace

std::int64_t SaveFilm(const std::filesystem::path& film, FrameSource& recording, Detector& detector,
                      const std::string& name) {
  std::int64_t index = 0;
  std::optional<ViewedFrame> viewed = NextFrame(recording, detector, name, index);
  if (!viewed) throw std::runtime_error(name + ": got 0 frames, expected at least one");
  std::optional<ViewedFrame> next = NextFrame(recording, detector, name, index);
  FilmWriter writer(film, kPictureWidth, kPictureHeight, RateOf(*viewed, next));
  ProgressBar progress("film");
  std::int64_t frames = 0;
  for (; viewed; ++frames) {
    progress.Update(recording.share_done(), "frame " + std::to_string(viewed->index));
    Canvas canvas(kPictureWidth, kPictureHeight, palette::kPaper);
    DrawFramePicture(canvas, *viewed);
    writer.Add(canvas.Pixels());
    viewed = std::move(next);
    next = viewed ? NextFrame(recording, detector, name, index) : std::nullopt;
  }
  writer.Close();
  return frames;
}

}  // namespace fallen
