// The settings of talusd with their defaults. fields.h has the key, range, unit and meaning of each;
// talusd.toml lists every key with its default. Copyable values.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <talus/protocol/endpoint.h>
#include <talus/protocol/limits.h>

#include "config/allowed_origins.h"
#include "config/boxes.h"
#include "config/networks.h"
#include "config/server_urls.h"

namespace talus::server {

using std::chrono::milliseconds;

inline constexpr std::uint16_t kDefaultPort = 4780;

struct Threads {
  std::uint64_t io = 0;         // 0: one per core
  std::uint64_t generator = 0;  // 0: one per core
  bool operator==(const Threads&) const = default;
};

struct Limits {
  std::uint64_t connections = 2048;
  std::uint64_t connections_per_address = 256;
  std::uint64_t handshakes_per_address_per_second = 20;
  std::uint64_t handshakes_per_address_burst = 256;
  std::uint64_t handshakes_in_flight = 1024;
  std::uint64_t frame_bytes = protocol::kDefaultClientFrameBytes;
  std::uint64_t requests_in_flight = 1024;
  milliseconds handshake_timeout{10'000};
  milliseconds idle_timeout{60'000};
  milliseconds write_timeout{15'000};
  std::uint64_t queued_bytes_per_session = 1U << 20;
  std::uint64_t window_bytes = 4U << 20;
  std::uint64_t heights_per_request = protocol::kMaxHeightsPerRequest;
  std::uint64_t view_horizontal_radius = 48;
  std::uint64_t view_vertical_radius = 16;
  std::uint64_t view_chunks = 65'536;
  std::uint64_t memory_bytes = 2U << 30;  // 0: unlimited
  bool operator==(const Limits&) const = default;
};

/// Per second; 0: unlimited. The session_ rates apply to one session, the address_ rates to all sessions of
/// one address.
struct Rates {
  std::uint64_t session_chunks = 1024;
  std::uint64_t session_bytes = 2U << 20;
  std::uint64_t session_requests = 2048;
  std::uint64_t address_chunks = 8192;
  std::uint64_t address_bytes = 16U << 20;
  std::uint64_t address_requests = 16'384;
  std::uint64_t session_voxels = 65'536;
  std::uint64_t address_voxels = 524'288;
  std::optional<std::uint64_t> address_editors{};  // per hour; nullopt: limited only by the memory budget
  std::uint64_t address_new_chunks = 7'200;        // per hour
  std::uint64_t gateway_requests = 65'536;  // per session with the right "gateway", replacing the above
  std::uint64_t gateway_voxels = 4'194'304;
  std::uint64_t checkpoint_bytes = 64U << 20;  // to all servers that download the store
  milliseconds burst{32'000};
  bool operator==(const Rates&) const = default;
};

/// Access settings; see config/access/access_control.h.
struct Access {
  std::filesystem::path secret_file;  // empty: no shared secret
  std::string secret_rights = "read";
  std::filesystem::path signing_key_file;  // empty: no signed tokens
  std::string without_token = "auto";
  std::filesystem::path previous_signing_key_file{};  // empty: only signing_key_file
  std::filesystem::path revoked_file{};               // empty: no revoked tokens
  std::filesystem::path blocked_file{};               // empty: no blocks
  /// True if there are files to read.
  [[nodiscard]] bool wanted() const {
    return !secret_file.empty() || !signing_key_file.empty() || !previous_signing_key_file.empty() ||
           !revoked_file.empty() || !blocked_file.empty();
  }
  bool operator==(const Access&) const = default;
};

/// Restrictions on edits in addition to tokens' rights.
struct Edits {
  Boxes protected_boxes;             // editable only with the right "admin"
  std::uint64_t protect_spawn = 0;   // columns around the spawn protected in the same way
  std::string gateway = "optional";  // "required": players' own edits are rejected
  bool settle = false;               // loose material slides after an edit
  std::uint64_t history_bytes = std::uint64_t{1} << 30U;
  std::uint64_t history_days = 30;
  bool operator==(const Edits&) const = default;
};

/// Land that only servers know (secret_layers.h). Both or neither are set.
struct SecretLayers {
  std::filesystem::path key_file;
  std::vector<std::string> layers;  // sections of the world's file
  bool operator==(const SecretLayers&) const = default;
};

/// Both or neither are set; without them connections are plain TCP.
struct Tls {
  std::filesystem::path certificate;
  std::filesystem::path key;
  [[nodiscard]] bool wanted() const { return !certificate.empty() || !key.empty(); }
  bool operator==(const Tls&) const = default;
};

/// The log shared by the servers of one world (cluster_check.h).
struct Cluster {
  ServerUrls nats;    // empty: not in a cluster
  std::string store;  // 32 hexadecimal digits; empty: the id of the data directory's store
  std::string user;   // empty: no user and password
  std::filesystem::path password_file{};     // the user's
  std::filesystem::path token_file{};        // empty: no token
  std::filesystem::path nkey_file{};         // empty: no NKey
  std::filesystem::path ca{};                // PEM: certificate authorities of NATS servers and peers
  std::filesystem::path certificate{};       // PEM: this server's client certificate for NATS; may be empty
  std::filesystem::path key{};               // the certificate's
  ServerUrls peers;                          // operators' ports to download a checkpoint from
  std::filesystem::path peers_token_file{};  // the token that peers accept
  std::uint64_t replicas = 3;                // for the stream that "talusd cluster init" creates
  [[nodiscard]] bool wanted() const { return !nats.empty(); }
  bool operator==(const Cluster&) const = default;
};

struct Cache {
  std::uint64_t chunk_bytes = 256U << 20;
  std::uint64_t patch_bytes = 256U << 20;
  std::uint64_t disk_bytes = 1U << 30;  // in the data directory; 0: no disk cache
  bool operator==(const Cache&) const = default;
};

struct Generation {
  std::uint64_t patch_tiles = 0;  // 0: as many as the world allows
  std::uint64_t queue_chunks = 65'536;
  bool operator==(const Generation&) const = default;
};

struct Shutdown {
  milliseconds lead{0};  // from the signal until connections are refused; 0: there are no other servers
  milliseconds drain{5'000};
  bool operator==(const Shutdown&) const = default;
};

/// For servers behind a balancer that reports each server's number of players.
struct Balance {
  std::uint64_t per_second = 10;     // sessions redirected; 0: off
  std::uint64_t above_percent = 10;  // tolerated excess over this server's share
  milliseconds session{60'000};      // younger sessions are not redirected
  bool operator==(const Balance&) const = default;
};

struct Log {
  std::string level = "info";
  std::string format = "text";
  bool operator==(const Log&) const = default;
};

/// HTTP and WebSocket for players.
struct Http {
  std::optional<protocol::Endpoint> listen;
  std::filesystem::path web;       // files served at /; empty: none
  bool tls = true;                 // if there is a certificate
  bool public_chunks = false;      // chunks need no token, and any cache may keep them
  AllowedOrigins origins;          // whose pages may read and stream
  std::uint64_t log_every = 1000;  // one of this many answers is logged; 0: off
  bool operator==(const Http&) const = default;
};

struct Config {
  protocol::Endpoint listen{"0.0.0.0", kDefaultPort};
  std::optional<protocol::Endpoint> admin;
  std::filesystem::path data;    // empty: nothing is stored on disk
  std::filesystem::path world;   // empty: the built-in world
  std::string publish = "none";  // "public": clients get the world's file
  bool publish_files = false;    // height maps over kMaxSmallMapBytes too
  std::string user;              // empty: do not switch user
  Access access;
  SecretLayers secret;
  Edits edits;
  Networks proxies;  // must send a PROXY header
  Tls tls;
  Http http;
  Cluster cluster;
  Threads threads;
  Limits limits;
  Rates rates;
  Cache cache;
  Generation generation;
  Shutdown shutdown;
  Balance balance;
  Log log;
  bool operator==(const Config&) const = default;
};

}  // namespace talus::server
