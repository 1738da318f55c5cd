// For whom a proxy speaks in HTTP. Pure.
#pragma once

#include <optional>
#include <string_view>

#include <asio/ip/address.hpp>

#include "config/networks.h"

namespace talus::server::web {

/// The rightmost address of an X-Forwarded-For list that is none of `proxies`: those to its left the client
/// may have written itself. None where there is no such address, or one before it is no address.
[[nodiscard]] std::optional<asio::ip::address> forwarded_for(std::string_view list, const Networks& proxies);

}  // namespace talus::server::web
