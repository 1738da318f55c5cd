// talus-client without main(), so that main.cpp does not include Asio.
#pragma once

#include <string>

namespace talus::cli {

/// Runs the command line, prints the result, and returns the exit status. `version`: what --version prints.
[[nodiscard]] int run_program(int argc, const char* const* argv, const std::string& version);

}  // namespace talus::cli
