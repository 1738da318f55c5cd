// Command line of talus-load.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "command_line/parse.h"
#include "options.h"

namespace talus::load {

/// `version`: what --version prints.
[[nodiscard]] tl::expected<Options, command_line::Exit> read_command_line(int argc, const char* const* argv,
                                                                          const std::string& version);

}  // namespace talus::load
