// "talusd top": shows which flows use most of a running server, by asking its operators' port.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/ip/tcp.hpp>
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

/// The addresses of a host, and what was wrong where it has none. Called on a thread of its own, which may
/// outlive the caller.
using Resolve =
    std::function<std::vector<asio::ip::tcp::endpoint>(const protocol::Endpoint&, std::error_code&)>;
[[nodiscard]] std::vector<asio::ip::tcp::endpoint> resolve_by_system(const protocol::Endpoint& host,
                                                                     std::error_code& failed);

/// What a server answers to a request for one of its operators' pages.
struct Page {
  int status = 0;
  std::string text;  // printable
};
/// Whatever the status. Waits for `patience` at most, also for names, and takes at most 1 MiB. An error is
/// one line: nothing, or no page of a talusd's, came.
[[nodiscard]] tl::expected<Page, std::string> fetch_any_page(
    const protocol::Endpoint& admin, std::string_view path,
    std::chrono::milliseconds patience = std::chrono::seconds{5}, Resolve resolve = resolve_by_system);

/// A page of the server there, such as "/metrics", of printable text whoever answers. Waits for `patience` at
/// most, also for names, and takes at most 1 MiB. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> fetch_page(
    const protocol::Endpoint& admin, std::string_view path,
    std::chrono::milliseconds patience = std::chrono::seconds{5}, Resolve resolve = resolve_by_system);

/// The page /flows.
[[nodiscard]] inline tl::expected<std::string, std::string> fetch_flows(
    const protocol::Endpoint& admin, std::chrono::milliseconds patience = std::chrono::seconds{5},
    Resolve resolve = resolve_by_system) {
  return fetch_page(admin, "/flows", patience, std::move(resolve));
}

}  // namespace talus::server
