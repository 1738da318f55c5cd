// Synchronous requests to a stream's leader.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_names.h"

namespace talus::server::jetstream {

/// Maximum wait for an answer of NATS.
inline constexpr std::chrono::milliseconds kAnswerPatience{500};

/// True if it is a leader's answer about a message, even if it lacks the message.
[[nodiscard]] inline bool is_of_messages(const tl::expected<StoredMessage, ApiError>& answer) {
  return answer || answer.error().code == kMessageNotFound;
}

[[nodiscard]] tl::expected<StreamInfo, StreamFailure> ask_info(Connection& connection,
                                                               const StreamNames& names);

/// nullopt if the leader lacks the message.
[[nodiscard]] tl::expected<std::optional<StoredMessage>, StreamFailure> ask_message(Connection& connection,
                                                                                    const StreamNames& names,
                                                                                    std::uint64_t sequence);

/// How many numbers from `first` on no message has or ever had, as the leader says: nats-server 2.9 uses a
/// number up when it refuses a message of a stream of one replica. 0 if the stream had a message `first`.
[[nodiscard]] tl::expected<std::uint64_t, StreamFailure> ask_unused(Connection& connection,
                                                                    const StreamNames& names,
                                                                    std::uint64_t first);

}  // namespace talus::server::jetstream
