// A published world: what a client needs to make its chunks, and what it is sent then.
#include <string>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>
#include <talus/world_files/world_files.h>

#include "http_client.h"
#include "messages.h"
#include "player.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"
#include "world_of_a_map.h"

using namespace talus;
using namespace talus::e2e;

namespace {

/// A file of the world, in parts.
std::string fetched(RawClient& client, const std::string& name) {
  std::string whole;
  for (std::uint32_t id = 1;; ++id) {
    client.send(get_file(id, name, whole.size()));
    const ReceivedFrame received = client.expect();
    const auto& part = received.as<wire::FilePart>();
    CHECK(part.id() == id);
    whole.append(part.bytes()->begin(), part.bytes()->end());
    if (whole.size() == part.size()) return whole;
    REQUIRE(part.bytes()->size() == protocol::kMaxFilePartBytes);
  }
}

Settings editable(const std::filesystem::path& data) {
  return {kClassicWorld,
          {"TALUS_DATA", data.string()},
          {"TALUS_PUBLISH", "public"},
          {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}};
}

}  // namespace

TEST_CASE("a world is made again of what a server gives of it, by HTTP and on the stream") {
  const ScratchDirectory scratch;
  const std::string spec = write_world_of_a_map(scratch, 300);
  ServerProcess server{{{"TALUS_WORLD", spec}, {"TALUS_PUBLISH", "public"}}, kWithHttp};
  RawClient client{server.port()};
  client.send(hello());
  const ReceivedFrame received = client.expect();
  const auto& welcome = received.as<wire::Welcome>();
  REQUIRE(welcome.limits()->view_base());

  HttpClient http{server.http_port()};
  const std::string toml = http.get(welcome.world_file()->str()).body;
  CHECK(toml == read_whole(spec));
  CHECK(fetched(client, "") == toml);
  const std::string map = fetched(client, "heights.npy");
  CHECK(map == read_whole(scratch / "heights.npy"));
  std::string beside = welcome.world_file()->str();
  beside.replace(beside.rfind('/'), std::string::npos, "/files/heights.npy");
  CHECK(http.get(beside).body == map);

  const auto world = terrain::World::parse(toml, "world.toml", [&](const std::string&) {
    return world_files::decode_height_map(std::as_bytes(std::span{map}));
  });
  REQUIRE(world.has_value());
  CHECK(world->fingerprint() == hash_of(*welcome.fingerprint()));
}

TEST_CASE("a client that makes chunks is sent what players dig and build, before and after a restart") {
  const ScratchDirectory scratch;
  ViewFields own{.horizontal_radius = 2, .vertical_radius = 2, .number = 1, .has_base = true};
  ChunkKey edited;
  std::uint64_t revision = 0;
  {
    ServerProcess server{editable(scratch / "data"), kWithHttp};
    Player digger;
    const auto world = digger.connect(server.port());
    REQUIRE(world.has_value());
    own.centre = world->spawn;
    RawClient client = greeted(server.port());
    client.send(view(own));
    CHECK(client.expect_kind<wire::ViewComplete>().as<wire::ViewComplete>().number() == 1);

    const VoxelPos below{world->spawn.x, world->spawn.y - 1, world->spawn.z};
    const auto done = digger.put(below, kAir);
    REQUIRE(done.has_value());
    revision = done->revision;
    const ReceivedFrame received = client.expect();
    const auto& broadcast = received.as<wire::EditBroadcast>();
    CHECK(broadcast.previous_revision() == 0);
    CHECK(broadcast.revision() == revision);
    edited = key_of(*broadcast.key());
    // One who comes later gets the same, and nothing else.
    RawClient late = greeted(server.port());
    late.send(view(own));
    CHECK(key_of(*late.expect_kind<wire::EditBroadcast>().as<wire::EditBroadcast>().key()) == edited);
    (void)late.expect_kind<wire::ViewComplete>();
  }
  const ServerProcess again{editable(scratch / "data")};
  RawClient client = greeted(again.port());
  client.send(view(own));
  const ReceivedFrame received = client.expect();
  const auto& chunk = received.as<wire::Chunk>();  // voxels are remembered in memory alone
  CHECK(key_of(*chunk.key()) == edited);
  CHECK(chunk.revision() == revision);
  (void)client.expect_kind<wire::ViewComplete>();

  // Its proof of a chunk that it made: the server's own is the same.
  ChunkKey other = edited;
  other.coord.y -= 1;
  client.send(get_chunks({chunk_request(1, other)}));
  const ContentHash hash = hash_of(*client.expect_kind<wire::Chunk>().as<wire::Chunk>().hash());
  client.send(get_chunks({chunk_request(2, other, hash)}));
  CHECK(client.expect_kind<wire::Unchanged>().as<wire::Unchanged>().revision() == 0);
}
