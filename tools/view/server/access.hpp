// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace fallen {

/// Who may see the page: depth images of a home are nobody else's business.
struct AccessRules {
  std::optional<std::string> token;  ///< nothing: whoever reaches the address may
  unsigned short port = 0;           ///< tells the cookies of several servers apart
};

/// What a request says about where it comes from; empty where it says nothing.
struct RequestOrigin {
  std::string_view target;  ///< path with query
  std::string_view host;
  std::string_view origin;  ///< the site whose script asks
  std::string_view cookie;
};

struct AccessVerdict {
  bool is_allowed = false;
  std::string reason;      ///< if not: one line for people
  std::string set_cookie;  ///< if so, and the token came with the address: the header's value
};

/// Judges a request. The token may come with the address (?token=...) or as the cookie that such an
/// address sets. Without a token, only names of this host are served, so that no other site can
/// reach it through a name of its own; with or without, a script of another site is refused.
/// The comparison takes the same time wherever the tokens differ.
AccessVerdict Judge(const RequestOrigin& request, const AccessRules& rules);

/// 128 random bits as hexadecimal digits. @throws std::runtime_error if the system has none.
std::string MakeToken();

/// True for 127.0.0.0/8, ::1 and localhost.
bool IsLoopback(std::string_view host);

}  // namespace fallen
