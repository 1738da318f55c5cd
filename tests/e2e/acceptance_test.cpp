// What users rely on: the world is one, whichever program or connection shows a piece of it.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/codec.h>

#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "served_world.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

#ifdef TALUS_CLIENT_PATH
namespace {

/// The data of a .npy file of bytes, without its header.
std::string npy_bytes(const std::filesystem::path& path) {
  std::ifstream in{path, std::ios::binary};
  std::string file{std::istreambuf_iterator<char>{in}, {}};
  REQUIRE(file.size() > 10);
  const auto low = static_cast<unsigned char>(file[8]);
  const auto high = static_cast<unsigned char>(file[9]);
  const std::size_t begin = std::size_t{10} + low + (std::size_t{high} << 8U);
  REQUIRE(file.size() >= begin);
  REQUIRE(file.substr(0, begin).find("'|u1'") != std::string::npos);
  return file.substr(begin);
}

void run_well(const std::string& path, const std::vector<std::string>& flags) {
  const ProgramResult ended = run_program(path, flags);
  INFO(path << ": " << ended.err);
  REQUIRE(ended.status == 0);
}

/// The 32 rows of a chunk in an export that begins at y = 0 and ends at the highest boundary.
std::string rows_of_chunk(const std::string& exported, std::int32_t chunk_y) {
  REQUIRE(exported.size() % kChunkArea == 0);
  const std::size_t begin = std::min(exported.size(), static_cast<std::size_t>(chunk_y) * kChunkVolume);
  std::string rows = exported.substr(begin, kChunkVolume);
  rows.resize(kChunkVolume, '\0');
  return rows;
}

}  // namespace

TEST_CASE("talus-client gets the voxels that talus-gen exports, also at the world's ends") {
  const ServerProcess server;
  const ScratchDirectory scratch;
  const std::string client_file = (scratch / "chunk.npy").string();
  const std::string export_folder = (scratch / "export").string();
  constexpr std::int32_t kLast = 2147483647;
  constexpr std::int32_t kFirst = -kLast - 1;
  const std::array<ChunkCoord, 6> chunks{{{0, 0, 0},
                                          {-1, 1, -1},
                                          {12345, 0, -54321},
                                          {kLast, 0, kLast},
                                          {kFirst, 0, kFirst},
                                          {kLast, 1, kFirst}}};
  for (const ChunkCoord chunk : chunks) {
    CAPTURE(to_string(chunk));
    run_well(TALUS_CLIENT_PATH,
             {"--connect", "127.0.0.1:" + std::to_string(server.port()), "get", std::to_string(chunk.x),
              std::to_string(chunk.y), std::to_string(chunk.z), "-o", client_file});
    const VoxelPos origin = chunk_origin(chunk);
    std::vector<std::string> exporting{
        "export", "--origin",   std::to_string(origin.x) + ',' + std::to_string(origin.z), "--size", "32,32",
        "-o",     export_folder};
    if (kSanitized) exporting.insert(exporting.end(), {"--world", kClassicWorld.second});
    run_well(TALUS_GEN_PATH, exporting);
    const std::string fetched = npy_bytes(client_file);
    const std::string exported = npy_bytes(std::filesystem::path{export_folder} / "voxels.npy");
    REQUIRE(fetched.size() == std::size_t{kChunkVolume});
    const bool same = fetched == rows_of_chunk(exported, chunk.y);
    CHECK(same);
  }
}
#endif

