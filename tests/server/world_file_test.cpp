// What talusd says of a world that it cannot read.
#include "app/world_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include <talus/toml/toml_bounds.h>

#include "scratch_directory.h"

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
