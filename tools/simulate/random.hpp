// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

/// Random numbers that are the same with every standard library, and streams that do not disturb
/// each other: a scene keeps its room when the person in it changes.
///
/// [Steele14] Steele, Lea, Flood: Fast splittable pseudorandom number generators. OOPSLA 2014.
namespace fallen::sim {

/// Finaliser of SplitMix64 [Steele14]: spreads every input bit over all output bits.
constexpr std::uint64_t MixBits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// FNV-1a: a hash of names that stays the same for ever, unlike std::hash.
constexpr std::uint64_t StableHash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash;
}

/// A seeded stream of random numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(MixBits(seed)) {}

  /// An independent stream, the same one for the same name however much was drawn before.
  static Random Stream(std::uint64_t seed, std::string_view name) {
    return Random(MixBits(seed) ^ StableHash(name));
  }

  std::uint64_t Bits() { return MixBits(state_++); }
  /// In [0, 1).
  double Uniform() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  /// In [0, count); count > 0. The bias of the remainder is below 1e-15 for our counts.
  int Index(std::size_t count) { return static_cast<int>(Bits() % count); }
  /// In [low, high], both ends included.
  int Integer(int low, int high) { return low + Index(static_cast<std::size_t>(high - low + 1)); }
  bool Chance(double probability) { return Uniform() < probability; }
  double Normal(double mean = 0, double sigma = 1) {
    const double radius = std::sqrt(-2 * std::log(1 - Uniform()));
    return mean + sigma * radius * std::cos(2 * std::numbers::pi * Uniform());
  }
  /// Normal, drawn again until within two sigmas: for quantities that must stay plausible.
  double BoundedNormal(double mean, double sigma) {
    for (;;) {
      const double value = Normal();
      if (std::abs(value) <= 2) return mean + sigma * value;
    }
  }
  template <class Container>
  const auto& Pick(const Container& container) {
    return container[static_cast<std::size_t>(Index(container.size()))];
  }

 private:
  std::uint64_t state_;
};

}  // namespace fallen::sim
