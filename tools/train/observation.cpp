// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/train/observation.hpp"

#include <stdexcept>

#include "fallen/detection/map_update.hpp"
#include "fallen/evaluation/frame_outcome.hpp"
#include "tools/frames/frame_source.hpp"

namespace fallen {
namespace {

// Maps frames and labels their cells.
class Observer {
 public:
  Observer(const GroundConfig& ground, const NdtConfig& ndt)
      : ground_(ground), mapper_(ndt), labeller_(ndt.cell_size_m) {}

  ObservedFrame Observe(const Frame& frame, const GroundTruth& truth) {
    ObservedFrame observed;
    observed.map = UpdateMap(mapper_, frame, ground_);
    const bool is_in_world = observed.map.frame == MapFrame::kWorld;
    if (!is_in_world) labeller_.Reset();
    if (!truth.labels.empty()) {
      labeller_.Add(frame.image, truth.labels, truth.person_label(), observed.map.T_map_camera);
      observed.labels = labeller_.Label(observed.map);
    } else if (!truth.person_box || is_in_world) {
      observed.labels = LabelByBox(observed.map, truth.person_box);
    }
    if (truth.person_box && is_in_world) {
      observed.person_box = truth.person_box;
      observed.cells_in_box = CountCellsInBox(observed.map, *truth.person_box);
    }
    return observed;
  }

 private:
  GroundConfig ground_;
  NdtMapper mapper_;
  CellLabeller labeller_;
};

// Thousands of recordings are kept in memory: without room to grow.
void Keep(ObservedFrame frame, std::vector<ObservedFrame>& frames) {
  frame.map.cells.shrink_to_fit();
  frames.push_back(std::move(frame));
}

NdtConfig WithoutAccumulation(NdtConfig config) {
  config.accumulate = false;
  return config;
}

}  // namespace

bool ObservedFrame::is_positive() const { return person_box && cells_in_box >= kMinCellsInBox; }

ObservedFrame IsolatePerson(const ObservedFrame& frame) {
  ObservedFrame alone = frame;
  alone.map.cells.clear();
  for (std::size_t i = 0; i < frame.labels.size(); ++i)
    if (frame.labels[i] == CellLabel::kPerson) alone.map.cells.push_back(frame.map.cells[i]);
  alone.labels.assign(alone.map.cells.size(), CellLabel::kPerson);
  return alone;
}

ObservedRecording ObserveRecording(const std::filesystem::path& log, const GroundConfig& ground,
                                   const NdtConfig& ndt, const ObservationConfig& config) {
  ObservedRecording observed;
  observed.origin.log = log.string();
  const std::unique_ptr<FrameSource> recording = OpenFrameSource(log);
  Observer accumulating(ground, ndt);
  Observer single(ground, WithoutAccumulation(ndt));
  std::int64_t number = 0;
  while (const std::optional<Frame> frame = recording->Next()) {
    const std::optional<GroundTruth> truth = recording->Truth(*frame);
    if (!truth) continue;
    if (!truth->person.empty()) observed.origin.person = truth->person;
    if (!truth->room.empty()) observed.origin.room = truth->room;
    ObservedFrame in_map = accumulating.Observe(*frame, *truth);
    if (number % config.frame_stride == 0) Keep(std::move(in_map), observed.frames);
    if (config.single_frame_stride > 0 && number % config.single_frame_stride == 0)
      Keep(single.Observe(*frame, *truth), observed.frames);
    ++number;
  }
  if (number == 0)
    throw std::runtime_error(log.string() +
                             ": no ground truth for any frame, expected GROUND_TRUTH_* messages");
  observed.damaged = recording->damage().count;
  return observed;
}

}  // namespace fallen
