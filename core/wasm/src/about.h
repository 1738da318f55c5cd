// What a host reads of an open world.
#pragma once

#include <string>

#include <talus/terrain/world.h>

namespace talus::wasm {

/// JSON: the fields of class World in client_sample/web/talus-js/wasm/world.d.ts.
[[nodiscard]] std::string about(const terrain::World& world);

}  // namespace talus::wasm
