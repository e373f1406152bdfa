// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/service/version.hpp"

namespace fallen {

const char* Version() { return FALLEN_VERSION; }

}  // namespace fallen
