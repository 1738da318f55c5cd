// talus-client without main(), so that main.cpp does not include Asio.
#pragma once

namespace talus::cli {

/// Runs the command line, prints the result, and returns the exit status.
[[nodiscard]] int run_program(int argc, const char* const* argv);

}  // namespace talus::cli
