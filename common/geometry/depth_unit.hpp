// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fallen/geometry/enum_names.hpp"

namespace fallen {

/// What one step of a depth camera's values means.
enum class DepthUnit { k1Mm = 0, k100Um = 1 };
constexpr auto EnumNames(DepthUnit) {
  return EnumTable<DepthUnit, 2>{{{DepthUnit::k1Mm, "1mm"}, {DepthUnit::k100Um, "100um"}}};
}
constexpr double MetresPerUnit(DepthUnit unit) { return unit == DepthUnit::k1Mm ? 1e-3 : 1e-4; }

}  // namespace fallen
