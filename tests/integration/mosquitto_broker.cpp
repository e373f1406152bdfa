// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/mosquitto_broker.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tests/support/run_program.hpp"

namespace fallen::testing_support {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr char kUser[] = "fallen";
constexpr char kPassword[] = "secret";

sockaddr_in Loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A port that nobody listens on now.
int FreePort() {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = Loopback(0);
  socklen_t size = sizeof address;
  bind(listener, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  close(listener);
  return ntohs(address.sin_port);
}

bool Answers(int port) {
  const int client = socket(AF_INET, SOCK_STREAM, 0);
  const sockaddr_in address = Loopback(port);
  const bool is_there =
      connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(client);
  return is_there;
}

std::string Find(const std::string& program) {
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"})
    if (access((folder + program).c_str(), X_OK) == 0) return folder + program;
  return "";
}

void Run(const std::vector<std::string>& command) {
  const ProgramOutcome outcome = RunCommand(command);
  if (outcome.status != 0) throw std::runtime_error(command[0] + ": " + outcome.err);
}

}  // namespace

bool MosquittoBroker::IsInstalled() {
  return !Find("mosquitto").empty() && !Find("mosquitto_passwd").empty() &&
         !Find("mosquitto_pub").empty() && !Find("openssl").empty();
}

MosquittoBroker::MosquittoBroker(const std::filesystem::path& folder) : folder_(folder) {
  std::filesystem::create_directories(folder_);
  MakeCertificate("broker", "localhost");
  Run({Find("mosquitto_passwd"), "-b", "-c", (folder_ / "passwords").string(), kUser, kPassword});
  std::ofstream(folder_ / "password") << kPassword << '\n';
  port_ = FreePort();
  std::ofstream(folder_ / "mosquitto.conf")
      << "user root\nlistener " << port_ << " 127.0.0.1\nsocket_domain ipv4\n"
      << "allow_anonymous false\npassword_file " << (folder_ / "passwords").string()
      << "\ncertfile " << (folder_ / "broker.crt").string() << "\nkeyfile "
      << (folder_ / "broker.key").string() << "\npersistence true\npersistence_location "
      << folder_.string() << "/\nautosave_interval 1\nautosave_on_changes true\n";
}

std::filesystem::path MosquittoBroker::MakeCertificate(const std::string& name,
                                                       const std::string& host) {
  const auto file = [&](const std::string& suffix) { return (folder_ / (name + suffix)).string(); };
  Run({Find("openssl"), "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj",
       "/CN=test authority", "-keyout", file("-ca.key"), "-out", file("-ca.crt")});
  Run({Find("openssl"), "req", "-newkey", "rsa:2048", "-nodes", "-subj", "/CN=" + host, "-keyout",
       file(".key"), "-out", file(".csr")});
  std::ofstream(file(".ext")) << "subjectAltName=DNS:" << host << '\n';
  Run({Find("openssl"), "x509", "-req", "-days", "2", "-in", file(".csr"), "-CA", file("-ca.crt"),
       "-CAkey", file("-ca.key"), "-CAcreateserial", "-extfile", file(".ext"), "-out",
       file(".crt")});
  return file("-ca.crt");
}

void MosquittoBroker::Start() {
  process_.emplace(
      std::vector<std::string>{Find("mosquitto"), "-c", (folder_ / "mosquitto.conf").string()},
      folder_);
  const auto end = Clock::now() + seconds(20);
  while (!Answers(port_)) {
    if (Clock::now() > end || process_->WaitForExit(milliseconds(0)))
      throw std::runtime_error("mosquitto: " + process_->StandardError());
    std::this_thread::sleep_for(milliseconds(20));
  }
}

void MosquittoBroker::Kill() { process_.reset(); }

MqttConfig MosquittoBroker::Config() const {
  MqttConfig config;
  config.host = "localhost";
  config.port = port_;
  config.ca_file = (folder_ / "broker-ca.crt").string();
  config.username = kUser;
  config.password_file = (folder_ / "password").string();
  return config;
}

std::string MosquittoBroker::Yaml() const {
  const MqttConfig config = Config();
  return "mqtt:\n  host: " + config.host + "\n  port: " + std::to_string(config.port) +
         "\n  ca_file: " + config.ca_file + "\n  username: " + config.username +
         "\n  password_file: " + config.password_file + "\n";
}

MqttListener::MqttListener(const MosquittoBroker& broker, const std::string& client_id,
                           std::vector<std::string> topics)
    : config_(broker.Config()), client_id_(client_id), topics_(std::move(topics)) {}

void MqttListener::Connect() {
  is_subscribed_ = false;
  connection_ = std::make_unique<MqttConnection>(
      config_, kPassword, client_id_, "test/" + client_id_, "gone",
      MqttConnection::Handlers{
          [this] { connection_->Subscribe(topics_); },
          [this](int) { is_subscribed_ = true; },
          {},
          [this](const std::string& topic, const std::string& payload, bool is_retained) {
            messages_.push_back({topic, payload, is_retained});
          }});
}

bool MqttListener::ListenUntil(const std::function<bool()>& done, milliseconds timeout) {
  const auto end = Clock::now() + timeout;
  while (!done()) {
    if (Clock::now() > end) return false;
    try {
      if (!connection_) Connect();
      connection_->Loop(milliseconds(20));
    } catch (const std::runtime_error&) {
      connection_.reset();
      std::this_thread::sleep_for(milliseconds(100));
    }
  }
  return true;
}

void MqttListener::ListenFor(milliseconds time) {
  ListenUntil([] { return false; }, time);
}

std::string MqttListener::Newest(const std::string& topic) const {
  const auto payloads = Payloads(topic);
  return payloads.empty() ? "" : payloads.back();
}

std::vector<std::string> MqttListener::Payloads(const std::string& topic) const {
  std::vector<std::string> payloads;
  for (const Message& message : messages_)
    if (message.topic == topic) payloads.push_back(message.payload);
  return payloads;
}

}  // namespace fallen::testing_support
