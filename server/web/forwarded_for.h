// Finds the client that a proxy forwards for in HTTP. Pure functions.
#pragma once

#include <optional>
#include <string_view>

#include <asio/ip/address.hpp>

#include "config/networks.h"

namespace talus::server::web {

/// Returns the rightmost address of an X-Forwarded-For list that is not one of `proxies`: addresses to its
/// left may be forged by the client. Returns nullopt if there is no such address, or if an invalid one is
/// reached first.
[[nodiscard]] std::optional<asio::ip::address> forwarded_for(std::string_view list, const Networks& proxies);

}  // namespace talus::server::web
