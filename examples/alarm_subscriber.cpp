// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program of somebody else's that hears alarms: message types and LCM, nothing more of ours.
// usage: alarm_subscriber [LCM_URL] prints changes until one is "cleared".
#include <cstdio>
#include <fallen/fall_alarm_t.hpp>
#include <lcm/lcm-cpp.hpp>
#include <set>
#include <string>
#include <utility>

class Subscriber {
 public:
  void OnAlarm(const lcm::ReceiveBuffer*, const std::string&, const fallen::fall_alarm_t* alarm) {
    // Active alarms are repeated: what is told apart by id and revision is news.
    if (!seen_.emplace(alarm->event_id, alarm->revision).second) return;
    static const char* const kChanges[] = {"raised", "updated", "acknowledged", "cleared"};
    std::printf("%s %s at %.2f %.2f m, p %.3f\n", alarm->event_id.c_str(),
                kChanges[alarm->change & 3], alarm->position[0], alarm->position[1],
                alarm->probability);
    is_over_ = alarm->change == fallen::fall_alarm_t::CLEARED;
  }
  bool is_over() const { return is_over_; }

 private:
  std::set<std::pair<std::string, int>> seen_;
  bool is_over_ = false;
};

int main(int argc, char** argv) {
  lcm::LCM lcm(argc > 1 ? argv[1] : "");
  if (!lcm.good()) return 1;
  Subscriber subscriber;
  lcm.subscribe("FALL_ALARM", &Subscriber::OnAlarm, &subscriber);
  while (!subscriber.is_over())
    if (lcm.handle() != 0) break;
  return 0;
}
