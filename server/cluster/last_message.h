// Whether a stream still has the message that a store applied last: one that lost its end and went on has
// another in its place.
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::cluster {

enum class LastMessage : std::uint8_t {
  as_applied,
  other,     // as some replica says: one that went wrong may contradict all others
  not_kept,  // the stream is longer, and begins behind it: nobody can tell
};

/// REQUIRES: `place` is of this stream, which has as many messages at least. Waits about half a second at
/// most, as LogStream::next(), which goes on from anywhere after it.
[[nodiscard]] tl::expected<LastMessage, StreamFailure> compare_last_message(LogStream& stream,
                                                                            const StreamState& state,
                                                                            const store::StreamPlace& place);

}  // namespace talus::server::cluster
