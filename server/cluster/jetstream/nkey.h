// NKeys: Ed25519 keys as NATS writes them (https://github.com/nats-io/nkeys). Pure.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server::jetstream {

/// The public key, "U...", of a user's seed, "SU...". An error says what is wrong with the seed and repeats
/// nothing of it.
[[nodiscard]] tl::expected<std::string, std::string> public_nkey(std::string_view seed);

}  // namespace talus::server::jetstream
