// The stream that a command addresses, its NATS servers, and the credentials.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/protocol/endpoint.h>
#include <talus/voxel/content_hash.h>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/credentials.h"
#include "cluster/jetstream/stream_names.h"
#include "config/config.h"

namespace talus::server::cluster_tool {

/// Pause between requests to servers that may still be starting.
inline constexpr std::chrono::milliseconds kBetweenTries{100};

/// An error is one line that begins with a key.
[[nodiscard]] tl::expected<void, std::string> check_target(const Config& config);

struct Target {
  ServerUrls urls;
  std::shared_ptr<const jetstream::Credentials> credentials;
  ContentHash store_id;
  jetstream::StreamNames names;
  std::uint64_t replicas = 3;
  std::optional<protocol::Endpoint> admin;  // this server's operators' port, if any

  /// For the store that the settings or the data directory name. An error is one line.
  [[nodiscard]] static tl::expected<Target, std::string> of(const Config& config);
  /// Like of(), but picks a new store id if neither names a store.
  [[nodiscard]] static tl::expected<Target, std::string> for_init(const Config& config);

  /// Connects to any of the servers.
  [[nodiscard]] tl::expected<std::shared_ptr<jetstream::Connection>, StreamFailure> connect() const;
};

}  // namespace talus::server::cluster_tool
