#include "cluster/jetstream/leader_questions.h"

#include <utility>

namespace talus::server::jetstream {

tl::expected<StreamInfo, StreamFailure> ask_info(Connection& connection, const StreamNames& names) {
  const auto reply = connection.request(names.info(), "", kAnswerPatience);
  if (!reply) return tl::unexpected{reply.error()};
  auto info = parse_stream_info(ReceivedMessage{reply->get()}.text());
  if (!info) return tl::unexpected{failure_of(info.error(), names.stream)};
  return *std::move(info);
}

tl::expected<std::optional<StoredMessage>, StreamFailure> ask_message(Connection& connection,
                                                                      const StreamNames& names,
                                                                      std::uint64_t sequence) {
  const auto reply =
      connection.request(names.message_get(), StreamNames::by_number(sequence), kAnswerPatience);
  if (!reply) return tl::unexpected{reply.error()};
  auto message = parse_stored_message(ReceivedMessage{reply->get()}.text());
  if (!is_of_messages(message)) return tl::unexpected{failure_of(message.error(), names.stream)};
  if (!message || message->sequence != sequence) return std::optional<StoredMessage>{};
  return *std::move(message);
}

tl::expected<std::uint64_t, StreamFailure> ask_unused(Connection& connection, const StreamNames& names,
                                                      std::uint64_t first) {
  const auto reply = connection.request(names.info(), StreamNames::with_unused(), kAnswerPatience);
  if (!reply) return tl::unexpected{reply.error()};
  const auto unused = parse_unused(ReceivedMessage{reply->get()}.text(), first);
  if (!unused) return tl::unexpected{failure_of(unused.error(), names.stream)};
  return *unused;
}

}  // namespace talus::server::jetstream
