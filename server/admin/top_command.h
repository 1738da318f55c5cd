// "talusd top": shows which flows use most of a running server, by asking its operators' port.
#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include "config/load.h"
#include "config/parse_flags.h"

namespace talus::server {

struct TopCommand {
  protocol::Endpoint admin;
  std::chrono::seconds interval{2};  // between looks, on a terminal
};

/// Where the flags name no address it is that of the file, or of the environment.
[[nodiscard]] tl::expected<TopCommand, Exit> read_top_command(int argc, const char* const* argv,
                                                              const Environment& environment);

/// The page /flows of the server there, of printable text whoever answers. Waits for at most 5 s, and takes
/// at most 1 MiB. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> fetch_flows(const protocol::Endpoint& admin);

}  // namespace talus::server
