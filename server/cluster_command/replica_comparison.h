// Whether the replicas of a stream hold the same messages. NATS calls replicas current that are as far as
// their leader, whatever they hold: a nats-server that took a message twice, or lost one, stays "current".
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cluster_command/target.h"

namespace talus::server::cluster_tool {

/// Asks for the stream's end and for some messages before it (Direct Get), by all of `connections` and so
/// often that each replica answers: which one does is NATS' choice, and it does not say. A message too many
/// or too few shifts all later ones, so these few say it. A line for each difference; an error is why they
/// were not compared. Takes a second, and two more for replicas that lag behind.
[[nodiscard]] tl::expected<std::vector<std::string>, std::string> compare_replicas(
    std::span<const std::shared_ptr<jetstream::Connection>> connections, const Target& target);

}  // namespace talus::server::cluster_tool
