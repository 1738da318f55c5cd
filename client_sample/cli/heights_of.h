// Heights of more columns than a server takes in one request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <asio/awaitable.hpp>

#include <talus/client/client.h>

#include "request_timeout.h"

namespace talus::cli {

using Heights = client::Result<std::vector<std::int32_t>>;

/// Heights of `columns`, in 1/256 voxel, in their order. Asks for `at_once` of them, fewer where the server's
/// limit is lower, and half as many wherever it refuses; each answer restarts the timeout. `client`, which
/// has connected, and `timeout` outlive it.
[[nodiscard]] asio::awaitable<Heights> heights_of(client::Client& client, RequestTimeout& timeout,
                                                  std::vector<client::Column> columns, std::size_t at_once);

}  // namespace talus::cli
