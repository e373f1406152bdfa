// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/feed/replay_report.hpp"

#include <iostream>

namespace fallen {

ReplayReport::ReplayReport(Feed& feed, const std::string& name, const std::string& camera)
    : feed_(feed), name_(name), camera_(camera) {
  Progress(0, {});
}

void ReplayReport::Progress(double share_read, const Damage& damage) {
  feed_.SetTopic("source", {{"mode", "replay"},
                            {"name", name_},
                            {"camera", camera_},
                            {"share_read", share_read},
                            {"damage", damage.count},
                            {"damage_example", damage.example}});
}

void ReplayReport::End(const Damage& damage) {
  Progress(1, damage);
  if (damage.count > 0)
    std::cerr << "fallen-view: " << name_ << ": " << damage.count
              << " damaged or unusable places left out, the last: " << damage.example << std::endl;
}

}  // namespace fallen
