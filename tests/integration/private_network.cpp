// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/private_network.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <net/route.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace fallen::testing_support {
namespace {

constexpr char kBuffer[] = "?ttl=0&recv_buf_size=4194304";
constexpr int kDefaultPort = 7667;
// Ports are told apart by process where networks cannot be: below the range of short-lived ports.
constexpr int kFirstOwnPort = 10000;
constexpr int kOwnPorts = 20000;

sockaddr Address(const char* text) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, text, &address.sin_addr);
  sockaddr generic;
  std::memcpy(&generic, &address, sizeof generic);
  return generic;
}

/// ip link set lo up multicast on; ip route add 224.0.0.0/4 dev lo
bool SetUpLoopback() {
  const int control = socket(AF_INET, SOCK_DGRAM, 0);
  if (control < 0) return false;
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  request.ifr_flags = IFF_UP | IFF_RUNNING | IFF_LOOPBACK | IFF_MULTICAST;
  bool is_up = ioctl(control, SIOCSIFFLAGS, &request) == 0;
  rtentry route{};
  char device[] = "lo";
  route.rt_dst = Address("224.0.0.0");
  route.rt_genmask = Address("240.0.0.0");
  route.rt_flags = RTF_UP;
  route.rt_dev = device;
  is_up = is_up && ioctl(control, SIOCADDRT, &route) == 0;
  close(control);
  return is_up;
}

}  // namespace

std::string EnterPrivateNetwork() {
  static const std::string url = [] {
    const bool has_entered =
        unshare(CLONE_NEWNET) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0;
    const bool is_private = has_entered && SetUpLoopback();
    const int port = is_private ? kDefaultPort : kFirstOwnPort + getpid() % kOwnPorts;
    return "udpm://239.255.76.67:" + std::to_string(port) + kBuffer;
  }();
  return url;
}

}  // namespace fallen::testing_support
