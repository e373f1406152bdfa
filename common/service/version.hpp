// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace fallen {

/// Version of the project, as in CMakeLists.txt: what --version and the status messages say.
const char* Version();

}  // namespace fallen
