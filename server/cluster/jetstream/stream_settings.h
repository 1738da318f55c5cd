// Required settings of a store's stream, and differences from them. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cluster/jetstream/stream_names.h"
#include "cluster/message.h"

namespace talus::server::jetstream {

/// Maximum size of a message.
inline constexpr auto kStreamMessageBytes = static_cast<std::int64_t>(cluster::kMaxMessageBytes);

/// In the format of $JS.API.STREAM.CREATE.
[[nodiscard]] nlohmann::json wanted_settings(const StreamNames& names, std::uint64_t replicas);

struct SettingDifference {
  std::string name;    // NATS' name: "deny_purge"
  std::string is;      // JSON
  std::string should;  // JSON
};

/// Settings in which `present` differs from `wanted`.
[[nodiscard]] std::vector<SettingDifference> differences(const nlohmann::json& present,
                                                         const nlohmann::json& wanted);
/// Returns one line with the first difference of an existing stream; nullopt if there is not one.
[[nodiscard]] std::optional<std::string> other_settings(const nlohmann::json& present,
                                                        const StreamNames& names, std::uint64_t replicas);
/// Returns one line if a NATS server with this `max_payload` does not take every message; nullopt if it does.
[[nodiscard]] std::optional<std::string> small_payload(std::int64_t max_payload);
/// Formats "max_age is 3600000000000 and should be 604800000000000".
[[nodiscard]] std::string to_string(const SettingDifference& difference);

}  // namespace talus::server::jetstream
