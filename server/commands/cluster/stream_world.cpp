#include "commands/cluster/stream_world.h"

#include <chrono>

#include <fmt/format.h>

#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_admin.h"

namespace talus::server::cluster_tool {

tl::expected<void, std::string> check_world(jetstream::Connection& connection, const Target& target,
                                            const cluster::Genesis& genesis) {
  const auto info = ask_stream_info(connection, target.names);
  if (!info) return tl::unexpected{failure_of(info.error(), target.names).reason};
  const StreamState state = info->state;
  if (state.first > state.last) return {};
  const auto reply =
      connection.request(target.names.message_get(), jetstream::StreamNames::by_number(state.first),
                         std::chrono::milliseconds{500});
  if (!reply) return tl::unexpected{reply.error().reason};
  const auto message = jetstream::parse_stored_message(jetstream::ReceivedMessage{reply->get()}.text());
  if (!message) {
    return tl::unexpected{
        fmt::format("{}: message {}: {}", target.names.stream, state.first, message.error().what)};
  }
  if (state.first == 1) {
    const auto there = cluster::decode_genesis(message->bytes);
    if (!there)
      return tl::unexpected{fmt::format("{}: message 1: {}{}", target.names.stream, there.error().reason,
                                        remedy_of(there.error()))};
    if (there->identity == genesis.identity) return {};
    return tl::unexpected{
        fmt::format("{} is of world {} and store {}; this server's is {} of store {}", target.names.stream,
                    to_string(there->identity.fingerprint), to_string(there->identity.store_id),
                    to_string(genesis.identity.fingerprint), to_string(genesis.identity.store_id))};
  }
  const auto batch = cluster::decode_batch(message->bytes, genesis.identity);
  using Kind = cluster::MessageFault::Kind;
  if (!batch && (batch.error().kind == Kind::other_world || batch.error().kind == Kind::other_store)) {
    return tl::unexpected{
        fmt::format("{}: message {}: {}", target.names.stream, state.first, batch.error().reason)};
  }
  return {};
}

}  // namespace talus::server::cluster_tool
