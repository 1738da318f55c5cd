#include "peer.h"

#include <chrono>
#include <exception>

#include <asio/co_spawn.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>

namespace talus::client::testing {

Peer::Peer(asio::io_context& io)
    : acceptor_{io, asio::ip::tcp::endpoint{asio::ip::address_v4::loopback(), 0}}, socket_{io} {}

std::string Peer::port() const {
  return std::to_string(acceptor_.local_endpoint().port());
}

asio::awaitable<void> Peer::accept() {
  socket_ = co_await acceptor_.async_accept(asio::use_awaitable);
  socket_.set_option(asio::ip::tcp::no_delay{true});
  reader_ = protocol::FrameReader{protocol::kMaxFrameBytes};
  unread_ = {};
}

asio::awaitable<const wire::Message*> Peer::receive() {
  if (reader_.has_frame()) reader_.pop();
  while (true) {
    unread_ = unread_.subspan(reader_.feed(unread_).value());
    if (reader_.has_frame()) co_return protocol::read_message(reader_.frame()).value();
    const auto count = co_await socket_.async_read_some(asio::buffer(buffer_), asio::use_awaitable);
    unread_ = std::span{buffer_}.first(count);
  }
}

asio::awaitable<void> Peer::send(protocol::Frame frame) {
  co_await asio::async_write(socket_, asio::buffer(frame.data(), frame.size()), asio::use_awaitable);
}

asio::awaitable<void> Peer::send_bytes(std::string bytes) {
  co_await asio::async_write(socket_, asio::buffer(bytes), asio::use_awaitable);
}

asio::awaitable<void> Peer::welcome(std::uint64_t fingerprint, std::uint64_t window_bytes,
                                    std::uint32_t requests_in_flight, std::uint32_t idle_timeout_ms,
                                    std::optional<Rates> rates, WelcomeMore more) {
  co_await accept();
  const auto* hello = co_await receive();
  REQUIRE(hello->body_type() == wire::Body::Hello);
  co_await send(welcome_frame(fingerprint, window_bytes, requests_in_flight, idle_timeout_ms, rates, more));
}

asio::awaitable<void> Peer::until_closed() {
  try {
    while (true) (void)co_await receive();
  } catch (const std::system_error&) {
    // What it waited for.
  }
}

void Peer::hang_up() {
  socket_.close();
}

void Peer::stop_listening() {
  acceptor_.close();
}

asio::awaitable<void> join(Client& client, const Peer& peer) {
  const auto world = co_await client.connect("127.0.0.1", peer.port());
  if (!world) FAIL(world.error().message);
}

void run(asio::io_context& io, const std::vector<Script>& scripts) {
  std::size_t ended = 0;
  std::exception_ptr failure;
  for (const auto& script : scripts) {
    asio::co_spawn(io, script, [&](std::exception_ptr thrown) {
      ++ended;
      if (thrown && !failure) failure = thrown;
      if (thrown || ended == scripts.size()) io.stop();
    });
  }
  io.run_for(std::chrono::seconds{10});
  if (failure) std::rethrow_exception(failure);
  REQUIRE(ended == scripts.size());
}

ChunkKey key_at(int x, int y, int z, int lod) {
  return {{x, y, z}, Lod::of(lod)};
}

Chunk some_chunk(const ChunkKey& key) {
  Layers layers;
  layers.materials = {MaterialId{2}, MaterialId{3}, kAir};
  for (int plane = 0; plane < 2; ++plane) {
    for (int column = 0; column < kChunkArea; ++column) {
      const auto low =
          static_cast<std::uint8_t>(std::hash<ChunkKey>{}(key) % 7 + static_cast<unsigned>(column % 5));
      layers.tops.push_back(static_cast<std::uint8_t>(low + plane * 9));
    }
  }
  return Chunk::from_layers(std::move(layers));
}

protocol::Frame welcome_frame(std::uint64_t fingerprint, std::uint64_t window_bytes,
                              std::uint32_t requests_in_flight, std::uint32_t idle_timeout_ms,
                              std::optional<Rates> session_rates, WelcomeMore more) {
  return protocol::make_frame([&](auto& b) {
    const auto material = [&](std::uint16_t id, const char* name, wire::Phase phase) {
      return wire::CreateMaterial(b, id, b.CreateString(name), 0x808080, phase);
    };
    const std::vector materials{
        material(0, "air", wire::Phase::gas), material(1, "water", wire::Phase::liquid),
        material(2, "granite", wire::Phase::solid), material(3, "grass", wire::Phase::solid)};
    const auto material_list = b.CreateVector(materials);
    flatbuffers::Offset<wire::Rates> rates;
    if (session_rates) {
      rates = wire::CreateRates(b, session_rates->chunks, session_rates->bytes, session_rates->requests,
                                static_cast<std::uint32_t>(session_rates->burst.count()));
    }
    const auto limits =
        wire::CreateLimits(b, 65536, requests_in_flight, more.heights_per_request, 32, 16, 65536,
                           window_bytes, idle_timeout_ms, rates, 0, more.view_horizon, more.view_base);
    const wire::Hash128 world{fingerprint, 0};
    const wire::Hash128 store{more.store_id, 7};
    const wire::Voxel spawn{8, 70, -8};
    const auto server = b.CreateString("a test");
    const auto looks = b.CreateVectorOfStrings({"", "snow"});
    const auto fields = b.CreateVectorOfStrings({"temperature", "moisture"});
    return wire::CreateWelcome(b, protocol::kProtocolVersion, kCodecVersion, &world, &store, 32,
                               material_list, 0, more.max_y, &spawn, limits, server, looks, fields);
  });
}

protocol::Frame chunk_frame(std::uint32_t id, const ChunkKey& key, const Chunk& chunk,
                            std::uint64_t revision) {
  std::vector<std::byte> payload;
  encode(chunk, payload);
  return chunk_frame(id, key, content_hash(chunk), payload, revision);
}

protocol::Frame chunk_frame(std::uint32_t id, const ChunkKey& key, ContentHash hash,
                            const std::vector<std::byte>& payload, std::uint64_t revision) {
  return protocol::make_frame([&](auto& b) {
    const wire::ChunkKey wire_key{key.coord.x, key.coord.y, key.coord.z,
                                  static_cast<std::uint8_t>(key.lod.value())};
    const wire::Hash128 wire_hash{hash.low, hash.high};
    const auto bytes = b.CreateVector(reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size());
    return wire::CreateChunk(b, id, &wire_key, revision, &wire_hash, kCodecVersion, bytes);
  });
}

protocol::Frame error_frame(wire::ErrorCode code, const std::string& text, std::uint32_t id) {
  const auto about = id == 0 ? wire::ErrorAbout::connection : wire::ErrorAbout::request;
  return protocol::make_frame(
      [&](auto& b) { return wire::CreateError(b, code, b.CreateString(text), id, 0, about); });
}

protocol::Frame refusal_frame(wire::ErrorAbout about, std::uint32_t id_or_number,
                              std::chrono::milliseconds retry_after) {
  return protocol::make_frame([&](auto& b) {
    const bool request = about == wire::ErrorAbout::request;
    return wire::CreateError(b, wire::ErrorCode::overloaded, b.CreateString("over a rate"),
                             request ? id_or_number : 0, static_cast<std::uint32_t>(retry_after.count()),
                             about, 0, request ? 0 : id_or_number);
  });
}

protocol::Frame complete_frame(std::uint32_t number) {
  return protocol::make_frame([&](auto& b) { return wire::CreateViewComplete(b, number); });
}

}  // namespace talus::client::testing
