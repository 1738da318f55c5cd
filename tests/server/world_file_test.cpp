// What talusd says of a world that it cannot read; what it publishes of one.
#include "app/world_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include <talus/toml/toml_bounds.h>

#include "scratch_directory.h"
#include "world_of_a_map.h"

using namespace talus::server;

TEST_CASE("a file that is not regular is refused as a world, without waiting") {
  const ScratchDirectory scratch;
  const std::filesystem::path pipe = scratch / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::filesystem::path& path : {pipe, scratch.path(), std::filesystem::path{"/dev/zero"}}) {
    CHECK(load_world(path).error() ==
          "world: " + path.string() + ": is not a regular file; give a TOML file that may be read");
  }
}

TEST_CASE("a world that is too large is refused with the limit") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("large.toml", std::string(talus::kMaxTomlBytes + 1, '#'));
  CHECK_THAT(load_world(file).error(), Catch::StartsWith("world: " + file + ": has over 1048576 bytes; "));
}

TEST_CASE("a world is published only if it is to be") {
  Config config;
  CHECK(load_served_world(config)->published == nullptr);
  config.publish = "public";
  const auto served = load_served_world(config);
  REQUIRE(served->published != nullptr);
  CHECK(served->withheld.empty());
  CHECK(*served->published->find("") == talus::terrain::default_world_toml());
  CHECK(served->published->find("world.toml") == nullptr);
  CHECK(served->world->fingerprint() == talus::terrain::default_world().fingerprint());
}

TEST_CASE("a published world has the files that it names, byte by byte") {
  const ScratchDirectory scratch;
  Config config;
  config.world = write_world_of_a_map(scratch, 4);
  config.publish = "public";
  const auto served = load_served_world(config);
  REQUIRE(served.has_value());
  REQUIRE(served->published != nullptr);
  CHECK(*served->published->find("") == read_whole(config.world));
  CHECK(*served->published->find("heights.npy") == read_whole(scratch / "heights.npy"));
  CHECK(served->published->bytes() ==
        read_whole(config.world).size() + read_whole(scratch / "heights.npy").size());
}

TEST_CASE("a large height map is published only with publish_files, and without it nothing is") {
  const ScratchDirectory scratch;
  Config config;
  config.world = write_world_of_a_map(scratch, 725);  // 1 MiB and a little
  config.publish = "public";
  const auto without = load_served_world(config);
  CHECK(without->published == nullptr);
  CHECK(without->withheld == "heights.npy");
  config.publish_files = true;
  const auto with = load_served_world(config);
  REQUIRE(with->published != nullptr);
  CHECK(with->withheld.empty());
  CHECK(with->published->find("heights.npy")->size() == 128 + 2 * 725 * 725);
}
