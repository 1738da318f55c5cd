// talus-client but for its main(), which needs no header of Asio then.
#pragma once

namespace talus::cli {

/// Does what the command line says, prints what comes of it, and returns the status to exit with.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace talus::cli
