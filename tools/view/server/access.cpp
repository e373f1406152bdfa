// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/view/server/access.hpp"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

namespace fallen {
namespace {

std::string_view WithoutPort(std::string_view host) {
  if (host.starts_with('[')) return host.substr(0, host.find(']') + 1);
  return host.substr(0, host.find(':'));
}

bool IsEqual(std::string_view got, std::string_view expected) {
  unsigned difference = got.size() != expected.size();
  for (std::size_t i = 0; i < expected.size(); ++i)
    difference |= static_cast<unsigned>((i < got.size() ? got[i] : '\0') ^ expected[i]);
  return difference == 0;
}

/// Value of `name` in "name=value" pairs apart by `separator`; nothing if it is not there.
std::optional<std::string_view> ValueOf(std::string_view pairs, std::string_view name,
                                        char separator) {
  while (!pairs.empty()) {
    const std::string_view whole = pairs.substr(0, pairs.find(separator));
    pairs.remove_prefix(std::min(whole.size() + 1, pairs.size()));
    const std::string_view pair =
        whole.substr(std::min(whole.find_first_not_of(' '), whole.size()));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('='))
      return pair.substr(name.size() + 1);
  }
  return std::nullopt;
}

std::string_view QueryOf(std::string_view target) {
  const std::size_t mark = target.find('?');
  return mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
}

}  // namespace

bool IsLoopback(std::string_view host) {
  if (host == "localhost" || host == "::1" || host == "[::1]") return true;
  return host.starts_with("127.") &&
         host.find_first_not_of("0123456789.") == std::string_view::npos;
}

AccessVerdict Judge(const RequestOrigin& request, const AccessRules& rules) {
  const std::string_view scheme_end = "://";
  if (!request.origin.empty()) {
    const std::size_t end = request.origin.find(scheme_end);
    if (end == std::string_view::npos ||
        request.origin.substr(end + scheme_end.size()) != request.host)
      return {false, "got a request of another site, expected one of the page", ""};
  }
  if (!rules.token) {
    if (IsLoopback(WithoutPort(request.host))) return {true, "", ""};
    return {false, "got a foreign host name, expected localhost", ""};
  }
  const std::string cookie_name = "fallen_view_" + std::to_string(rules.port);
  if (const auto given = ValueOf(QueryOf(request.target), "token", '&')) {
    if (!IsEqual(*given, *rules.token))
      return {false, "token: got one that does not match, expected that of the printed address",
              ""};
    return {true, "", cookie_name + "=" + *rules.token + "; HttpOnly; SameSite=Strict; Path=/"};
  }
  const auto kept = ValueOf(request.cookie, cookie_name, ';');
  if (kept && IsEqual(*kept, *rules.token)) return {true, "", ""};
  return {false, "token: got none that matches, expected ?token= as in the printed address", ""};
}

std::string MakeToken() {
  std::array<std::uint8_t, 16> bits{};
  if (getrandom(bits.data(), bits.size(), 0) != static_cast<ssize_t>(bits.size()))
    throw std::runtime_error("token: the system gives no random bits");
  std::string token;
  for (const std::uint8_t byte : bits) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

}  // namespace fallen
