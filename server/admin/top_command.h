// "talusd top": shows the flows that use most of a running server, read from its operators' port.
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
  std::chrono::seconds interval{2};  // between refreshes, on a terminal
};

/// If the flags do not name an address, uses the one of the configuration file or the environment.
[[nodiscard]] tl::expected<TopCommand, Exit> read_top_command(int argc, const char* const* argv,
                                                              const Environment& environment);

/// Resolves a host to its addresses; sets `failed` if that fails. Called on a thread that may outlive the
/// caller.
using Resolve =
    std::function<std::vector<asio::ip::tcp::endpoint>(const protocol::Endpoint&, std::error_code&)>;
[[nodiscard]] std::vector<asio::ip::tcp::endpoint> resolve_by_system(const protocol::Endpoint& host,
                                                                     std::error_code& failed);

/// A server's answer to a request for an operators' page.
struct Page {
  int status = 0;
  std::string text;  // printable
};
/// Returns a page of any status. Waits at most `patience`, including name resolution, and reads at most 1
/// MiB. An error is one line: no answer, or not from a talusd.
[[nodiscard]] tl::expected<Page, std::string> fetch_any_page(
    const protocol::Endpoint& admin, std::string_view path,
    std::chrono::milliseconds patience = std::chrono::seconds{5}, Resolve resolve = resolve_by_system);

/// Fetches a page such as "/metrics" as printable text. Waits at most `patience`, including name resolution,
/// and reads at most 1 MiB. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> fetch_page(
    const protocol::Endpoint& admin, std::string_view path,
    std::chrono::milliseconds patience = std::chrono::seconds{5}, Resolve resolve = resolve_by_system);

/// Fetches the page /flows.
[[nodiscard]] inline tl::expected<std::string, std::string> fetch_flows(
    const protocol::Endpoint& admin, std::chrono::milliseconds patience = std::chrono::seconds{5},
    Resolve resolve = resolve_by_system) {
  return fetch_page(admin, "/flows", patience, std::move(resolve));
}

}  // namespace talus::server
