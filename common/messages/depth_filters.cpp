// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/depth_filters.hpp"

#include <algorithm>
#include <string>

#include "fallen/messages/message_checks.hpp"

namespace fallen::depth_filters {
namespace {

constexpr char kField[] = "depth_image_t.data";
constexpr std::size_t kValueCount = 65536;
constexpr std::size_t kCountBytes = 2;

// The sign goes to the lowest bit, so that small differences of both signs are small numbers.
std::uint16_t FoldSign(std::uint16_t difference) {
  return static_cast<std::uint16_t>((difference << 1) ^ ((difference & 0x8000u) ? 0xffffu : 0u));
}
std::uint16_t UnfoldSign(std::uint16_t folded) {
  return static_cast<std::uint16_t>((folded >> 1) ^ ((folded & 1u) ? 0xffffu : 0u));
}

void Split(std::uint16_t value, std::uint8_t* low, std::uint8_t* high, std::size_t i) {
  low[i] = static_cast<std::uint8_t>(value);
  high[i] = static_cast<std::uint8_t>(value >> 8);
}
std::uint16_t Join(const std::uint8_t* low, const std::uint8_t* high, std::size_t i) {
  return static_cast<std::uint16_t>(low[i] | (high[i] << 8));
}

// Values present in the image but 0, ascending.
std::vector<std::uint16_t> DistinctValues(std::span<const std::uint16_t> depth) {
  std::vector<std::uint8_t> is_present(kValueCount, 0);
  for (const std::uint16_t value : depth) is_present[value] = 1;
  std::vector<std::uint16_t> values;
  for (std::size_t value = 1; value < kValueCount; ++value)
    if (is_present[value]) values.push_back(static_cast<std::uint16_t>(value));
  return values;
}

// Value of each rank; rank 0 is "no measurement".
std::vector<std::uint16_t> ReadValues(const std::uint8_t* steps, std::size_t count) {
  std::vector<std::uint16_t> values{0};
  values.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const unsigned step = Join(steps, steps + count, i);
    const unsigned value = values.back() + step;
    if (step == 0 || value >= kValueCount)
      checks::Fail(kField,
                   "value " + std::to_string(value) + " after " + std::to_string(values.back()),
                   "distinct values ascending to 65535");
    values.push_back(static_cast<std::uint16_t>(value));
  }
  return values;
}

}  // namespace

std::vector<std::uint8_t> Differences(std::span<const std::uint16_t> depth, int width) {
  std::vector<std::uint8_t> planes(2 * depth.size());
  std::uint8_t* const low = planes.data();
  std::uint8_t* const high = low + depth.size();
  for (std::size_t row = 0; row < depth.size(); row += width) {
    std::uint16_t left = 0;
    for (std::size_t i = row; i < row + width; ++i) {
      Split(FoldSign(static_cast<std::uint16_t>(depth[i] - left)), low, high, i);
      left = depth[i];
    }
  }
  return planes;
}

std::vector<std::uint16_t> UndoDifferences(std::span<const std::uint8_t> planes, int width) {
  std::vector<std::uint16_t> depth(planes.size() / 2);
  const std::uint8_t* const low = planes.data();
  const std::uint8_t* const high = low + depth.size();
  for (std::size_t row = 0; row < depth.size(); row += width) {
    std::uint16_t left = 0;
    for (std::size_t i = row; i < row + width; ++i) {
      left = static_cast<std::uint16_t>(left + UnfoldSign(Join(low, high, i)));
      depth[i] = left;
    }
  }
  return depth;
}

std::size_t MinRanksSize(std::size_t pixels) { return kCountBytes + 2 * pixels; }
std::size_t MaxRanksSize(std::size_t pixels) {
  return MinRanksSize(pixels) + 2 * std::min<std::size_t>(pixels, kMaxRanks);
}

std::optional<std::vector<std::uint8_t>> Ranks(std::span<const std::uint16_t> depth, int width) {
  const std::vector<std::uint16_t> values = DistinctValues(depth);
  if (values.size() > static_cast<std::size_t>(kMaxRanks)) return std::nullopt;

  std::vector<std::uint8_t> bytes(MinRanksSize(depth.size()) + 2 * values.size());
  Split(static_cast<std::uint16_t>(values.size()), bytes.data(), bytes.data() + 1, 0);
  std::uint8_t* const steps = bytes.data() + kCountBytes;
  std::vector<std::uint16_t> rank_of(kValueCount, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int step = values[i] - (i > 0 ? values[i - 1] : 0);
    Split(static_cast<std::uint16_t>(step), steps, steps + values.size(), i);
    rank_of[values[i]] = static_cast<std::uint16_t>(i + 1);
  }

  std::uint8_t* const low = steps + 2 * values.size();
  std::uint8_t* const high = low + depth.size();
  std::vector<std::uint16_t> above(static_cast<std::size_t>(width), 0);
  std::uint16_t last = 0;
  for (std::size_t row = 0; row < depth.size(); row += width) {
    for (std::size_t u = 0; u < above.size(); ++u) {
      const std::uint16_t rank = rank_of[depth[row + u]];
      std::uint16_t coded = 0;
      if (rank != 0) {
        const std::uint16_t expected = above[u] != 0 ? above[u] : last;
        coded =
            static_cast<std::uint16_t>(FoldSign(static_cast<std::uint16_t>(rank - expected)) + 1);
        last = rank;
      }
      above[u] = rank;
      Split(coded, low, high, row + u);
    }
  }
  return bytes;
}

std::vector<std::uint16_t> UndoRanks(std::span<const std::uint8_t> bytes, int width,
                                     std::size_t pixels) {
  const std::size_t count =
      bytes.size() < kCountBytes ? 0 : Join(bytes.data(), bytes.data() + 1, 0);
  if (count > static_cast<std::size_t>(kMaxRanks))
    checks::Fail(kField, std::to_string(count) + " distinct values", "at most 32767");
  if (bytes.size() != MinRanksSize(pixels) + 2 * count)
    checks::Fail(kField, std::to_string(bytes.size()) + " bytes",
                 std::to_string(MinRanksSize(pixels) + 2 * count));
  const std::uint8_t* const steps = bytes.data() + kCountBytes;
  const std::vector<std::uint16_t> values = ReadValues(steps, count);

  const std::uint8_t* const low = steps + 2 * count;
  const std::uint8_t* const high = low + pixels;
  std::vector<std::uint16_t> depth(pixels);
  std::vector<std::uint16_t> above(static_cast<std::size_t>(width), 0);
  std::uint16_t last = 0;
  for (std::size_t row = 0; row < pixels; row += width) {
    for (std::size_t u = 0; u < above.size(); ++u) {
      const std::uint16_t coded = Join(low, high, row + u);
      std::uint16_t rank = 0;
      if (coded != 0) {
        const std::uint16_t expected = above[u] != 0 ? above[u] : last;
        rank = static_cast<std::uint16_t>(expected +
                                          UnfoldSign(static_cast<std::uint16_t>(coded - 1)));
        if (rank == 0 || rank > count)
          checks::Fail(kField,
                       "rank " + std::to_string(rank) + " at pixel " + std::to_string(row + u),
                       "1 to " + std::to_string(count));
        last = rank;
      }
      above[u] = rank;
      depth[row + u] = values[rank];
    }
  }
  return depth;
}

}  // namespace fallen::depth_filters
