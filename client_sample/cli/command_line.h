// What the words after "talus-client" ask for.
#pragma once

#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "commands.h"

namespace talus::cli {

struct CommandLine {
  Connecting connecting;
  std::variant<GetOptions, FlyOptions, MapOptions> options;
};

/// The end of a program that has nothing to do: help or a version with status 0, one line with status 2.
struct Exit {
  int status = 0;
  std::string text;
};

[[nodiscard]] tl::expected<CommandLine, Exit> read_command_line(int argc, const char* const* argv);

}  // namespace talus::cli
