// Command line of talus-client.
#pragma once

#include <variant>

#include <tl/expected.hpp>

#include "command_line/parse.h"
#include "commands.h"

namespace talus::cli {

struct CommandLine {
  Connecting connecting;
  std::variant<GetOptions, AtOptions, FlyOptions, MapOptions, EditOptions> options;
};

[[nodiscard]] tl::expected<CommandLine, command_line::Exit> read_command_line(int argc,
                                                                              const char* const* argv);

}  // namespace talus::cli
