// talusd as a program: its commands, and its service.
#pragma once

namespace talus::server {

/// main() of talusd: returns the exit status.
[[nodiscard]] int run_program(int argc, char** argv);

}  // namespace talus::server
