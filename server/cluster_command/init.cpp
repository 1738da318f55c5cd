#include "cluster_command/init.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "cluster_command/stream_world.h"
#include "jetstream/stream_admin.h"
#include "jetstream/stream_settings.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;
using jetstream::StreamInfo;

constexpr auto kMakePatience = 15s;
constexpr auto kAckPatience = 5s;
constexpr int kNoPlaceForReplicas = 10005;  // too few NATS servers are known yet, or there are too few
constexpr int kNoStorage = 10047;
constexpr int kNoStorageInCluster = 10023;

std::string reason_of(const jetstream::StreamError& error, const Target& target) {
  std::string reason = failure_of(error, target.names).reason;
  const auto* const said = std::get_if<jetstream::ApiError>(&error);
  if (said == nullptr) return reason;
  if (said->code == kNoPlaceForReplicas) {
    reason += fmt::format("; cluster.replicas is {}: as many NATS servers with JetStream must be there",
                          target.replicas);
  }
  if (said->code == kNoStorage || said->code == kNoStorageInCluster) {
    reason +=
        "; the log may grow to 16 GiB: each NATS server's jetstream max_file_store must have room for it";
  }
  return reason;
}

/// The stream, and whether it was made now.
tl::expected<std::pair<StreamInfo, bool>, std::string> ensure_stream(jetstream::Connection& connection,
                                                                     const Target& target) {
  const auto until = std::chrono::steady_clock::now() + kMakePatience;
  for (;;) {
    auto found = ask_stream_info(connection, target.names);
    if (found) return std::pair{*std::move(found), false};
    const auto* said = std::get_if<jetstream::ApiError>(&found.error());
    if (said != nullptr && said->code == jetstream::kStreamNotFound) {
      auto made = make_stream(connection, target.names, target.replicas);
      if (made) return std::pair{*std::move(made), true};
      found = std::move(made);
    }
    // A cluster that has just started answers some time.
    const bool for_a_person = failure_of(found.error(), target.names).kind == StreamFailure::Kind::refused;
    if (for_a_person || std::chrono::steady_clock::now() > until) {
      return tl::unexpected{reason_of(found.error(), target)};
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
}

}  // namespace

tl::expected<Made, std::string> init(const Target& target, const cluster::Genesis& genesis) {
  const auto connection = target.connect();
  if (!connection) return tl::unexpected{connection.error().reason};
  const auto stream = ensure_stream(**connection, target);
  if (!stream) return tl::unexpected{stream.error()};
  const auto& [info, was_made] = *stream;
  Made made{was_made, false};
  const auto others =
      jetstream::differences(info.settings, jetstream::wanted_settings(target.names, target.replicas));
  if (!others.empty()) {
    return tl::unexpected{fmt::format("{} is there with other settings: {}; change them by the program nats",
                                      target.names.stream, to_string(others.front()))};
  }
  if (info.state.last == 0) {
    const auto bytes = encode(genesis);
    if (!bytes) return tl::unexpected{bytes.error()};
    const auto ack = (*connection)
                         ->publish(target.names.log, std::as_bytes(std::span{*bytes}), kAckPatience,
                                   jetstream::Connection::Only::as_first);
    made.genesis = ack.has_value();
    if (!ack) {
      // Somebody else may have been faster.
      const auto now = ask_stream_info(**connection, target.names);
      if (!now || now->state.last == 0) return tl::unexpected{ack.error().reason};
    }
  }
  if (const auto fits = check_world(**connection, target, genesis); !fits)
    return tl::unexpected{fits.error()};
  return made;
}

std::string made_lines(const Target& target, const cluster::Genesis& genesis, const Made& made) {
  return fmt::format(
      "store {}\nstream {}: {}, {} {}, kept for 7 days and up to 16 GiB\nfirst message: {}, of world {}\n",
      to_string(target.store_id), target.names.stream, made.stream ? "made" : "was there", target.replicas,
      target.replicas == 1 ? "replica" : "replicas", made.genesis ? "written" : "was there",
      to_string(genesis.identity.fingerprint));
}

}  // namespace talus::server::cluster_tool
