// Command line of talus-client.
#pragma once

#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "command_line/parse.h"
#include "commands.h"

namespace talus::cli {

struct CommandLine {
  ConnectTarget target;
  std::variant<GetOptions, AtOptions, FlyOptions, MapOptions, EditOptions> options;
};

/// `version`: what --version prints.
[[nodiscard]] tl::expected<CommandLine, command_line::Exit> read_command_line(int argc,
                                                                              const char* const* argv,
                                                                              const std::string& version);

}  // namespace talus::cli
