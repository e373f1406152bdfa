// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/map/person_mask.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace fallen {
namespace {

/// A labelled box is drawn tightly; hair, blanket and depth noise reach beyond it by so much [m].
constexpr double kBoxMarginM = 0.1;

bool IsPerson(const LabelledObject& object) {
  return object.category == "person" || object.category == "fallen_person";
}

OrientedBox Grown(OrientedBox box) {
  box.size.array() += 2 * kBoxMarginM;
  return box;
}

std::vector<OrientedBox> PersonBoxes(const GroundTruth& truth) {
  std::vector<OrientedBox> boxes;
  if (truth.person_box) boxes.push_back(Grown(*truth.person_box));
  for (const LabelledObject& object : truth.objects)
    if (IsPerson(object)) boxes.push_back(Grown(object.box));
  return boxes;
}

/// Which values of the label image are persons.
std::array<bool, 256> PersonLabels(const GroundTruth& truth) {
  std::array<bool, 256> is_person{};
  for (const LabelledObject& object : truth.objects)
    if (IsPerson(object) && object.label > 0 && object.label < 256) is_person[object.label] = true;
  return is_person;
}

}  // namespace

std::int64_t RemovePersons(DepthImage& image, const GroundTruth& truth,
                           const Eigen::Isometry3d& T_world_camera) {
  const std::vector<OrientedBox> boxes = PersonBoxes(truth);
  const std::array<bool, 256> is_person_label = PersonLabels(truth);
  const bool has_labels = truth.labels.size() == image.depth.size();
  std::int64_t removed = 0;
  std::size_t i = 0;
  for (int v = 0; v < image.intrinsics.height; ++v)
    for (int u = 0; u < image.intrinsics.width; ++u, ++i) {
      if (image.depth[i] == 0) continue;
      const Eigen::Vector3d p_world =
          T_world_camera * image.intrinsics.Deproject(u, v, image.depth[i] * image.depth_unit_m);
      const bool is_labelled = has_labels && is_person_label[truth.labels[i]];
      const auto holds_it = [&](const OrientedBox& box) { return box.Contains(p_world); };
      if (!is_labelled && std::none_of(boxes.begin(), boxes.end(), holds_it)) continue;
      image.depth[i] = 0;
      ++removed;
    }
  return removed;
}

}  // namespace fallen
