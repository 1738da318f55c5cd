// "talusd pregen": fills the cache on disk with land around a place, by the server that uses the data
// directory, or by itself where none does.
#pragma once

#include "config/load.h"

namespace talus::server {

/// Does what the flags say, and prints; `argv[0]` is "pregen". Returns the exit status.
[[nodiscard]] int pregen_command(int argc, const char* const* argv, const Environment& environment);

}  // namespace talus::server
