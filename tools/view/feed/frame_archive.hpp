// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace fallen {

/// Encoded frames by number, so that one can go back to them. Not thread-safe.
class FrameArchive {
 public:
  using Bytes = std::vector<std::uint8_t>;

  virtual ~FrameArchive() = default;

  /// Keeps the next frame; may forget the oldest.
  virtual void Append(std::shared_ptr<const Bytes> frame) = 0;

  /// Numbers kept are [first(), count()); count() is how many there ever were.
  virtual std::int64_t first() const = 0;
  virtual std::int64_t count() const = 0;

  /// A frame that is kept. @throws std::runtime_error if it cannot be read back.
  virtual std::shared_ptr<const Bytes> Read(std::int64_t index) = 0;
};

}  // namespace fallen
