// talus-gen's commands as people type them.
#pragma once

#include <string>

namespace talus::tools {

/// Runs the command that the arguments name; errors go to stderr as one line. Returns the exit code:
/// 0 done, 1 failed, 2 wrong use.
[[nodiscard]] int run_command_line(int argc, const char* const* argv, const std::string& version);

}  // namespace talus::tools
