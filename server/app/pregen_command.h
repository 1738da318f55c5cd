// "talusd pregen": fills the disk cache with land around a place, using the server that uses the data
// directory, or by itself if no server does.
#pragma once

#include "config/load.h"

namespace talus::server {

/// Runs the command and prints its output; `argv[0]` is "pregen". Returns the exit status.
[[nodiscard]] int pregen_command(int argc, const char* const* argv, const Environment& environment);

}  // namespace talus::server