namespace {

std::uint64_t seed_from_environment() {
  const char* text = std::getenv("TALUS_SEED");
  return text == nullptr ? 20'240'229 : std::strtoull(text, nullptr, 10);
}

/// Two tiles side by side and what lies in both, from one generation over both.
struct Pair {
  ChunkCoord first;
  ChunkCoord second;
  terrain::Stacks stacks;
};

/// The western or northern tile of a pair: near 0, anywhere, or near an end of the level.
std::int32_t random_tile(std::mt19937_64& random, Lod lod) {
  const std::int64_t limit = chunk_limit(lod);
  const auto between = [&](std::int64_t low, std::int64_t high) {
    return static_cast<std::int32_t>(std::uniform_int_distribution<std::int64_t>{low, high}(random));
  };
  switch (random() % 4) {
    case 0:
      return between(-3, 3);
    case 1:
      return between(-limit, limit - 2);
    case 2:
      return between(-limit, -limit + 3);
    default:
      return between(limit - 5, limit - 2);
  }
}

Pair random_pair(std::mt19937_64& random) {
  const Lod lod = Lod::of(static_cast<int>(random() % 4));
  const ChunkCoord first{random_tile(random, lod), 0, random_tile(random, lod)};
  const bool along_x = random() % 2 == 0;
  const ChunkCoord second =
      along_x ? ChunkCoord{first.x + 1, 0, first.z} : ChunkCoord{first.x, 0, first.z + 1};
  const VoxelPos origin = chunk_origin(first);
  const terrain::Region both{origin.x, origin.z, along_x ? 2 * kChunkSize : kChunkSize,
                             along_x ? kChunkSize : 2 * kChunkSize, lod};
  return {first, second, terrain::generate_stacks(served_world(), both)};
}

struct WantedChunk {
  ChunkKey key;
  std::size_t pair = 0;
  std::size_t connection = 0;
};

/// Every chunk of the pair that is not uniform in both tiles, the tiles by different connections.
void add_wanted(std::vector<WantedChunk>& wanted, const Pair& pair, std::size_t index,
                std::size_t connection) {
  const terrain::World& world = served_world();
  const auto first_rows = mixed_range(world, pair.stacks, pair.first.x, pair.first.z);
  const auto second_rows = mixed_range(world, pair.stacks, pair.second.x, pair.second.z);
  const std::int32_t highest = std::max(first_rows.last, second_rows.last);
  for (std::int32_t y = std::min(first_rows.first, second_rows.first); y <= highest; ++y) {
    const Lod lod = pair.stacks.region.lod;
    wanted.push_back({{{pair.first.x, y, pair.first.z}, lod}, index, connection});
    wanted.push_back({{{pair.second.x, y, pair.second.z}, lod}, index, 1 - connection});
  }
}

class Fetcher {
 public:
  explicit Fetcher(std::uint16_t port) : clients_{greeted(port), greeted(port)} {}

  void ask(std::uint32_t id, const WantedChunk& wanted) {
    REQUIRE(clients_.at(wanted.connection).send(get_chunks({chunk_request(id, wanted.key)})));
  }

  /// The next chunk on a connection, which must have the id of something asked there.
  std::pair<std::uint32_t, Chunk> next(std::size_t connection, const std::vector<WantedChunk>& wanted) {
    const ReceivedFrame received = clients_.at(connection).expect();
    auto& bytes = received_bytes_.at(connection);
    bytes += received.bytes();
    REQUIRE(clients_.at(connection).send(credit(bytes)));
    const auto& chunk = received.as<wire::Chunk>();
    REQUIRE(chunk.id() >= 1);
    const WantedChunk& answered = wanted.at(chunk.id() - 1);
    REQUIRE(answered.connection == connection);
    REQUIRE(key_of(*chunk.key()) == answered.key);
    auto decoded = decode(std::as_bytes(std::span{chunk.payload()->data(), chunk.payload()->size()}));
    REQUIRE(decoded.has_value());
    return {chunk.id(), *std::move(decoded)};
  }

 private:
  std::array<RawClient, 2> clients_;
  std::array<std::uint64_t, 2> received_bytes_{};
};

}  // namespace

TEST_CASE(
    "neighbouring chunks from two connections continue each other's surface, layers and loose material") {
  const std::uint64_t seed = seed_from_environment();
  INFO("TALUS_SEED=" << seed);
  std::mt19937_64 random{seed};
  std::vector<Pair> pairs;
  std::vector<WantedChunk> wanted;
  for (std::size_t index = 0; index < 200; ++index) {
    pairs.push_back(random_pair(random));
    add_wanted(wanted, pairs.back(), index, random() % 2);
  }
  REQUIRE(wanted.size() >= 2 * pairs.size());
  std::shuffle(wanted.begin(), wanted.end(), random);

  const ServerProcess server;
  Fetcher fetcher{server.port()};
  constexpr std::size_t kAskedAtOnce = 128;  // far fewer than a connection may have in flight
  std::vector<bool> answered(wanted.size(), false);
  for (std::size_t begin = 0; begin < wanted.size(); begin += kAskedAtOnce) {
    const std::size_t end = std::min(wanted.size(), begin + kAskedAtOnce);
    for (std::size_t i = begin; i < end; ++i) fetcher.ask(static_cast<std::uint32_t>(i + 1), wanted[i]);
    for (std::size_t i = begin; i < end; ++i) {
      const auto [id, chunk] = fetcher.next(wanted[i].connection, wanted);
      const WantedChunk& got = wanted[id - 1];
      CAPTURE(to_string(got.key));
      REQUIRE_FALSE(answered[id - 1]);
      answered[id - 1] = true;
      const bool same = chunk == extract_chunk(served_world(), pairs[got.pair].stacks, got.key.coord);
      REQUIRE(same);
    }
  }
}
