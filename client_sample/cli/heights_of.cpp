#include "heights_of.h"

#include <algorithm>

#include <asio/use_awaitable.hpp>

namespace talus::cli {

asio::awaitable<Heights> heights_of(client::Client& client, RequestTimeout& timeout,
                                    std::vector<client::Column> columns, std::size_t at_once) {
  std::vector<std::int32_t> heights;
  std::size_t most = std::clamp<std::size_t>(client.world()->limits.heights_per_request, 1, at_once);
  while (heights.size() < columns.size()) {
    const auto first = columns.begin() + static_cast<std::ptrdiff_t>(heights.size());
    const std::size_t count = std::min(most, columns.size() - heights.size());
    const auto part = co_await client.get_heights({first, first + static_cast<std::ptrdiff_t>(count)});
    if (!part && part.error().kind == client::ErrorKind::out_of_range && count > 1) {
      most = count / 2;  // in eroded land distant columns are expensive, and fewer may fit one request
      continue;
    }
    if (!part) co_return tl::unexpected{part.error()};
    heights.insert(heights.end(), part->begin(), part->end());
    timeout.restart();
  }
  co_return heights;
}

}  // namespace talus::cli
