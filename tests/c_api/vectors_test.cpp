// core/voxel/vectors/payloads.txt through libtalus: from a server's bytes into a caller's buffer.
#include <charconv>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>

#include <talus/voxel/content_hash.h>

#include "peer.h"
#include "test_client.h"

namespace talus::c_api {
namespace {

using namespace testing;

struct Vector {
  bool is_chunk = false;
  std::string name;
  std::string expected;  // a chunk's hash, or the error's name
  std::vector<std::byte> payload;
};

template <typename Number>
Number from_hex(std::string_view digits) {
  Number number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  REQUIRE(error == std::errc{});
  REQUIRE(end == digits.data() + digits.size());
  return number;
}

std::vector<Vector> vectors() {
  std::ifstream file{TALUS_SOURCE_DIR "/core/voxel/vectors/payloads.txt"};
  std::vector<Vector> all;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words{line};
    Vector& vector = all.emplace_back();
    std::string kind;
    std::string hex;
    REQUIRE(words >> kind >> vector.name >> vector.expected >> hex);
    vector.is_chunk = kind == "chunk";
    if (hex == "-") hex.clear();
    for (std::size_t i = 0; i < hex.size(); i += 2) {
      vector.payload.push_back(std::byte{from_hex<std::uint8_t>(std::string_view{hex}.substr(i, 2))});
    }
  }
  return all;
}

ContentHash hash_of(const Vector& vector) {
  if (!vector.is_chunk) return {};
  const std::string_view digits = vector.expected;
  return {from_hex<std::uint64_t>(digits.substr(16)), from_hex<std::uint64_t>(digits.substr(0, 16))};
}

std::string hash_of(const Voxels& voxels) {
  const auto dense = std::make_unique<DenseVoxels>();
  for (std::size_t i = 0; i < voxels.size(); ++i) (*dense)[i] = MaterialId{voxels[i]};
  return to_string(content_hash(Chunk::from_dense(*dense)));
}

}  // namespace

TEST_CASE("talus_decode writes every payload vector's voxels, and reports invalid payloads as bad chunks") {
  const std::vector<Vector> all = vectors();
  REQUIRE(all.size() > 25);
  asio::io_context io;
  client::testing::Peer peer{io};
  const auto serve = [&]() -> asio::awaitable<void> {
    co_await peer.welcome();
    for (const Vector& vector : all) {
      const wire::ChunkRequest* asked = (co_await peer.receive())->body_as_GetChunks()->requests()->Get(0);
      co_await peer.send(
          client::testing::chunk_frame(asked->id(), ChunkKey{}, hash_of(vector), vector.payload));
    }
    co_await peer.until_closed();
  };
  asio::co_spawn(io, serve, asio::detached);
  const auto meanwhile = [&] { (void)io.poll(); };
  TestClient client;
  client.connect(static_cast<std::uint16_t>(std::stoi(peer.port())));
  (void)client.await(TALUS_EVENT_JOINED, {}, meanwhile);
  for (const Vector& vector : all) {
    CAPTURE(vector.name);
    REQUIRE(talus_get_chunk(client.get(), 0, 0, 0, 0, nullptr, nullptr) == TALUS_OK);
    const talus_event event = client.await(TALUS_EVENT_CHUNK_ANSWER, {}, meanwhile);
    CHECK(event.status == (vector.is_chunk ? TALUS_OK : TALUS_BAD_CHUNK));
    REQUIRE((event.chunk != nullptr) == vector.is_chunk);
    if (vector.is_chunk) CHECK(hash_of(decode(event.chunk)) == vector.expected);
  }
}

}  // namespace talus::c_api
