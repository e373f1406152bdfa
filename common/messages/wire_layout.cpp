// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "fallen/messages/wire_layout.hpp"

#include <cstring>
#include <optional>
#include <vector>

#include "fallen/messages/log_format.hpp"

namespace fallen::wire {
namespace {

constexpr std::int64_t kStringLengthBytes = 4;

std::int64_t MinStructSize(const Layout& layout);

// Bytes of one element at least; exactly, but for strings and structs that hold strings or arrays.
std::int64_t MinElementSize(const Field& field) {
  switch (field.kind) {
    case Kind::kByte:
    case Kind::kBoolean:
    case Kind::kInt8:
      return 1;
    case Kind::kInt16:
      return 2;
    case Kind::kInt32:
    case Kind::kFloat:
      return 4;
    case Kind::kInt64:
    case Kind::kDouble:
      return 8;
    case Kind::kString:
      return kStringLengthBytes + 1;
    case Kind::kStruct:
      return MinStructSize(*field.layout);
  }
  return 1;
}

std::int64_t MinStructSize(const Layout& layout) {
  std::int64_t size = 0;
  for (const Field& field : layout.fields)
    if (!field.outer.is_variable() && !field.inner.is_variable())
      size += std::int64_t{field.outer.fixed} * field.inner.fixed * MinElementSize(field);
  return size;
}

class Walker {
 public:
  explicit Walker(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  bool Struct(const Layout& layout) {
    std::vector<std::int32_t> values(layout.fields.size());  // of the scalar int32 fields
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      const Field& field = layout.fields[i];
      const auto outer = Count(layout, values, field.outer);
      const auto inner = Count(layout, values, field.inner);
      if (!outer || !inner) return false;
      if (!Elements(layout, field, *outer, *inner)) return false;
      if (field.kind == Kind::kInt32 && !field.outer.is_variable() && field.outer.fixed == 1)
        values[i] = static_cast<std::int32_t>(log_format::ReadBigEndian<std::uint32_t>(taken_));
    }
    return true;
  }

  bool AtEnd(const Layout& layout) {
    if (rest_.empty()) return true;
    return Fail(layout, "end", std::to_string(rest_.size()) + " more bytes", "none");
  }

  const std::string& error() const { return error_; }

 private:
  bool Fail(const Layout& layout, std::string_view field, const std::string& got,
            const std::string& expected) {
    error_ = std::string(layout.name) + "." + std::string(field) + ": got " + got + ", expected " +
             expected;
    return false;
  }

  std::optional<std::int64_t> Count(const Layout& layout, std::span<const std::int32_t> values,
                                    const Dimension& dimension) {
    if (!dimension.is_variable()) return dimension.fixed;
    for (std::size_t i = 0; i < layout.fields.size(); ++i) {
      if (layout.fields[i].name != dimension.count_field) continue;
      if (values[i] >= 0) return values[i];
      Fail(layout, dimension.count_field, std::to_string(values[i]), ">= 0");
      return std::nullopt;
    }
    Fail(layout, dimension.count_field, "no such field", "a count");
    return std::nullopt;
  }

  bool Elements(const Layout& layout, const Field& field, std::int64_t outer, std::int64_t inner) {
    const auto present = static_cast<std::int64_t>(rest_.size());
    // Rows without elements take no bytes on the wire, but memory when decoded.
    if (inner == 0 && outer > 0)
      return Fail(layout, field.name, std::to_string(outer) + " empty rows", "none");
    const std::int64_t element_size = MinElementSize(field);
    // Counts are below 2^31 and elements below 2^10 bytes: no product of two overflows.
    if (outer > present || outer * inner > present || outer * inner * element_size > present)
      return Fail(layout, field.name,
                  std::to_string(outer) + " x " + std::to_string(inner) + " elements in " +
                      std::to_string(present) + " bytes",
                  "no more than fit");
    const std::int64_t elements = outer * inner;
    if (field.kind != Kind::kString && field.kind != Kind::kStruct)
      return Take(elements * element_size);
    for (std::int64_t i = 0; i < elements; ++i)
      if (!(field.kind == Kind::kString ? String(layout, field) : Struct(*field.layout)))
        return false;
    return true;
  }

  bool String(const Layout& layout, const Field& field) {
    if (static_cast<std::int64_t>(rest_.size()) < kStringLengthBytes)
      return Fail(layout, field.name, std::to_string(rest_.size()) + " bytes", "a string's length");
    Take(kStringLengthBytes);
    const std::int64_t length =
        static_cast<std::int32_t>(log_format::ReadBigEndian<std::uint32_t>(taken_));
    const auto present = static_cast<std::int64_t>(rest_.size());
    if (length < 1 || length > present)
      return Fail(layout, field.name, "string length " + std::to_string(length),
                  "1 to " + std::to_string(present));
    Take(length);
    // Other languages' strings end at the first 0, and so does the generated encode.
    const auto* const zero =
        static_cast<const std::uint8_t*>(std::memchr(taken_, 0, static_cast<std::size_t>(length)));
    if (zero != taken_ + length - 1)
      return Fail(layout, field.name,
                  zero == nullptr ? "a string without a final 0" : "a string with a 0 inside",
                  "one 0, at its end");
    return true;
  }

  bool Take(std::int64_t size) {
    taken_ = rest_.data();
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return true;
  }

  std::span<const std::uint8_t> rest_;
  const std::uint8_t* taken_ = nullptr;  // what was taken last
  std::string error_;
};

}  // namespace

std::string Check(const Layout& layout, std::span<const std::uint8_t> bytes) {
  Walker walker(bytes);
  if (walker.Struct(layout)) walker.AtEnd(layout);
  return walker.error();
}

std::string CheckStart(const Layout& layout, std::span<const std::uint8_t> bytes) {
  Walker walker(bytes);
  walker.Struct(layout);
  return walker.error();
}

}  // namespace fallen::wire
