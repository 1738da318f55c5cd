// Attacks on the server's memory: whatever clients hold there, it stays within limits.memory_bytes.
//
// What is measured is the peak of the resident set that the system keeps, so nothing between two looks is
// missed. Sanitizers keep memory of their own, so nothing is measured under them.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>
#include <chrono>
#include <deque>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "certificates.h"
#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "siege.h"
#include "tls_client.h"

using namespace talus;
using namespace talus::e2e;
using asio::ip::tcp;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMebibyte = std::size_t{1} << 20;
constexpr std::size_t kBudget = 256 * kMebibyte;
// What the allocator takes beside what it is asked for.
constexpr std::size_t kMayGrow = kBudget / 10 * 11;

/// A server with that budget that holds no attack from this machine by its other limits.
Settings settings(Settings more = {}) {
  more.merge(Settings{{"TALUS_LIMITS_MEMORY_BYTES", std::to_string(kBudget)},
                      {"TALUS_LIMITS_CONNECTIONS", "16384"},
                      {"TALUS_LIMITS_CONNECTIONS_PER_ADDRESS", "16384"},
                      {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_PER_SECOND", "1000000"},
                      {"TALUS_LIMITS_HANDSHAKES_PER_ADDRESS_BURST", "1000000"},
                      {"TALUS_RATES_SESSION_REQUESTS", "0"},
                      {"TALUS_RATES_ADDRESS_REQUESTS", "0"},
                      {"TALUS_RATES_SESSION_CHUNKS", "0"},
                      {"TALUS_RATES_ADDRESS_CHUNKS", "0"},
                      {"TALUS_RATES_SESSION_BYTES", "0"},
                      {"TALUS_RATES_ADDRESS_BYTES", "0"},
                      {"TALUS_THREADS_GENERATOR", "2"},
                      {"TALUS_LOG_LEVEL", "error"}});
  return more;
}

/// How far the server's resident memory has grown at most since this was made.
class Growth {
 public:
  explicit Growth(const ServerProcess& server) : server_{server}, idle_{server.resident_bytes()} {}

  void check(const std::string& what) const {
    const std::size_t most = server_.max_resident_bytes() - idle_;
    std::cout << what << ": resident memory grew by " << (most >> 20) << " MiB at most, of "
              << (kBudget >> 20) << "\n";
    CHECK(most < kMayGrow);
  }

 private:
  const ServerProcess& server_;
  const std::size_t idle_;
};

/// Pings without end.
protocol::Frame many_pings() {
  protocol::Frame pings;
  while (pings.size() < kMebibyte) {
    const auto one = ping(pings.size());
    pings.insert(pings.end(), one.begin(), one.end());
  }
  return pings;
}

/// Asks for as much as a session may, and reads nothing. Every second one only says the same again and again.
class DeafClient {
 public:
  /// `then` is what it says again and again, after that.
  DeafClient(std::uint16_t port, std::int32_t number, const protocol::Frame& then)
      : client_{port}, first_{hello({.window_bytes = 4 * kMebibyte})}, then_{then} {
    const VoxelPos centre{number * 10'000, 100, -number * 7'000};
    if (number % 2 != 0) return;
    add(view({.centre = centre, .horizontal_radius = 47, .vertical_radius = 3}));
    std::vector<wire::ColumnPos> columns;
    for (std::int32_t x = 0; x < 2048; ++x) columns.emplace_back(centre.x + x, centre.z);
    for (std::uint32_t id = 1; id <= 8; ++id) add(get_heights(id, columns));
  }

  /// As much as the server takes now.
  void go_on() {
    const bool has_begun = sent_ >= first_.size();
    const auto left = has_begun ? std::span{then_}.subspan((sent_ - first_.size()) % then_.size())
                                : std::span<const std::byte>{first_}.subspan(sent_);
    sent_ += client_.send_some(left).value_or(0);
  }

 private:
  void add(const protocol::Frame& frame) { first_.insert(first_.end(), frame.begin(), frame.end()); }

  RawClient client_;
  protocol::Frame first_;
  const protocol::Frame& then_;
  std::size_t sent_ = 0;
};

/// What a client who comes now hears first; nothing where the server does not open its WebSocket.
wire::Body first_word(std::uint16_t port) try {
  RawClient client{port};
  const bool sent = client.send(hello());
  const auto said = sent ? client.receive() : std::nullopt;
  return said ? said->kind() : wire::Body::NONE;
} catch (const RawClient::NotOpened&) {
  return wire::Body::NONE;
}

}  // namespace

