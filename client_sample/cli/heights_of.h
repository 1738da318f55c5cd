// Requests heights of more columns than fit one request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <asio/awaitable.hpp>

#include <talus/client/client.h>

#include "request_timeout.h"

namespace talus::cli {

using Heights = client::Result<std::vector<std::int32_t>>;

/// Returns heights of `columns`, in 1/256 voxel, in their order. Requests `at_once` of them, fewer if the
/// server's limit is lower, and half as many after a refusal; each answer restarts the timeout. `client` must
/// be connected; `client` and `timeout` must outlive the call.
[[nodiscard]] asio::awaitable<Heights> heights_of(client::Client& client, RequestTimeout& timeout,
                                                  std::vector<client::Column> columns, std::size_t at_once);

}  // namespace talus::cli
