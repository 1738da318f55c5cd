// Reading flags, for all commands of talusd.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace talus::server {

/// Text to print and the exit status: for help, version, or an error.
struct Exit {
  std::string text;
  int status = 0;
};

inline constexpr int kFailed = 1;
inline constexpr int kWrongUse = 2;

/// Reads the flags into the variables that `app` knows; else what to print. A wrong flag is one line that
/// begins with the name of `app` and that of its command, where one was given, and exits with kWrongUse.
[[nodiscard]] std::optional<Exit> parse_flags(CLI::App& app, int argc, const char* const* argv);

}  // namespace talus::server
