// Flag parsing for all commands of talusd.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace talus::server {

/// Text to print and exit status: for help, version, or an error.
struct Exit {
  std::string text;
  int status = 0;
};

inline constexpr int kFailed = 1;
inline constexpr int kWrongUse = 2;

/// Parses the flags into the variables bound to `app`; returns what to print if parsing stops. An error is
/// one line that begins with the name of `app` and its subcommand, if given, and exits with kWrongUse.
[[nodiscard]] std::optional<Exit> parse_flags(CLI::App& app, int argc, const char* const* argv);

}  // namespace talus::server
