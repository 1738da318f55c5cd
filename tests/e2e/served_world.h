// The world that a ServerProcess serves unless it is told otherwise.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include <talus/terrain/world.h>

#include "server_process.h"

namespace talus::e2e {

/// The default world; under sanitizers, which would make tests wait for its chunks, the classic one.
[[nodiscard]] inline const terrain::World& served_world() {
  static const terrain::World world = [] {
    if (!kSanitized) return terrain::default_world();
    std::ifstream file{kClassicWorld.second};
    return terrain::World::parse(std::string{std::istreambuf_iterator<char>{file}, {}}, "classic.toml")
        .value();
  }();
  return world;
}

}  // namespace talus::e2e
