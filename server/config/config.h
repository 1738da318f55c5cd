// What an operator can set. fields.h lists every member with its range, unit and meaning; talusd.toml
// writes every default out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <talus/protocol/endpoint.h>
#include <talus/protocol/limits.h>

#include "config/networks.h"

namespace talus::server {

inline constexpr std::uint16_t kDefaultPort = 4780;

struct Threads {
  std::uint64_t io = 0;         // 0: from the machine
  std::uint64_t generator = 0;  // 0: from the machine
  bool operator==(const Threads&) const = default;
};

struct Limits {
  std::uint64_t connections = 2048;
  std::uint64_t connections_per_address = 256;
  std::uint64_t handshakes_per_address_per_second = 20;
  std::uint64_t handshakes_per_address_burst = 256;
  std::uint64_t handshakes_under_way = 1024;
  std::uint64_t frame_bytes = protocol::kDefaultClientFrameBytes;
  std::uint64_t requests_in_flight = 1024;
  std::uint64_t handshake_timeout_ms = 10'000;
  std::uint64_t idle_timeout_ms = 60'000;
  std::uint64_t write_timeout_ms = 15'000;
  std::uint64_t queued_bytes_per_session = 1U << 20;
  std::uint64_t window_bytes = 4U << 20;
  std::uint64_t heights_per_request = protocol::kMaxHeightsPerRequest;
  /// Tiles of 32 x 32 columns in one GetHeights. No setting: the world decides (net/server.cpp).
  std::uint64_t height_tiles_per_request = protocol::kMaxHeightsPerRequest;
  std::uint64_t view_horizontal_radius = 48;
  std::uint64_t view_vertical_radius = 16;
  std::uint64_t view_chunks = 65'536;
  std::uint64_t memory_bytes = 2U << 30;  // 0: no limit
  bool operator==(const Limits&) const = default;
};

/// A second, of one session and of all sessions of one address; 0: no limit.
struct Rates {
  std::uint64_t session_chunks = 1024;
  std::uint64_t session_bytes = 2U << 20;
  std::uint64_t session_requests = 2048;
  std::uint64_t address_chunks = 8192;
  std::uint64_t address_bytes = 16U << 20;
  std::uint64_t address_requests = 16'384;
  std::uint64_t burst_ms = 32'000;
  bool operator==(const Rates&) const = default;
};

/// Who may come in: access/access_control.h.
struct Access {
  std::filesystem::path secret_file;  // empty: no shared secret
  std::string secret_rights = "read";
  std::filesystem::path signing_key_file;  // empty: no signed tokens
  std::string without_token = "auto";
  std::filesystem::path previous_signing_key_file{};  // empty: tokens of one key alone
  [[nodiscard]] bool wanted() const {
    return !secret_file.empty() || !signing_key_file.empty() || !previous_signing_key_file.empty();
  }
  bool operator==(const Access&) const = default;
};

/// Both or neither; without them connections are plain.
struct Tls {
  std::filesystem::path certificate;
  std::filesystem::path key;
  [[nodiscard]] bool wanted() const { return !certificate.empty() || !key.empty(); }
  bool operator==(const Tls&) const = default;
};

struct Cache {
  std::uint64_t chunk_bytes = 256U << 20;
  std::uint64_t patch_bytes = 256U << 20;
  bool operator==(const Cache&) const = default;
};

struct Generation {
  std::uint64_t patch_tiles = 4;
  std::uint64_t queue_chunks = 65'536;
  bool operator==(const Generation&) const = default;
};

struct Shutdown {
  std::uint64_t drain_ms = 5'000;
  bool operator==(const Shutdown&) const = default;
};

struct Log {
  std::string level = "info";
  std::string format = "text";
  bool operator==(const Log&) const = default;
};

struct Config {
  protocol::Endpoint listen{"0.0.0.0", kDefaultPort};
  std::optional<protocol::Endpoint> http;
  std::optional<protocol::Endpoint> admin;
  std::filesystem::path data;   // empty: nothing is kept on disk
  std::filesystem::path world;  // empty: the world built into the program
  std::string user;             // empty: stays who it is
  Access access;
  Networks proxies;  // whose PROXY headers are believed, and asked for
  Tls tls;
  Threads threads;
  Limits limits;
  Rates rates;
  Cache cache;
  Generation generation;
  Shutdown shutdown;
  Log log;
  bool operator==(const Config&) const = default;
};

}  // namespace talus::server
