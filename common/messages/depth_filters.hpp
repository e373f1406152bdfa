// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Reversible transforms that make depth images compress well. Internal to this folder.
///
/// Both write 16-bit numbers as two planes: all low bytes, then all high bytes (nearly all zero).
/// The reverse of each throws std::invalid_argument for bytes that no image gives.
namespace fallen::depth_filters {

/// Differences to the left neighbour (0 before the first of a row), modulo 2^16, with the sign in
/// the lowest bit. 2 * pixels bytes.
std::vector<std::uint8_t> Differences(std::span<const std::uint16_t> depth, int width);
std::vector<std::uint16_t> UndoDifferences(std::span<const std::uint8_t> planes, int width);

/// Most distinct values that Ranks can take: differences of ranks stay below 2^15.
inline constexpr int kMaxRanks = 32767;

/// Differences in rank. A sensor gives few of the 65536 values (PrimeSense: about a thousand
/// disparities), so a value's rank among those in the image is nearly its disparity, and noise is a
/// step or two of it at any distance.
///
/// n (2 bytes), the steps between the n ascending values (planes), then one number a pixel
/// (planes): 0 = no measurement; else 1 + the difference to the rank above, or, where there is
/// none, to the last measured one in reading order (0 at first), with the sign in the lowest bit.
/// @return Nothing if there are more than kMaxRanks distinct values.
std::optional<std::vector<std::uint8_t>> Ranks(std::span<const std::uint16_t> depth, int width);
std::vector<std::uint16_t> UndoRanks(std::span<const std::uint8_t> bytes, int width,
                                     std::size_t pixels);
/// Sizes that Ranks can have for an image of `pixels`.
std::size_t MinRanksSize(std::size_t pixels);
std::size_t MaxRanksSize(std::size_t pixels);

}  // namespace fallen::depth_filters
