// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fallen {

/// A message to the page: facts as JSON and numbers as typed arrays, in one piece of bytes that a
/// browser reads without copying. The other side is tools/view/page/message.js.
///
///     uint32                  length of the facts, little-endian, a multiple of 4
///     facts                   JSON, filled up with spaces; "arrays" names each array's type (as in
///                             JavaScript: "int16" is an Int16Array), offset from the end of the
///                             facts [bytes] and count [elements]
///     arrays                  little-endian, each from a multiple of 4
///
/// What facts and arrays a frame has is written at SceneToMessage.
class PageMessage {
 public:
  explicit PageMessage(nlohmann::json facts) : facts_(std::move(facts)) {}

  template <class T>
  void Add(const std::string& name, std::span<const T> values) {
    constexpr bool kIsSigned = std::is_signed_v<T>;
    static_assert(std::is_integral_v<T>);
    const std::string type = (kIsSigned ? "int" : "uint") + std::to_string(8 * sizeof(T));
    AddBytes(name, type, std::as_bytes(values), values.size());
  }

  std::vector<std::uint8_t> Encode() const;

 private:
  void AddBytes(const std::string& name, const std::string& type, std::span<const std::byte> bytes,
                std::size_t count);

  nlohmann::json facts_;
  std::vector<std::uint8_t> arrays_;
};

}  // namespace fallen
