// talusd's flags.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "config/config.h"
#include "config/load.h"
#include "config/parse_flags.h"

namespace talus::server {

/// What to do, and with what.
struct Command {
  Config config;
  bool check_only = false;
  std::vector<std::string> warnings;
};

/// Reads flags, environment and file. Wrong flags exit with 2, a wrong file or variable with 1.
[[nodiscard]] tl::expected<Command, Exit> read_command_line(int argc, const char* const* argv,
                                                            const Environment& environment);

}  // namespace talus::server
