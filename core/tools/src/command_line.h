// Command line of talus-gen.
#pragma once

#include <string>

namespace talus::tools {

/// Runs the command given by the arguments. Returns the exit code, as run_program().
[[nodiscard]] int run_talus_gen(int argc, const char* const* argv, const std::string& version);

}  // namespace talus::tools
