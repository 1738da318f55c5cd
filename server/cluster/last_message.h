// Checks that a stream still has the message that a store applied last. A stream that lost its end and went
// on has another message in its place.
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::cluster {

enum class LastMessage : std::uint8_t {
  as_applied,
  other,     // according to one replica; a faulty one may contradict all others
  not_kept,  // the stream begins after it, so it cannot be compared
};

/// REQUIRES: `place` is of this stream, which has at least as many messages. Waits at most about half a
/// second, like LogStream::next(), which can continue anywhere afterwards.
[[nodiscard]] tl::expected<LastMessage, StreamFailure> compare_last_message(LogStream& stream,
                                                                            const StreamState& state,
                                                                            const store::StreamPlace& place);

}  // namespace talus::server::cluster
