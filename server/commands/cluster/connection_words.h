// Explains why a NATS server rejected a connection: the setting concerned and its remedy. Pure.
#pragma once

#include <string>
#include <string_view>

#include "cluster/jetstream/credentials.h"
#include "commands/cluster/nats_greeting.h"

namespace talus::server::cluster_tool {

/// `reason` is libnats' error text.
[[nodiscard]] std::string connection_words(std::string_view url, std::string_view reason,
                                           const Greeting& greeting, const jetstream::Credentials& who);

}  // namespace talus::server::cluster_tool
