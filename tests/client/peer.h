// A server that a test writes down word by word, on a real socket in the test's own io_context.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>

#include <talus/client/client.h>
#include <talus/protocol/frame.h>
#include <talus/protocol/message.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::client::testing {

/// What few tests need of a Welcome.
struct WelcomeMore {
  bool view_horizon = false;
  std::int64_t max_y = 320;
  std::uint32_t heights_per_request = 2048;
  bool view_base = false;
  std::uint64_t store_id = 7;
};

class Peer {
 public:
  explicit Peer(asio::io_context& io);

  [[nodiscard]] std::string port() const;
  [[nodiscard]] asio::awaitable<void> accept();
  /// The next message, valid until the next call. Throws when the client hangs up.
  [[nodiscard]] asio::awaitable<const wire::Message*> receive();
  [[nodiscard]] asio::awaitable<void> send(protocol::Frame frame);
  /// Bytes that may be no frame.
  [[nodiscard]] asio::awaitable<void> send_bytes(std::string bytes);
  /// accept, take the Hello, answer it.
  [[nodiscard]] asio::awaitable<void> welcome(std::uint64_t fingerprint = 1,
                                              std::uint64_t window_bytes = 1U << 20,
                                              std::uint32_t requests_in_flight = 64,
                                              std::uint32_t idle_timeout_ms = 60'000,
                                              std::optional<Rates> rates = std::nullopt,
                                              WelcomeMore more = {});
  /// Reads until the client closes.
  [[nodiscard]] asio::awaitable<void> until_closed();
  void hang_up();
  /// Ends an accept() by an exception; nobody connects any more.
  void stop_listening();

 private:
  asio::ip::tcp::acceptor acceptor_;
  asio::ip::tcp::socket socket_;
  protocol::FrameReader reader_{protocol::kMaxFrameBytes};
  std::array<std::byte, 4096> buffer_{};
  std::span<const std::byte> unread_;
};

/// The client connects to the peer and is welcomed, or the test fails.
//
// Nothing is awaited inside Catch's macros: g++ 12 loses their temporaries over a suspension.
[[nodiscard]] asio::awaitable<void> join(Client& client, const Peer& peer);

using Script = std::function<asio::awaitable<void>()>;

/// Runs the scripts side by side until all have ended; fails the test if that takes ten seconds. An
/// exception in one fails the test too.
void run(asio::io_context& io, const std::vector<Script>& scripts);

[[nodiscard]] ChunkKey key_at(int x, int y, int z, int lod = 0);
/// A chunk whose voxels depend on the key: layers of three materials.
[[nodiscard]] Chunk some_chunk(const ChunkKey& key);

[[nodiscard]] protocol::Frame welcome_frame(std::uint64_t fingerprint, std::uint64_t window_bytes,
                                            std::uint32_t requests_in_flight, std::uint32_t idle_timeout_ms,
                                            std::optional<Rates> session_rates = std::nullopt,
                                            WelcomeMore more = {});
[[nodiscard]] protocol::Frame chunk_frame(std::uint32_t id, const ChunkKey& key, const Chunk& chunk,
                                          std::uint64_t revision = 0);
/// With any hash and payload.
[[nodiscard]] protocol::Frame chunk_frame(std::uint32_t id, const ChunkKey& key, ContentHash hash,
                                          const std::vector<std::byte>& payload, std::uint64_t revision = 0);
/// About the request `id`, or about the connection if `id` is 0.
[[nodiscard]] protocol::Frame error_frame(wire::ErrorCode code, const std::string& text,
                                          std::uint32_t id = 0);
/// Overloaded, about a request or, with a View's number, about that.
[[nodiscard]] protocol::Frame refusal_frame(wire::ErrorAbout about, std::uint32_t id_or_number,
                                            std::chrono::milliseconds retry_after);
[[nodiscard]] protocol::Frame complete_frame(std::uint32_t number);

}  // namespace talus::client::testing
