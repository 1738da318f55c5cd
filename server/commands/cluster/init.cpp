#include "commands/cluster/init.h"

#include <chrono>

#include <fmt/format.h>

#include "cluster/jetstream/stream_admin.h"
#include "commands/cluster/stream_world.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;

constexpr auto kAckPatience = 5s;

}  // namespace

tl::expected<InitResult, std::string> init(const Target& target, const cluster::Genesis& genesis) {
  const auto connection = target.connect();
  if (!connection) return tl::unexpected{connection.error().reason};
  if (const auto small = jetstream::small_payload((*connection)->max_payload())) {
    return tl::unexpected{fmt::format("{}: {}", target.urls.text(), *small)};
  }
  const auto stream = ensure_stream(**connection, target.names, target.replicas);
  if (!stream) return tl::unexpected{stream.error()};
  InitResult made{stream->made, false};
  if (stream->info.state.last == 0) {
    const auto bytes = encode(genesis);
    if (!bytes) return tl::unexpected{bytes.error()};
    const auto ack = (*connection)->publish(target.names.log, std::as_bytes(std::span{*bytes}), kAckPatience);
    // If another server was faster, servers ignore this message.
    made.genesis = ack.has_value() && ack->sequence == 1;
    if (!ack) {
      // The message may have been stored nevertheless.
      const auto now = ask_stream_info(**connection, target.names);
      if (!now || now->state.last == 0) return tl::unexpected{ack.error().reason};
    }
  }
  if (const auto fits = check_world(**connection, target, genesis); !fits)
    return tl::unexpected{fits.error()};
  return made;
}

std::string made_lines(const Target& target, const cluster::Genesis& genesis, const InitResult& made) {
  return fmt::format(
      "store {}\nstream {}: {}, {} {}, kept for 7 days and up to 16 GiB\nfirst message: {}, of world {}\n",
      to_string(target.store_id), target.names.stream, made.stream ? "made" : "was there", target.replicas,
      target.replicas == 1 ? "replica" : "replicas", made.genesis ? "written" : "was there",
      to_string(genesis.identity.fingerprint));
}

}  // namespace talus::server::cluster_tool
