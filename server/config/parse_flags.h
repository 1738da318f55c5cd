// What all of talusd's commands do with their flags.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace talus::server {

/// Text to print and the status to exit with: help, version, or an error.
struct Exit {
  std::string text;
  int status = 0;
};

inline constexpr int kFailed = 1;
inline constexpr int kWrongUse = 2;

/// Reads the flags into what `app` was told; else what to print. A wrong flag is one line with the name,
/// which `app` must have, and exits with kWrongUse.
[[nodiscard]] std::optional<Exit> parse_flags(CLI::App& app, int argc, const char* const* argv);

}  // namespace talus::server
