// A stream leader's answer to a request for one message ($JS.API.STREAM.MSG.GET). Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/jetstream/stream_info.h"

namespace talus::server::jetstream {

struct StoredMessage {
  std::uint64_t sequence = 0;
  std::vector<std::byte> bytes;
  std::int64_t time_ns = 0;  // since 1970, when the leader took it
};

/// The error is kMessageNotFound if the stream lacks the message.
[[nodiscard]] tl::expected<StoredMessage, ApiError> parse_stored_message(std::string_view text);

}  // namespace talus::server::jetstream
