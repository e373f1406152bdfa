// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>

#include "fallen/messages/box_conversion.hpp"
#include "fallen/messages/byte_compression.hpp"
#include "fallen/messages/conversions.hpp"
#include "fallen/messages/message_checks.hpp"
#include "fallen/messages/message_limits.hpp"

namespace fallen {
namespace {

constexpr char kFallenPerson[] = "fallen_person";
// Written once, read often.
constexpr int kLabelZstdLevel = 9;

labelled_object_t ObjectToMessage(const LabelledObject& object) {
  labelled_object_t message{};
  message.category = object.category;
  message.name = object.name;
  message.label = object.label;
  message.box = BoxToMessage("ground_truth_t.objects.box", object.box);
  return message;
}

LabelledObject ObjectFromMessage(const labelled_object_t& message) {
  checks::CheckText("ground_truth_t.objects.category", message.category, limits::kMaxTextBytes);
  checks::CheckText("ground_truth_t.objects.name", message.name, limits::kMaxTextBytes);
  checks::InRange("ground_truth_t.objects.label", message.label, 0, limits::kMaxLabel);
  return {message.category, message.name, message.label,
          BoxFromMessage("ground_truth_t.objects.box", message.box)};
}

// Size of the label image in bytes, 0 without one.
std::size_t LabelBytes(std::int64_t width, std::int64_t height) {
  if (width == 0 && height == 0) return 0;
  checks::InRange("ground_truth_t.width", width, 1, limits::kMaxImageSide);
  checks::InRange("ground_truth_t.height", height, 1, limits::kMaxImageSide);
  checks::InRange("ground_truth_t.width x height", width * height, 1, kMaxPixels);
  return static_cast<std::size_t>(width * height);
}

void CheckLabels(const GroundTruth& truth) {
  std::array<bool, limits::kMaxLabel + 1> is_known{};
  is_known[0] = true;  // background
  for (const LabelledObject& object : truth.objects) is_known[object.label] = true;
  const auto unknown = std::find_if(truth.labels.begin(), truth.labels.end(),
                                    [&](std::uint8_t label) { return !is_known[label]; });
  if (unknown != truth.labels.end())
    checks::Fail("ground_truth_t.labels",
                 "label " + std::to_string(*unknown) + " at pixel " +
                     std::to_string(unknown - truth.labels.begin()),
                 "0 or the label of an object");
}

}  // namespace

std::uint8_t GroundTruth::person_label() const {
  for (const LabelledObject& object : objects)
    if (object.category == kFallenPerson) return static_cast<std::uint8_t>(object.label);
  return 0;
}

ground_truth_t ToMessage(const Header& header, const GroundTruth& truth) {
  ground_truth_t message{};
  message.header = ToMessage(header);
  message.person_present = truth.person_box ? 1 : 0;
  message.person_box =
      BoxToMessage("ground_truth_t.person_box", truth.person_box.value_or(OrientedBox{}));
  message.person = truth.person;
  message.room = truth.room;
  for (const LabelledObject& object : truth.objects)
    message.objects.push_back(ObjectToMessage(object));
  message.object_count = static_cast<std::int32_t>(message.objects.size());
  message.width = truth.label_width;
  message.height = truth.label_height;
  const std::size_t label_bytes = LabelBytes(truth.label_width, truth.label_height);
  if (truth.labels.size() != label_bytes)
    checks::Fail("ground_truth_t.labels", std::to_string(truth.labels.size()) + " values",
                 std::to_string(label_bytes));
  if (label_bytes > 0) message.labels = codecs::Zstd(truth.labels, kLabelZstdLevel);
  message.size = static_cast<std::int32_t>(message.labels.size());
  FromMessage(message);
  return message;
}

GroundTruth FromMessage(const ground_truth_t& message) {
  FromMessage(message.header);
  GroundTruth truth;
  if (checks::Boolean("ground_truth_t.person_present", message.person_present))
    truth.person_box = BoxFromMessage("ground_truth_t.person_box", message.person_box);
  checks::CheckText("ground_truth_t.person", message.person, limits::kMaxTextBytes);
  checks::CheckText("ground_truth_t.room", message.room, limits::kMaxTextBytes);
  truth.person = message.person;
  truth.room = message.room;

  checks::Count("ground_truth_t.object_count", message.object_count, message.objects.size());
  checks::InRange("ground_truth_t.object_count", message.object_count, 0, limits::kMaxObjects);
  for (const labelled_object_t& object : message.objects)
    truth.objects.push_back(ObjectFromMessage(object));

  checks::Count("ground_truth_t.size", message.size, message.labels.size());
  const std::size_t label_bytes = LabelBytes(message.width, message.height);
  truth.label_width = message.width;
  truth.label_height = message.height;
  if (label_bytes > 0)
    truth.labels =
        codecs::UnZstd("ground_truth_t.labels", message.labels, label_bytes, label_bytes);
  if (label_bytes == 0 && !message.labels.empty())
    checks::Fail("ground_truth_t.size", std::to_string(message.size), "0 without a label image");
  CheckLabels(truth);
  return truth;
}

}  // namespace fallen
