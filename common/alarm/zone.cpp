// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/alarm/zone.hpp"

#include <algorithm>
#include <stdexcept>

namespace fallen {
namespace {

using Point = Eigen::Vector2d;

double Cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// True if `p`, known to be on the line through a and b, lies between them.
bool IsBetween(const Point& p, const Point& a, const Point& b) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

/// True if the closed segments a-b and c-d share a point.
bool DoMeet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double c_side = Cross(a, b, c), d_side = Cross(a, b, d);
  const double a_side = Cross(c, d, a), b_side = Cross(c, d, b);
  if (((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0)) && c_side != 0 &&
      d_side != 0 && a_side != 0 && b_side != 0)
    return true;
  return (c_side == 0 && IsBetween(c, a, b)) || (d_side == 0 && IsBetween(d, a, b)) ||
         (a_side == 0 && IsBetween(a, c, d)) || (b_side == 0 && IsBetween(b, c, d));
}

/// True if the edges from `a` to `b` and on to `c` fold back onto each other.
bool IsSpike(const Point& a, const Point& b, const Point& c) {
  return a == b || (Cross(a, b, c) == 0 && (a - b).dot(c - b) > 0);
}

bool IsInside(const std::vector<Point>& corners, const Point& p) {
  bool is_inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point& a = corners[i];
    const Point& b = corners[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace

void Zone::Validate() const {
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument("zone '" + name + "': " + what);
  };
  const std::size_t n = corners.size();
  if (n < 3) fail("got " + std::to_string(n) + " corners, expected 3 or more");
  for (const Point& corner : corners)
    if (!corner.allFinite()) fail("got a corner that is not finite, expected metres");
  if (!(bed_height_m >= 0 && bed_height_m < 10))
    fail("got bed_height_m " + std::to_string(bed_height_m) + ", expected 0 to 10");
  const auto edge = [](std::size_t i) { return std::to_string(i + 1); };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (IsSpike(corners[i], corners[next], corners[(i + 2) % n]))
      fail("corner " + edge(next) + " folds the polygon onto itself, expected a simple polygon");
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i) continue;  // neighbours share a corner
      if (DoMeet(corners[i], corners[next], corners[j], corners[(j + 1) % n]))
        fail("the edges after corners " + edge(i) + " and " + edge(j) +
             " cross, expected a simple polygon");
    }
  }
}

bool Zone::Excludes(const Eigen::Vector3d& centroid) const {
  if (!IsInside(corners, centroid.head<2>())) return false;
  return kind == ZoneKind::kNever || centroid.z() >= bed_height_m;
}

}  // namespace fallen
