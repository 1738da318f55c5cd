// The settings of talusd and their defaults. fields.h has the key, range, unit and meaning of each;
// talusd.toml lists every key with its default. Plain values: copy them freely.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

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
  std::uint64_t io = 0;         // 0: one for each core
  std::uint64_t generator = 0;  // 0: one for each core
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
  std::uint64_t memory_bytes = 2U << 30;  // 0: no limit
  bool operator==(const Limits&) const = default;
};

/// Per second; 0: no limit. The session_ rates count one session, the address_ rates all sessions of one
/// address.
struct Rates {
  std::uint64_t session_chunks = 1024;
  std::uint64_t session_bytes = 2U << 20;
  std::uint64_t session_requests = 2048;
  std::uint64_t address_chunks = 8192;
  std::uint64_t address_bytes = 16U << 20;
  std::uint64_t address_requests = 16'384;
  std::uint64_t session_voxels = 65'536;
  std::uint64_t address_voxels = 524'288;
  std::optional<std::uint64_t> address_editors{};  // an hour; none: what the memory budget has room for
  std::uint64_t address_new_chunks = 7'200;        // an hour
  std::uint64_t gateway_requests = 65'536;  // of one session with the right "gateway", in place of the above
  std::uint64_t gateway_voxels = 4'194'304;
  std::uint64_t checkpoint_bytes = 64U << 20;  // to all servers that take the store
  milliseconds burst{32'000};
  bool operator==(const Rates&) const = default;
};

/// Who may join: config/access/access_control.h.
struct Access {
  std::filesystem::path secret_file;  // empty: no shared secret
  std::string secret_rights = "read";
  std::filesystem::path signing_key_file;  // empty: no signed tokens
  std::string without_token = "auto";
  std::filesystem::path previous_signing_key_file{};  // empty: only signing_key_file
  std::filesystem::path revoked_file{};               // empty: no signed token is revoked
  std::filesystem::path blocked_file{};               // empty: nobody is blocked
  /// Whether there are files to read.
  [[nodiscard]] bool wanted() const {
    return !secret_file.empty() || !signing_key_file.empty() || !previous_signing_key_file.empty() ||
           !revoked_file.empty() || !blocked_file.empty();
  }
  bool operator==(const Access&) const = default;
};

/// Who may change the world, beyond the rights of tokens.
struct Edits {
  Boxes protected_boxes;             // which only who has the right "admin" may edit
  std::uint64_t protect_spawn = 0;   // columns around the spawn, likewise; 0: none
  std::string gateway = "optional";  // "required": edits of players are refused
  bool settle = false;               // loose material slides after an edit
  std::uint64_t history_bytes = std::uint64_t{1} << 30U;
  std::uint64_t history_days = 30;
  bool operator==(const Edits&) const = default;
};

/// Both are set, or neither; without them connections are plain TCP.
struct Tls {
  std::filesystem::path certificate;
  std::filesystem::path key;
  [[nodiscard]] bool wanted() const { return !certificate.empty() || !key.empty(); }
  bool operator==(const Tls&) const = default;
};

/// The log that the servers of one world share (cluster_check.h).
struct Cluster {
  ServerUrls nats;    // empty: this server is alone
  std::string store;  // 32 hexadecimal digits; empty: the id of the data directory's store
  std::string user;   // empty: no user and password
  std::filesystem::path password_file{};     // of the user
  std::filesystem::path token_file{};        // empty: no token
  std::filesystem::path nkey_file{};         // empty: no NKey
  std::filesystem::path ca{};                // PEM: who vouches for NATS servers and peers
  std::filesystem::path certificate{};       // PEM: this server's, as a client of NATS; empty: none
  std::filesystem::path key{};               // the certificate's
  ServerUrls peers;                          // operators' ports of which a checkpoint may be taken
  std::filesystem::path peers_token_file{};  // the token that peers take
  std::uint64_t replicas = 3;                // of the stream that "talusd cluster init" makes
  [[nodiscard]] bool wanted() const { return !nats.empty(); }
  bool operator==(const Cluster&) const = default;
};

struct Cache {
  std::uint64_t chunk_bytes = 256U << 20;
  std::uint64_t patch_bytes = 256U << 20;
  std::uint64_t disk_bytes = 1U << 30;  // in the data directory; 0: none
  bool operator==(const Cache&) const = default;
};

struct Generation {
  std::uint64_t patch_tiles = 0;  // 0: as many as the world allows
  std::uint64_t queue_chunks = 65'536;
  bool operator==(const Generation&) const = default;
};

struct Shutdown {
  milliseconds lead{0};  // from the signal until no connection is accepted; 0: there is no other server
  milliseconds drain{5'000};
  bool operator==(const Shutdown&) const = default;
};

/// Among the servers behind a balancer that says how many players each has.
struct Balance {
  std::uint64_t per_second = 10;     // sessions that are sent elsewhere; 0: none
  std::uint64_t above_percent = 10;  // of its share, by which this server may have more
  milliseconds session{60'000};      // that is younger stays
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
  bool tls = true;                 // where there is a certificate
  bool public_chunks = false;      // chunks need no token, and every cache may keep them
  AllowedOrigins origins;          // of pages that may read and stream
  std::uint64_t log_every = 1000;  // answers, of which one is logged; 0: none
  bool operator==(const Http&) const = default;
};

struct Config {
  protocol::Endpoint listen{"0.0.0.0", kDefaultPort};
  std::optional<protocol::Endpoint> admin;
  std::filesystem::path data;   // empty: talusd keeps nothing on disk
  std::filesystem::path world;  // empty: the world built into the program
  std::string user;             // empty: do not switch user
  Access access;
  Edits edits;
  Networks proxies;  // proxies that must send a PROXY header
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
