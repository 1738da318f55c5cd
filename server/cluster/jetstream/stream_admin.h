// Making the stream of a store, and asking what it is like.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"

namespace talus::server::jetstream {

/// Why there is no answer: the way there, or what JetStream says.
using StreamError = std::variant<StreamFailure, ApiError>;

[[nodiscard]] StreamFailure failure_of(const StreamError& error, const StreamNames& names);

/// What the stream's leader says. Waits half a second at most.
[[nodiscard]] tl::expected<StreamInfo, StreamError> ask_stream_info(Connection& connection,
                                                                    const StreamNames& names);

/// Makes a stream that is not there yet, as stream_settings.h has it; waits until it has a leader.
[[nodiscard]] tl::expected<StreamInfo, StreamError> make_stream(Connection& connection,
                                                                const StreamNames& names,
                                                                std::uint64_t replicas);

struct PresentStream {
  StreamInfo info;
  bool made = false;  // now
};
/// Makes the stream where there is none; one that is there must have the settings. Waits up to 15 s for
/// servers that have just started. An error is one line.
[[nodiscard]] tl::expected<PresentStream, std::string> ensure_stream(Connection& connection,
                                                                     const StreamNames& names,
                                                                     std::uint64_t replicas);

}  // namespace talus::server::jetstream
