// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string>

#include "fallen/messages/box_conversion.hpp"
#include "fallen/messages/camera_view_conversion.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/map_conversion.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

const std::string kHypotheses = "fallen_persons_t.hypotheses";

fallen_person_t HypothesisToMessage(const PersonHypothesis& hypothesis) {
  fallen_person_t message{};
  std::copy_n(hypothesis.centroid.data(), 3, message.centroid);
  message.box = BoxToMessage(kHypotheses + ".box", hypothesis.box);
  message.probability = hypothesis.probability;
  message.mahalanobis_distance = hypothesis.mahalanobis_distance;
  message.cell_count = hypothesis.cell_count;
  message.mean_score = hypothesis.mean_score;
  message.is_person = hypothesis.is_person ? 1 : 0;
  return message;
}

PersonHypothesis HypothesisFromMessage(const fallen_person_t& message, double min_probability) {
  for (const double coordinate : message.centroid)
    checks::InRange(kHypotheses + ".centroid", coordinate, -limits::kMaxCoordinate_m,
                    limits::kMaxCoordinate_m);
  checks::InRange(kHypotheses + ".probability", message.probability, 0.0, 1.0);
  checks::InRange(kHypotheses + ".mahalanobis_distance", message.mahalanobis_distance, 0.0,
                  std::numeric_limits<double>::max());
  checks::InRange(kHypotheses + ".cell_count", message.cell_count, 1,
                  std::numeric_limits<std::int32_t>::max());
  checks::Score(kHypotheses + ".mean_score", message.mean_score);
  const bool is_person = checks::Boolean(kHypotheses + ".is_person", message.is_person);
  if (is_person != (message.probability >= min_probability))
    checks::Fail(kHypotheses + ".is_person", is_person ? "1" : "0",
                 "whether probability " + checks::Text(message.probability) + " reaches " +
                     checks::Text(min_probability));
  PersonHypothesis hypothesis;
  hypothesis.centroid = Eigen::Vector3d(message.centroid);
  hypothesis.box = BoxFromMessage(kHypotheses + ".box", message.box);
  hypothesis.probability = message.probability;
  hypothesis.mahalanobis_distance = message.mahalanobis_distance;
  hypothesis.cell_count = message.cell_count;
  hypothesis.mean_score = message.mean_score;
  hypothesis.is_person = is_person;
  return hypothesis;
}

}  // namespace

fallen_persons_t ToMessage(const Header& header, const Decision& decision) {
  fallen_persons_t message{};
  message.header = ToMessage(header);
  message.frame = static_cast<std::int32_t>(decision.frame);
  TransformToMessage(decision.T_map_camera, message.T_map_camera);
  message.view = ViewToMessage("fallen_persons_t.view", decision.view);
  message.min_probability = decision.min_probability;
  for (const PersonHypothesis& hypothesis : decision.hypotheses)
    message.hypotheses.push_back(HypothesisToMessage(hypothesis));
  message.count = static_cast<std::int32_t>(message.hypotheses.size());
  FromMessage(message);
  return message;
}

Decision FromMessage(const fallen_persons_t& message) {
  FromMessage(message.header);
  checks::InRange("fallen_persons_t.frame", message.frame, 0, static_cast<int>(MapFrame::kCamera));
  checks::InRange("fallen_persons_t.min_probability", message.min_probability, 0.0, 1.0);
  checks::Count("fallen_persons_t.count", message.count, message.hypotheses.size());
  checks::InRange("fallen_persons_t.count", message.count, 0, limits::kMaxObjects);
  Decision decision;
  decision.frame = static_cast<MapFrame>(message.frame);
  decision.T_map_camera =
      TransformFromMessage("fallen_persons_t.T_map_camera", message.T_map_camera);
  decision.view = ViewFromMessage("fallen_persons_t.view", message.view);
  decision.min_probability = message.min_probability;
  for (const fallen_person_t& hypothesis : message.hypotheses)
    decision.hypotheses.push_back(HypothesisFromMessage(hypothesis, message.min_probability));
  return decision;
}

}  // namespace fallen
