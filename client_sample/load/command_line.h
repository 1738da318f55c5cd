// talus-load's command line.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "options.h"

namespace talus::load {

/// The end of a program that has nothing to do: help or a version with status 0, one line with status 2.
struct Exit {
  int status = 0;
  std::string text;
};

[[nodiscard]] tl::expected<Options, Exit> read_command_line(int argc, const char* const* argv);

}  // namespace talus::load
