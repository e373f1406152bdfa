// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace fallen {

/// A browser's end of a WebSocket, as bytes: it reads when the test says so, and not before.
class WebSocket {
 public:
  /// @throws std::runtime_error if the server at this port of this host does not open one.
  explicit WebSocket(int port) : file_(socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval patience{60, 0};
    setsockopt(file_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw std::runtime_error("no connection to port " + std::to_string(port));
    SendAll(
        "GET /feed HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n");
    std::string answer;
    while (answer.find("\r\n\r\n") == std::string::npos) answer += Read(1);
    if (answer.find(" 101 ") == std::string::npos) throw std::runtime_error(answer);
  }
  ~WebSocket() { close(file_); }
  WebSocket(const WebSocket&) = delete;

  /// Sends a text of less than 126 bytes.
  void Send(const std::string& text) {
    std::string frame = {static_cast<char>(0x81), static_cast<char>(0x80 | text.size())};
    SendAll(frame + std::string(4, '\0') + text);  // masked with zeros
  }

  struct Message {
    bool is_text = false;
    std::string bytes;
  };
  /// The next text or binary message. @throws std::runtime_error if none comes for a minute.
  Message Receive() {
    Message message;
    while (true) {
      const std::string head = Read(2);
      const int kind = head[0] & 0x0f;
      std::size_t size = head[1] & 0x7f;
      if (size >= 126) {
        const std::string longer = Read(size == 126 ? 2 : 8);
        size = 0;
        for (const unsigned char byte : longer) size = size << 8 | byte;
      }
      const std::string bytes = Read(size);
      if (kind > 2) continue;  // ping, pong, close
      if (kind > 0) message = {kind == 1, ""};
      message.bytes += bytes;
      const bool is_last = (head[0] & 0x80) != 0;
      if (is_last) return message;
    }
  }

 private:
  void SendAll(const std::string& bytes) const {
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t size = send(file_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (size <= 0) throw std::runtime_error("the server takes nothing any more");
      sent += static_cast<std::size_t>(size);
    }
  }
  std::string Read(std::size_t size) const {
    std::string bytes(size, '\0');
    for (std::size_t got = 0; got < size;) {
      const ssize_t more = recv(file_, bytes.data() + got, size - got, 0);
      if (more <= 0) throw std::runtime_error("the server sends nothing any more");
      got += static_cast<std::size_t>(more);
    }
    return bytes;
  }

  const int file_;
};

}  // namespace fallen
