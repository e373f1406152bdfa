// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/evaluation/cell_labels.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fallen {
namespace {

// A cell is the person's if most of its points are, and not the person's if hardly any is.
constexpr double kMinPersonShare = 0.6;
constexpr double kMaxOtherShare = 0.1;
constexpr double kBoxMarginM = 0.1;

}  // namespace

std::int64_t CellLabeller::Key(const Eigen::Vector3d& p) const {
  constexpr std::int64_t kOffset = 1 << 20;  // 21 bits an axis: +-52 km of 5 cm cells
  const auto index = [&](double v) {
    return static_cast<std::int64_t>(std::floor(v / cell_size_m_)) + kOffset;
  };
  return (index(p.x()) << 42) | (index(p.y()) << 21) | index(p.z());
}

void CellLabeller::Add(const DepthImage& image, std::span<const std::uint8_t> labels,
                       std::uint8_t person_label, const Eigen::Isometry3d& T_map_camera) {
  if (labels.size() != image.depth.size())
    throw std::invalid_argument("cell_labels: label image has " + std::to_string(labels.size()) +
                                " pixels, expected " + std::to_string(image.depth.size()));
  const CameraIntrinsics& camera = image.intrinsics;
  std::size_t i = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u, ++i) {
      if (image.depth[i] == 0) continue;
      const double z_m = image.depth[i] * image.depth_unit_m;
      Votes& votes = votes_[Key(T_map_camera * camera.Deproject(u, v, z_m))];
      const bool is_person = person_label != 0 && labels[i] == person_label;
      ++(is_person ? votes.person : votes.other);
    }
}

std::vector<CellLabel> CellLabeller::Label(const NdtMap& map) const {
  std::vector<CellLabel> labels;
  labels.reserve(map.cells.size());
  for (const NdtCell& cell : map.cells) {
    const auto found = votes_.find(Key(cell.mean.cast<double>()));
    if (found == votes_.end()) {
      labels.push_back(CellLabel::kUnknown);
      continue;
    }
    const double person = found->second.person;
    const double share = person / (person + found->second.other);
    labels.push_back(share >= kMinPersonShare  ? CellLabel::kPerson
                     : share <= kMaxOtherShare ? CellLabel::kOther
                                               : CellLabel::kUnknown);
  }
  return labels;
}

std::vector<CellLabel> LabelByBox(const NdtMap& map, const std::optional<OrientedBox>& person_box) {
  std::vector<CellLabel> labels(map.cells.size(), CellLabel::kOther);
  if (!person_box) return labels;
  OrientedBox around = *person_box;
  around.size += Eigen::Vector3d::Constant(2 * kBoxMarginM);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Eigen::Vector3d mean = map.cells[i].mean.cast<double>();
    if (!around.Contains(mean)) continue;
    labels[i] = person_box->Contains(mean) ? CellLabel::kPerson : CellLabel::kUnknown;
  }
  return labels;
}

}  // namespace fallen
