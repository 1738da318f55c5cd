// Command line of talus-gen.
#pragma once

#include <string>

namespace talus::tools {

/// Runs the command given by the arguments; errors are printed to stderr as one line. Returns the exit code:
/// 0 done, 1 failed, 2 wrong usage.
[[nodiscard]] int run_command_line(int argc, const char* const* argv, const std::string& version);

}  // namespace talus::tools
