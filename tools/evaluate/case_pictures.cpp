// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/evaluate/case_pictures.hpp"

#include <stdexcept>

#ifdef FALLEN_HAVE_PICTURES
#include <algorithm>
#include <map>
#include <mutex>

#include "fallen/segmentation/parallel_for.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/frames/frame_source.hpp"
#include "tools/picture/frame_picture.hpp"
#endif

namespace fallen {

#ifdef FALLEN_HAVE_PICTURES
namespace {

/// The pictures of one recording, by their frames: several cases may share one.
using Wanted = std::multimap<std::int64_t, std::filesystem::path>;

void DrawRecording(const std::string& log, const Wanted& wanted, const DetectorOptions& options) {
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(log);
  Detector detector = MakeDetector(options);
  const std::int64_t last = std::prev(wanted.end())->first;
  for (std::int64_t number = 0; number <= last; ++number) {
    std::optional<Frame> frame = recording->Next();
    if (!frame) break;
    ViewedFrame viewed{
        std::filesystem::path(log).filename().string(), number, {}, detector.Detect(*frame), {}};
    if (!wanted.contains(number)) continue;
    viewed.frame = std::move(*frame);
    if (const auto truth = recording->Truth(viewed.frame)) viewed.truth = truth->person_box;
    const auto [first, end] = wanted.equal_range(number);
    for (auto picture = first; picture != end; ++picture) SaveFramePicture(picture->second, viewed);
  }
}

}  // namespace

void DrawCases(const std::vector<CasePicture>& pictures, const DetectorOptions& detector,
               int jobs) {
  std::map<std::string, Wanted> by_log;
  for (const CasePicture& picture : pictures)
    by_log[picture.log].emplace(picture.frame, picture.file);
  const std::vector<std::pair<std::string, Wanted>> recordings(by_log.begin(), by_log.end());
  ProgressBar bar("pictures");
  std::mutex mutex;
  std::size_t done = 0;
  ParallelFor(static_cast<int>(recordings.size()), jobs, [&](int i) {
    DrawRecording(recordings[i].first, recordings[i].second, detector);
    const std::lock_guard lock(mutex);
    bar.Update(static_cast<double>(++done) / static_cast<double>(recordings.size()));
  });
}
#else
void DrawCases(const std::vector<CasePicture>& pictures, const DetectorOptions&, int) {
  if (!pictures.empty())
    throw std::runtime_error("pictures: this build is without Cairo, expected it (libcairo2-dev)");
}
#endif

}  // namespace fallen
