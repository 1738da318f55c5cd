// Why a NATS server did not let this one in, in a person's words: which key is concerned, and what would be
// right. Pure.
#pragma once

#include <string>
#include <string_view>

#include "cluster/jetstream/credentials.h"
#include "commands/cluster/nats_greeting.h"

namespace talus::server::cluster_tool {

/// `reason`: as libnats gives it.
[[nodiscard]] std::string connection_words(std::string_view url, std::string_view reason,
                                           const Greeting& greeting, const jetstream::Credentials& who);

}  // namespace talus::server::cluster_tool
