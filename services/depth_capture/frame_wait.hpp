// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenNI.h>

namespace fallen {

/// Waits for the next frame of `stream` and takes it, up to `timeout_ms`.
///
/// All such waits of a process happen in one thread, which never ends: OpenNI2 keeps a list of all
/// threads that ever waited, also across a shutdown, and asks each with every frame whether it
/// still lives. For one that has ended that is a look at memory that may be gone, and a crash.
/// @return STATUS_OK with a valid `frame`, STATUS_TIME_OUT, or what went wrong.
openni::Status WaitForFrame(openni::VideoStream& stream, int timeout_ms,
                            openni::VideoFrameRef& frame);

}  // namespace fallen
