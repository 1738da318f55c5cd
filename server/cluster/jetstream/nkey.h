// NKeys: Ed25519 keys in NATS' encoding (https://github.com/nats-io/nkeys). Pure.
#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::server::jetstream {

/// Derives the public key, "U...", of a user's seed, "SU...". An error describes what is wrong with the seed
/// without revealing any of it.
[[nodiscard]] tl::expected<std::string, std::string> public_nkey(std::string_view seed);

}  // namespace talus::server::jetstream
