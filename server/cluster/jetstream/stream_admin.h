// Creates and queries the stream of a store.
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"

namespace talus::server::jetstream {

/// A failed connection, or JetStream's error.
using StreamError = std::variant<StreamFailure, ApiError>;

[[nodiscard]] StreamFailure failure_of(const StreamError& error, const StreamNames& names);

/// Asks the stream's leader. Waits at most half a second.
[[nodiscard]] tl::expected<StreamInfo, StreamError> ask_stream_info(Connection& connection,
                                                                    const StreamNames& names);

/// Creates a missing stream with the settings of stream_settings.h; waits until it has a leader.
[[nodiscard]] tl::expected<StreamInfo, StreamError> make_stream(Connection& connection,
                                                                const StreamNames& names,
                                                                std::uint64_t replicas);

struct PresentStream {
  StreamInfo info;
  bool made = false;  // created by this call
};
/// Creates the stream if it is missing; an existing one must have the settings. Waits up to 15 s for servers
/// that have just started. An error is one line.
[[nodiscard]] tl::expected<PresentStream, std::string> ensure_stream(Connection& connection,
                                                                     const StreamNames& names,
                                                                     std::uint64_t replicas);

}  // namespace talus::server::jetstream
