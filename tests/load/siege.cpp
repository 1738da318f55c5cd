// Attackers beside good players, against a server that runs already: they send what is legal without end,
// what is not, and nothing at all, by TCP or inside WebSockets. Prints how much of each; judges nothing.
#include <algorithm>
#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/write.hpp>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <talus/websocket/client_side.h>

#include "messages.h"

namespace {

using namespace talus;
using namespace talus::e2e;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kFirstAddress =
    0x7F000101U;  // 127.0.1.1: good players come from 127.0.0.1 and the next
constexpr std::uint32_t kAddresses = 4;
// Between two turns of an attacker, so that the attack leaves the processor to those who are measured.
constexpr std::chrono::milliseconds kBetweenTurns{5};

volatile std::sig_atomic_t told_to_end = 0;

protocol::Frame join(std::vector<protocol::Frame> frames) {
  protocol::Frame all;
  for (const auto& frame : frames) all.insert(all.end(), frame.begin(), frame.end());
  return all;
}

/// Large Views, each of other chunks than the one before it.
protocol::Frame views(std::mt19937& random) {
  std::vector<protocol::Frame> frames;
  for (int i = 0; i < 256; ++i) {
    const auto x = static_cast<std::int64_t>(random() % 10'000'000);
    frames.push_back(view({.centre = {x, 100, i * 50'000}, .horizontal_radius = 40, .vertical_radius = 4}));
  }
  return join(std::move(frames));
}

/// Chunks that nobody has asked for, 128 at a time.
protocol::Frame cold_chunks(std::mt19937& random) {
  std::vector<protocol::Frame> frames;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto x = static_cast<std::int32_t>(random() % 1'000'000);
    std::vector<wire::ChunkRequest> requests;
    for (std::uint32_t each = 0; each < 128; ++each) {
      requests.push_back(chunk_request(i * 128 + each, {{x, 0, static_cast<std::int32_t>(each) * 4}, Lod{}}));
    }
    frames.push_back(get_chunks(requests));
  }
  return join(std::move(frames));
}

/// Heights of 254 tiles far from each other.
protocol::Frame heights(std::mt19937& random) {
  std::vector<protocol::Frame> frames;
  for (std::uint32_t i = 0; i < 16; ++i) {
    std::vector<wire::ColumnPos> columns;
    for (int each = 0; each < 254; ++each) {
      columns.emplace_back(static_cast<std::int32_t>(random() % 100'000'000), each * 4096);
    }
    frames.push_back(get_heights(i, columns));
  }
  return join(std::move(frames));
}

protocol::Frame noise(std::mt19937& random) {
  protocol::Frame bytes(1 + random() % 5000);
  for (std::byte& each : bytes) each = static_cast<std::byte>(random());
  return bytes;
}

/// A real message with a byte changed.
protocol::Frame broken(std::mt19937& random) {
  protocol::Frame bytes = cold_chunks(random);
  bytes[random() % bytes.size()] = static_cast<std::byte>(random());
  return bytes;
}

/// In messages of a WebSocket.
protocol::Frame wrapped(const protocol::Frame& bytes) {
  constexpr std::array kMask{std::byte{0xDE}, std::byte{0xCA}, std::byte{0xDE}, std::byte{0x01}};
  protocol::Frame frames;
  websocket::ClientSide::append(frames, bytes, kMask);
  return frames;
}

/// One attacker: it connects, sends its bytes again and again, reads or not, and comes back when it is thrown
/// out, or after some seconds, as somebody new.
class Attacker {
 public:
  struct Way {
    std::string name;
    std::function<protocol::Frame(std::mt19937&)> bytes;  // none: it says nothing at all
    bool greets = true;
    bool reads = true;
    bool resets = false;  // ends by RST at once
    std::chrono::milliseconds stays{10'000};
  };
  Attacker(asio::io_context& io, const Way& way, std::uint32_t seed, std::uint16_t port, bool by_websocket)
      : way_{way}, io_{io}, random_{seed}, seed_{seed}, port_{port}, by_websocket_{by_websocket} {}

  /// As much as the server takes now.
  void go_on() {
    const auto now = Clock::now();
    if (socket_ != nullptr && now < ends_) return send_and_read();
    if (socket_ != nullptr) leave();
    if (now >= next_) come(now);
  }

  std::uint64_t connections = 0;
  std::uint64_t bytes = 0;
  std::uint64_t refused = 0;

 private:
  void come(Clock::time_point now) {
    std::error_code failed;
    next_ = now + std::chrono::milliseconds{20};
    ends_ = now + way_.stays / 2 +
            std::chrono::milliseconds{static_cast<long>(random_()) % (way_.stays.count() + 1)};
    socket_ = std::make_unique<tcp::socket>(io_);
    socket_->open(tcp::v4(), failed);
    if (!failed) socket_->bind({asio::ip::address_v4{kFirstAddress + seed_ % kAddresses}, 0}, failed);
    if (!failed) socket_->connect({asio::ip::address_v4::loopback(), port_}, failed);
    if (failed) {
      ++refused;
      socket_.reset();
      return;
    }
    ++connections;
    if (way_.resets) {
      socket_->set_option(asio::socket_base::linger{true, 0}, failed);
      return leave();
    }
    to_send_ = way_.bytes ? way_.bytes(random_) : protocol::Frame{};
    sent_ = 0;
    if (way_.greets) greet(failed);
    socket_->non_blocking(true, failed);
  }

  /// Who does not greet sends no WebSocket's bytes either.
  void greet(std::error_code& failed) {
    protocol::Frame first = hello({.window_bytes = 1U << 24U});
    if (by_websocket_) {
      constexpr std::array<std::byte, websocket::kNonceBytes> kNonce{};
      const websocket::ClientSide side{"127.0.0.1", "/v1/stream", kNonce};
      asio::write(*socket_, asio::buffer(side.request()), failed);
      first = wrapped(first);
      to_send_ = wrapped(to_send_);
    }
    asio::write(*socket_, asio::buffer(first), failed);
  }

  void send_and_read() {
    std::error_code failed;
    if (!to_send_.empty()) {
      const std::size_t sent = socket_->write_some(asio::buffer(to_send_) + sent_ % to_send_.size(), failed);
      sent_ += sent;
      bytes += sent;
      if (failed && failed != asio::error::would_block) return leave();
    }
    if (!way_.reads) return;
    std::array<std::byte, 65536> dropped;
    for (failed = {}; !failed;) socket_->read_some(asio::buffer(dropped), failed);
    if (failed != asio::error::would_block) leave();
  }

  void leave() { socket_.reset(); }

  const Way& way_;
  asio::io_context& io_;
  std::mt19937 random_;
  const std::uint32_t seed_;
  const std::uint16_t port_;
  const bool by_websocket_;
  std::unique_ptr<tcp::socket> socket_;
  protocol::Frame to_send_;
  std::size_t sent_ = 0;
  Clock::time_point ends_{};
  Clock::time_point next_{};
};

std::vector<std::pair<Attacker::Way, int>> ways() {
  using std::chrono::milliseconds;
  return {
      {{.name = "send Views", .bytes = views}, 20},
      {{.name = "send Views and read nothing", .bytes = views, .reads = false, .stays = milliseconds{60'000}},
       10},
      {{.name = "ask for cold chunks", .bytes = cold_chunks}, 8},
      {{.name = "ask for heights", .bytes = heights}, 4},
      {{.name = "send noise", .bytes = noise, .greets = false, .stays = milliseconds{50}}, 2},
      {{.name = "send noise after Hello", .bytes = noise, .stays = milliseconds{50}}, 2},
      {{.name = "send messages with a wrong byte", .bytes = broken, .stays = milliseconds{200}}, 2},
      {{.name = "say nothing", .bytes = {}, .greets = false, .stays = milliseconds{60'000}}, 100},
      {{.name = "reset at once", .bytes = {}, .greets = false, .resets = true}, 2},
  };
}

}  // namespace

int main(int argc, char** argv) {
  const long seconds = argc >= 3 ? std::strtol(argv[2], nullptr, 10) : 0;
  const unsigned long port = argc >= 3 ? std::strtoul(argv[1], nullptr, 10) : 0;
  const bool by_websocket = argc == 4 && std::string{argv[3]} == "websocket";
  if (seconds <= 0 || port == 0 || port > 65535 || argc != (by_websocket ? 4 : 3)) {
    std::fputs(
        "usage: talus-siege PORT SECONDS [websocket]   (of a server on 127.0.0.1; of its HTTP by "
        "WebSocket)\n",
        stderr);
    return 2;
  }
  (void)std::signal(SIGTERM, [](int) { told_to_end = 1; });
  const auto kinds = ways();
  asio::io_context io;
  std::vector<std::pair<const Attacker::Way*, std::unique_ptr<Attacker>>> attackers;
  std::uint32_t seed = 0;
  for (const auto& [way, count] : kinds) {
    for (int i = 0; i < count; ++i) {
      attackers.emplace_back(
          &way, std::make_unique<Attacker>(io, way, ++seed, static_cast<std::uint16_t>(port), by_websocket));
    }
  }
  const auto ends = Clock::now() + std::chrono::seconds{seconds};
  while (told_to_end == 0 && Clock::now() < ends) {
    for (const auto& [way, attacker] : attackers) attacker->go_on();
    std::this_thread::sleep_for(kBetweenTurns);
  }
  for (const auto& [way, count] : kinds) {
    std::uint64_t connections = 0;
    std::uint64_t bytes = 0;
    std::uint64_t refused = 0;
    for (const auto& [which, attacker] : attackers) {
      if (which != &way) continue;
      connections += attacker->connections;
      bytes += attacker->bytes;
      refused += attacker->refused;
    }
    std::printf("%3d %-34s %9llu connections, %9.1f MB sent, %llu not connected\n", count, way.name.c_str(),
                static_cast<unsigned long long>(connections), static_cast<double>(bytes) / 1e6,
                static_cast<unsigned long long>(refused));
  }
  return 0;
}
