// The command line of talusd.
#pragma once

#include <string_view>

#include <tl/expected.hpp>

#include "config/load.h"
#include "config/parse_flags.h"

namespace talus::server {

/// The settings and the requested action.
struct Command : Settings {
  bool check_only = false;
  bool has_file = false;  // may be reread
};

/// Reads flags, environment and file; `version` is what --version prints. The exit status is kWrongUse for
/// wrong flags, kFailed for a wrong file or variable.
[[nodiscard]] tl::expected<Command, Exit> read_command_line(int argc, const char* const* argv,
                                                            const Environment& environment,
                                                            std::string_view version);

}  // namespace talus::server