TEST_CASE("under siege memory stays within its limit: frames of 16 MiB in flight") {
  if (kSanitized) return;
  constexpr std::size_t kConnections = 100;
  constexpr std::size_t kFrameBytes = 16 * kMebibyte;
  allow_many_sockets();
  const ServerProcess server{settings({{"TALUS_LIMITS_FRAME_BYTES", std::to_string(kFrameBytes)}})};
  const Growth growth{server};
  protocol::Frame frame(kFrameBytes - 1);  // its last byte never comes
  const std::uint32_t length = kFrameBytes - protocol::kPrefixBytes;
  for (std::size_t i = 0; i < protocol::kPrefixBytes; ++i)
    frame[i] = static_cast<std::byte>(length >> (8 * i));
  std::vector<RawClient> attackers;
  for (std::size_t i = 0; i < kConnections; ++i) attackers.push_back(greeted(server.port()));
  // All at once, a piece of each at a time; the server reads on where it has refused.
  std::vector<std::size_t> sent(kConnections);
  for (bool all = false; !all;) {
    all = true;
    for (std::size_t i = 0; i < kConnections; ++i) {
      if (sent[i] == frame.size()) continue;
      sent[i] += attackers[i].send_some(std::span{frame}.subspan(sent[i])).value_or(frame.size() - sent[i]);
      all = false;
    }
  }
  std::size_t refused = 0;
  for (RawClient& attacker : attackers) {
    const auto said = attacker.receive_within(std::chrono::milliseconds{0});
    if (!said) continue;
    CHECK(said->as<wire::Error>().code() == wire::ErrorCode::overloaded);
    ++refused;
  }
  CHECK(refused > 0);
  growth.check(std::to_string(kConnections) + " frames of 16 MiB, " + std::to_string(refused) + " refused");
  attackers.clear();
  while (first_word(server.port()) != wire::Body::Welcome) continue;
}

TEST_CASE("under siege memory stays within its limit: TLS handshakes that stop half-way", "[tcp]") {
  if (kSanitized) return;
  constexpr std::size_t kHandshakes = 5000;
  allow_many_sockets();
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  const ServerProcess server{
      settings({{"TALUS_TLS_CERTIFICATE", scratch.write("certificate.pem", own.certificate)},
                {"TALUS_TLS_KEY", scratch.write("key.pem", own.key)},
                {"TALUS_LIMITS_HANDSHAKES_IN_FLIGHT", "16384"}})};
  const Growth growth{server};
  const std::string begins = client_hello();
  asio::io_context io;
  std::deque<tcp::socket> stopped;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < kHandshakes; ++i) {
    tcp::socket& socket = stopped.emplace_back(io);
    socket.connect({asio::ip::address_v4::loopback(), server.port()});
    std::error_code failed;
    asio::write(socket, asio::buffer(begins), failed);
    std::array<char, 1> answer;  // its handshake waits for the client now
    if (!failed) asio::read(socket, asio::buffer(answer), failed);
    if (!failed) continue;
    stopped.pop_back();
    ++refused;
  }
  CHECK(refused > 0);
  CHECK(stopped.size() > 500);
  growth.check(std::to_string(stopped.size()) + " TLS handshakes half-way, " + std::to_string(refused) +
               " refused");
}

TEST_CASE("under siege memory stays within its limit: sessions that ask for much and read nothing") {
  if (kSanitized) return;
  constexpr std::int32_t kSessions = 600;
  allow_many_sockets();
  const ServerProcess server{settings()};
  const Growth growth{server};
  const protocol::Frame pings = many_pings();
  std::deque<DeafClient> deaf;
  for (std::int32_t i = 0; i < kSessions; ++i) deaf.emplace_back(server.port(), i, pings);
  const auto end = Clock::now() + siege_time();
  while (Clock::now() < end) {
    for (DeafClient& client : deaf) client.go_on();
  }
  growth.check(std::to_string(kSessions) + " sessions that read nothing");
  deaf.clear();
  while (first_word(server.port()) != wire::Body::Welcome) continue;
}
