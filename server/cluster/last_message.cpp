#include "cluster/last_message.h"

#include <chrono>

#include <fmt/format.h>

#include "cluster/message.h"

namespace talus::server::cluster {

tl::expected<LastMessage, StreamFailure> compare_last_message(LogStream& stream, const StreamState& state,
                                                              const store::StreamPlace& place) {
  constexpr std::chrono::milliseconds kLastMessagePatience{500};
  if (state.first > place.sequence) return LastMessage::not_kept;
  const auto message =
      stream.next(place.sequence - 1, std::chrono::steady_clock::now() + kLastMessagePatience);
  using Kind = StreamFailure::Kind;
  // The stream may drop it just now; the next state() shows that.
  if (!message && message.error().kind != Kind::gone) return tl::unexpected{message.error()};
  if (!message || !*message) {
    return tl::unexpected{StreamFailure{
        Kind::unavailable,
        fmt::format("message {} of the log, which was applied last, does not arrive", place.sequence)}};
  }
  return hash_of_message((*message)->bytes) == place.message_hash ? LastMessage::as_applied
                                                                  : LastMessage::other;
}

}  // namespace talus::server::cluster
