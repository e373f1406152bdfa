// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/doctor/network_checks.hpp"

#include <arpa/inet.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "fallen/service/configuration.hpp"
#include "fallen/service/lcm_url.hpp"
#include "tools/doctor/shipped_file.hpp"

namespace fallen {
namespace {

constexpr char kScheme[] = "udpm://";
/// LCM for Java, and so lcm-spy, takes the system's default whatever the URL says.
constexpr std::int64_t kMinDefaultBufferBytes = kMinReceiveBufferBytes;

/// A socket that closes.
class Socket {
 public:
  Socket() : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    if (descriptor_ < 0)
      throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
  }
  ~Socket() { close(descriptor_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

std::optional<std::int64_t> ReadNumber(const char* path) {
  std::ifstream file(path);
  std::int64_t value = 0;
  if (!(file >> value)) return std::nullopt;
  return value;
}

/// Most specific entry of /proc/net/route for `address`: its interface.
std::string RoutedInterface(in_addr address) {
  std::ifstream table("/proc/net/route");
  std::string line;
  std::getline(table, line);  // headings
  std::string best;
  std::int64_t best_mask = -1;
  while (std::getline(table, line)) {
    char interface[IF_NAMESIZE];
    unsigned destination = 0;
    unsigned flags = 0;
    unsigned mask = 0;
    if (std::sscanf(line.c_str(), "%15s %x %*x %x %*d %*d %*d %x", interface, &destination, &flags,
                    &mask) != 4)
      continue;
    // Numbers stand there as the network's bytes were read by this machine: as in in_addr.
    const std::int64_t specific = ntohl(mask);
    if ((address.s_addr & mask) == destination && specific > best_mask) {
      best = interface;
      best_mask = specific;
    }
  }
  return best;
}

/// `url` asking for a receive buffer that is large enough.
std::string WithReceiveBuffer(std::string url) {
  const std::size_t key = url.find("recv_buf_size=");
  if (key == std::string::npos)
    return url + (url.find('?') == std::string::npos ? "?" : "&") + "recv_buf_size=4194304";
  const std::size_t value = url.find('=', key) + 1;
  return url.replace(value, url.find('&', value) - value, "4194304");
}

}  // namespace

std::string LoadSettingsCommand(const std::string& sysctl_file) {
  if (sysctl_file.empty())
    return "sudo sysctl -w net.core.rmem_max=4194304 net.core.rmem_default=4194304";
  return "sudo cp '" + sysctl_file + "' /etc/sysctl.d/ && sudo sysctl -p '" + sysctl_file + "'";
}

std::optional<MulticastGroup> GroupOf(const std::string& lcm_url) {
  if (lcm_url.rfind(kScheme, 0) != 0) return std::nullopt;
  const std::string network =
      lcm_url.substr(sizeof kScheme - 1, lcm_url.find('?') - (sizeof kScheme - 1));
  MulticastGroup group;
  const std::size_t colon = network.find(':');
  const std::string address = network.substr(0, colon);
  if (!address.empty()) group.address = address;
  in_addr parsed{};
  if (inet_pton(AF_INET, group.address.c_str(), &parsed) != 1 ||
      !IN_MULTICAST(ntohl(parsed.s_addr)))
    throw std::invalid_argument("LCM URL: got group '" + group.address +
                                "', expected 224.0.0.0 to 239.255.255.255");
  if (colon == std::string::npos) return group;
  const std::string port = network.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), group.port);
  if (error != std::errc{} || end != port.data() + port.size() || group.port == 0)
    throw std::invalid_argument("LCM URL: got port '" + port + "', expected 1 to 65535");
  return group;
}

MulticastRoute FindMulticastRoute(const MulticastGroup& group) {
  const Socket probe;
  sockaddr_in target{};
  target.sin_family = AF_INET;
  target.sin_port = htons(group.port);
  inet_pton(AF_INET, group.address.c_str(), &target.sin_addr);
  // Connecting a datagram socket sends nothing: it asks the system for a route.
  if (connect(probe.get(), reinterpret_cast<const sockaddr*>(&target), sizeof target) != 0)
    return {};
  MulticastRoute route;
  route.interface = RoutedInterface(target.sin_addr);
  ifreq request{};
  std::strncpy(request.ifr_name, route.interface.c_str(), IFNAMSIZ - 1);
  if (route.interface.empty() || ioctl(probe.get(), SIOCGIFFLAGS, &request) != 0) {
    route.interface = "an interface of a special routing table";
    route.is_up = route.does_multicast = true;
    return route;
  }
  route.is_up = (request.ifr_flags & IFF_UP) != 0;
  route.does_multicast = (request.ifr_flags & IFF_MULTICAST) != 0;
  return route;
}

Finding JudgeRoute(const MulticastGroup& group, const MulticastRoute& route) {
  Finding finding = Good("multicast route", group.address + " goes through " + route.interface);
  const std::string set_up = "sudo ip link set lo up multicast on";
  if (route.interface.empty())
    return {finding.check, Verdict::kError,
            "no route to " + group.address + ", expected one for 224.0.0.0/4",
            set_up + " && sudo ip route add 224.0.0.0/4 dev lo"};
  if (!route.is_up || !route.does_multicast)
    return {finding.check, Verdict::kError,
            finding.text + ", which is " + (route.is_up ? "up" : "down") + " and does " +
                (route.does_multicast ? "" : "no ") + "multicast, expected up and multicast",
            "sudo ip link set " + route.interface + " up multicast on"};
  return finding;
}

std::vector<Finding> JudgeReceiveBuffers(const std::string& lcm_url,
                                         std::optional<std::int64_t> largest_bytes,
                                         std::optional<std::int64_t> default_bytes,
                                         const std::string& sysctl_file) {
  std::vector<Finding> findings;
  const std::int64_t wanted = ReceiveBufferOf(lcm_url).value_or(0);
  const std::string needed = std::to_string(kMinReceiveBufferBytes);
  Finding url =
      Good("LCM URL", "asks for a receive buffer of " + std::to_string(wanted) + " bytes");
  if (wanted < kMinReceiveBufferBytes) {
    url.verdict = Verdict::kError;
    url.text += ", expected at least " + needed + ": large messages get lost";
    url.remedy = "in the configuration, service: {lcm_url: \"" + WithReceiveBuffer(lcm_url) + "\"}";
  }
  findings.push_back(url);
  const auto judge = [&](const char* name, std::optional<std::int64_t> bytes, std::int64_t least,
                         Verdict verdict, const char* otherwise) {
    const std::string check = std::string("net.core.") + name;
    // A network namespace of its own does not show the limits; they hold all the same.
    if (!bytes) return findings.push_back(Good(check, "not shown in this network namespace"));
    if (*bytes >= least) return findings.push_back(Good(check, std::to_string(*bytes) + " bytes"));
    findings.push_back({check, verdict,
                        "got " + std::to_string(*bytes) + " bytes, expected at least " +
                            std::to_string(least) + ": " + otherwise,
                        LoadSettingsCommand(sysctl_file)});
  };
  judge("rmem_max", largest_bytes, kMinReceiveBufferBytes, Verdict::kError,
        "large messages get lost");
  judge("rmem_default", default_bytes, kMinDefaultBufferBytes, Verdict::kWarning,
        "lcm-spy does not see large messages");
  return findings;
}

std::vector<Finding> CheckNetwork(const std::string& lcm_url) {
  std::optional<MulticastGroup> group;
  try {
    RequireKnownLcmUrl(lcm_url);
    group = GroupOf(lcm_url);
  } catch (const std::invalid_argument& error) {
    return {{"LCM URL", Verdict::kError, error.what(),
             "in the configuration, service: {lcm_url: \"" + ServiceConfig().lcm_url + "\"}"}};
  }
  if (!group) return {Good("LCM URL", "'" + lcm_url + "' needs no network set up")};
  const Finding route = JudgeRoute(*group, FindMulticastRoute(*group));
  std::vector<Finding> findings{route};
  const std::string sysctl_file = FindShippedFile("config/60-fallen-lcm.conf");
  const auto buffers =
      JudgeReceiveBuffers(lcm_url, ReadNumber("/proc/sys/net/core/rmem_max"),
                          ReadNumber("/proc/sys/net/core/rmem_default"), sysctl_file);
  findings.insert(findings.end(), buffers.begin(), buffers.end());
  findings.push_back(route.verdict == Verdict::kOk
                         ? TryLoopback(lcm_url, sysctl_file)
                         : Finding{"LCM loopback", Verdict::kError,
                                   "not tried: messages have no way to go", route.remedy});
  return findings;
}

}  // namespace fallen
