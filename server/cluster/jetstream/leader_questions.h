// What is asked of a stream's leader, and waited for.
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

/// So long an answer of NATS is waited for.
inline constexpr std::chrono::milliseconds kAnswerPatience{500};

/// Whether it is what a leader says of a message, though it may have none of the number.
[[nodiscard]] inline bool is_of_messages(const tl::expected<StoredMessage, ApiError>& answer) {
  return answer || answer.error().code == kMessageNotFound;
}

[[nodiscard]] tl::expected<StreamInfo, StreamFailure> ask_info(Connection& connection,
                                                               const StreamNames& names);

/// Nothing where the leader has none of the number.
[[nodiscard]] tl::expected<std::optional<StoredMessage>, StreamFailure> ask_message(Connection& connection,
                                                                                    const StreamNames& names,
                                                                                    std::uint64_t sequence);

}  // namespace talus::server::jetstream
