// What the stream of a store is to be like, and how one that is there differs. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cluster/jetstream/stream_names.h"
#include "cluster/message.h"

namespace talus::server::jetstream {

/// Of one message.
inline constexpr auto kStreamMessageBytes = static_cast<std::int64_t>(cluster::kMaxMessageBytes);

/// As NATS takes them ($JS.API.STREAM.CREATE).
[[nodiscard]] nlohmann::json wanted_settings(const StreamNames& names, std::uint64_t replicas);

struct SettingDifference {
  std::string name;    // as NATS has it: "deny_purge"
  std::string is;      // JSON
  std::string should;  // JSON
};

/// Settings of `wanted` that `present` has otherwise.
[[nodiscard]] std::vector<SettingDifference> differences(const nlohmann::json& present,
                                                         const nlohmann::json& wanted);
/// Where a stream that is there has other settings than a store's: one line that names the first of them.
[[nodiscard]] std::optional<std::string> other_settings(const nlohmann::json& present,
                                                        const StreamNames& names, std::uint64_t replicas);
/// "max_age is 3600000000000 and should be 604800000000000"
[[nodiscard]] std::string to_string(const SettingDifference& difference);

}  // namespace talus::server::jetstream
