#include "config/fields.h"

#include <algorithm>
#include <array>

namespace talus::server {
namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;
constexpr milliseconds kDay = std::chrono::hours{24};
constexpr milliseconds kMinTimeout{10};
constexpr std::uint64_t kMaxPerSecond = 0xFFFF'FFFF;  // limits/rates/token_bucket.h

constexpr std::array<std::string_view, 2> kLogFormats{"text", "json"};
constexpr std::array<std::string_view, 6> kLevels{"trace", "debug", "info", "warning", "error", "off"};
constexpr std::array<std::string_view, 5> kRights{"read", "read,edit", "read,edit,admin", "read,edit,gateway",
                                                  "read,edit,admin,gateway"};
constexpr std::array<std::string_view, 2> kGateway{"optional", "required"};
constexpr std::array<std::string_view, 4> kRightsWithoutToken{"auto", "none", "read", "read,edit"};

constexpr std::array<std::string_view, 2> kNatsSchemes{"nats", "tls"};
constexpr std::array<std::string_view, 2> kPeerSchemes{"http", "https"};

template <typename Group, typename Value, Group Config::*group, Value Group::*member>
Value& member_of(Config& config) {
  return config.*group.*member;
}

template <auto group, auto member>
struct Member;
template <typename Group, typename Value, Group Config::*group, Value Group::*member>
struct Member<group, member> {
  static constexpr auto at = &member_of<Group, Value, group, member>;
};

template <auto group, auto member>
constexpr NumberTarget number(std::uint64_t min, std::uint64_t max) {
  return {Member<group, member>::at, min, max};
}
template <auto group, auto member>
constexpr DurationTarget duration(std::chrono::milliseconds min, std::chrono::milliseconds max) {
  return {Member<group, member>::at, min, max};
}

const std::array kFields{
    Field{"listen", "HOST:PORT", "address for game clients; port 0 lets the system choose a free port",
          EndpointTarget{[](Config& c) -> protocol::Endpoint& { return c.listen; }}},
    Field{"admin", "HOST:PORT",
          "address for metrics and health over HTTP; keep it away from the open network; empty: none",
          OptionalEndpointTarget{[](Config& c) -> std::optional<protocol::Endpoint>& { return c.admin; }}},
    Field{"data", "directory", "directory for data that outlives the server; empty: keep nothing",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.data; }}},
    Field{"world", "file", "the world's spec; empty: the world built into talusd",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.world; }}},
    Field{
        "user", "user, as NAME, UID or UID:GID",
        "user to switch to after binding ports and reading keys, when started as root; empty: do not switch",
        TextTarget{[](Config& c) -> std::string& { return c.user; }}},

    Field{"access.secret_file", "file",
          "file with the secret that clients may send as their token; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.secret_file; }}},
    Field{"access.secret_rights", "rights", "rights of clients that send the secret",
          WordTarget{[](Config& c) -> std::string& { return c.access.secret_rights; }, kRights}},
    Field{"access.signing_key_file", "file", "file with the key that signs tokens; empty: no signed tokens",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.signing_key_file; }}},
    Field{"access.previous_signing_key_file", "file",
          "file with the previous signing key, whose tokens are still accepted; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.previous_signing_key_file; }}},
    Field{"access.revoked_file", "file",
          "file that lists signed tokens which are accepted no more; SIGHUP reloads it; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.revoked_file; }}},
    Field{"access.blocked_file", "file",
          "file that lists addresses and subjects of tokens that are not served; SIGHUP reloads it; empty: "
          "none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.blocked_file; }}},
    Field{"access.without_token", "rights",
          "rights of clients without a token; auto: none where a secret or a key is configured, else read",
          WordTarget{[](Config& c) -> std::string& { return c.access.without_token; }, kRightsWithoutToken}},

    Field{"edits.protected", "boxes", "boxes that only tokens with the right admin may edit; empty: none",
          BoxesTarget{[](Config& c) -> Boxes& { return c.edits.protected_boxes; }}},
    Field{"edits.protect_spawn", "columns",
          "as far around the world's spawn, from the deepest to the highest, only tokens with the right "
          "admin may "
          "edit; 0: not",
          number<&Config::edits, &Edits::protect_spawn>(0, 65'536)},
    Field{"edits.gateway", "",
          "required: players' own edits are refused, as a game server with the right gateway edits for them",
          WordTarget{[](Config& c) -> std::string& { return c.edits.gateway; }, kGateway}},
    Field{"edits.settle", "switch",
          "whether loose material slides into what is dug, and down from where it is put",
          SwitchTarget{[](Config& c) -> bool& { return c.edits.settle; }}},
    Field{"edits.history_bytes", "bytes",
          "of disk for who changed what, of which talusd store history tells and rollback puts back; above "
          "that the "
          "oldest goes",
          number<&Config::edits, &Edits::history_bytes>(16 * kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"edits.history_days", "days", "for which that is kept at most",
          number<&Config::edits, &Edits::history_days>(1, 3650)},

    Field{"proxies", "networks",
          "proxies in front of the server; their connections must begin with a PROXY header, version 2; "
          "empty: none",
          NetworksTarget{[](Config& c) -> Networks& { return c.proxies; }}},

    Field{"tls.certificate", "file", "PEM file with the certificate chain; SIGHUP reloads it; empty: no TLS",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.certificate; }}},
    Field{"tls.key", "file", "PEM file with the certificate's key, without a passphrase",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.key; }}},

    Field{"http.listen", "HOST:PORT", "address for HTTP and WebSocket of players; empty: none",
          OptionalEndpointTarget{
              [](Config& c) -> std::optional<protocol::Endpoint>& { return c.http.listen; }}},
    Field{"http.web", "directory",
          "directory of files served at / of http.listen: the viewer; read at the start; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.http.web; }}},
    Field{"http.tls", "switch",
          "whether HTTP comes by TLS where tls.certificate is set; false where a proxy in front does that",
          SwitchTarget{[](Config& c) -> bool& { return c.http.tls; }}},
    Field{"http.public_chunks", "switch",
          "whether chunks over HTTP need no token, so that caches may keep them",
          SwitchTarget{[](Config& c) -> bool& { return c.http.public_chunks; }}},
    Field{
        "http.origins", "origins",
        "origins whose pages may read and stream, beside the server's own; *: all; empty: no other, but all "
        "may read what every cache may keep",
        OriginsTarget{[](Config& c) -> AllowedOrigins& { return c.http.origins; }}},
    Field{"http.log_every", "answers", "of so many HTTP answers one is logged; 0: none",
          number<&Config::http, &Http::log_every>(0, 1'000'000'000)},

    Field{"cluster.nats", "addresses",
          "NATS servers with the log that all servers of this world share; empty: this server is alone",
          UrlsTarget{[](Config& c) -> ServerUrls& { return c.cluster.nats; }, kNatsSchemes}},
    Field{"cluster.store", "id of a store",
          "the world's store, which all servers of the cluster have; empty: that of the data directory",
          TextTarget{[](Config& c) -> std::string& { return c.cluster.store; }}},
    Field{"cluster.user", "user's name", "user at the NATS servers, with cluster.password_file; empty: none",
          TextTarget{[](Config& c) -> std::string& { return c.cluster.user; }}},
    Field{"cluster.password_file", "file", "file with the password of cluster.user",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.password_file; }}},
    Field{"cluster.token_file", "file", "file with a token that the NATS servers take; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.token_file; }}},
    Field{"cluster.nkey_file", "file",
          "file with the seed of an NKey (SU...) that the NATS servers know; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.nkey_file; }}},
    Field{"cluster.ca", "file",
          "PEM file with the certificates that vouch for NATS servers (tls://) and peers (https://)",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.ca; }}},
    Field{"cluster.certificate", "file",
          "PEM file with the certificate that this server shows NATS servers and peers; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.certificate; }}},
    Field{"cluster.key", "file", "PEM file with the key of cluster.certificate, without a passphrase",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.key; }}},
    Field{"cluster.peers", "addresses",
          "operators' ports of other servers of the cluster, of which a new one takes what the log no longer "
          "has; empty: none",
          UrlsTarget{[](Config& c) -> ServerUrls& { return c.cluster.peers; }, kPeerSchemes}},
    Field{"cluster.peers_token_file", "file",
          "file with a token of the right admin, which peers ask for; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.peers_token_file; }}},
    Field{"cluster.replicas", "NATS servers",
          "NATS servers that hold the log which talusd cluster init makes: 1, 3 or 5",
          number<&Config::cluster, &Cluster::replicas>(1, 5)},

    Field{"threads.io", "threads", "threads that serve sockets; 0: one for each core",
          number<&Config::threads, &Threads::io>(0, 1024)},
    Field{"threads.generator", "threads", "threads that generate chunks; 0: one for each core",
          number<&Config::threads, &Threads::generator>(0, 1024)},

    Field{"limits.connections", "connections", "open connections in all",
          number<&Config::limits, &Limits::connections>(1, 1'000'000)},
    Field{"limits.connections_per_address", "connections",
          "open connections from one IPv4 address or one IPv6 /64 network",
          number<&Config::limits, &Limits::connections_per_address>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_per_second", "connections",
          "new connections per second from one address, in the long run",
          number<&Config::limits, &Limits::handshakes_per_address_per_second>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_burst", "connections",
          "new connections from one address at once, after a pause",
          number<&Config::limits, &Limits::handshakes_per_address_burst>(1, 1'000'000)},
    Field{"limits.handshakes_in_flight", "connections", "unfinished TLS handshakes and PROXY headers in all",
          number<&Config::limits, &Limits::handshakes_in_flight>(1, 1'000'000)},
    Field{"limits.frame_bytes", "bytes", "size of one frame from a client, including its length prefix",
          number<&Config::limits, &Limits::frame_bytes>(protocol::kMinClientFrameBytes, 16 * kMebibyte)},
    Field{"limits.requests_in_flight", "requests", "unanswered chunk and height requests of one session",
          number<&Config::limits, &Limits::requests_in_flight>(1, 65'536)},
    Field{"limits.handshake_timeout_ms", "ms",
          "time from the connection to the client's whole Hello, including PROXY header and TLS",
          duration<&Config::limits, &Limits::handshake_timeout>(kMinTimeout, kDay)},
    Field{"limits.idle_timeout_ms", "ms", "time without a whole frame from the client",
          duration<&Config::limits, &Limits::idle_timeout>(kMinTimeout, kDay)},
    Field{"limits.write_timeout_ms", "ms", "time in which the client reads nothing of what it is sent",
          duration<&Config::limits, &Limits::write_timeout>(kMinTimeout, kDay)},
    Field{"limits.queued_bytes_per_session", "bytes",
          "answers queued for one client; above it the server stops reading from that client",
          number<&Config::limits, &Limits::queued_bytes_per_session>(64 * 1024, 1024 * kMebibyte)},
    Field{"limits.window_bytes", "bytes",
          "Chunk frames in flight that the client has not acknowledged by Credit",
          number<&Config::limits, &Limits::window_bytes>(1024, 1024 * kMebibyte)},
    Field{"limits.heights_per_request", "columns", "columns in one GetHeights",
          number<&Config::limits, &Limits::heights_per_request>(1, protocol::kMaxHeightsPerRequest)},
    Field{"limits.view_horizontal_radius", "chunks",
          "radius of a View along x and z; at level l it may be 2^l times as large",
          number<&Config::limits, &Limits::view_horizontal_radius>(0, 512)},
    Field{"limits.view_vertical_radius", "chunks",
          "radius of a View along y; at level l it may be 2^l times as large",
          number<&Config::limits, &Limits::view_vertical_radius>(0, 512)},
    Field{"limits.view_chunks", "chunks", "chunks of all levels in one View",
          number<&Config::limits, &Limits::view_chunks>(1, 4'194'304)},
    Field{"limits.memory_bytes", "bytes",
          "memory budget; near it caches shrink, then new work and connections are refused; at least "
          "75497472, or 0: no limit",
          number<&Config::limits, &Limits::memory_bytes>(0, 1024 * 1024 * kMebibyte)},

    Field{"rates.session_chunks", "chunks per second", "chunks sent to one session; 0: no limit",
          number<&Config::rates, &Rates::session_chunks>(0, kMaxPerSecond)},
    Field{"rates.session_bytes", "bytes per second", "bytes sent to one session; 0: no limit",
          number<&Config::rates, &Rates::session_bytes>(0, kMaxPerSecond)},
    Field{"rates.session_requests", "requests per second", "requests accepted from one session; 0: no limit",
          number<&Config::rates, &Rates::session_requests>(0, kMaxPerSecond)},
    Field{"rates.address_chunks", "chunks per second",
          "chunks sent to all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_chunks>(0, kMaxPerSecond)},
    Field{"rates.address_bytes", "bytes per second", "bytes sent to all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_bytes>(0, kMaxPerSecond)},
    Field{"rates.address_requests", "requests per second",
          "requests accepted from all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_requests>(0, kMaxPerSecond)},
    Field{"rates.session_voxels", "voxels per second", "voxels that edits of one session name; 0: no limit",
          number<&Config::rates, &Rates::session_voxels>(0, kMaxPerSecond)},
    Field{"rates.address_voxels", "voxels per second",
          "voxels that edits of all sessions of one address name; 0: no limit",
          number<&Config::rates, &Rates::address_voxels>(0, kMaxPerSecond)},
    Field{"rates.address_editors", "editors per hour",
          "editors that sessions of one address make, each of which is known for a day; an address saves up "
          "eight hours of them; auto: 512, or fewer where limits.memory_bytes has room for few; 0: no limit",
          OptionalNumberTarget{
              [](Config& c) -> std::optional<std::uint64_t>& { return c.rates.address_editors; }, 0, 65'536}},
    Field{
        "rates.address_new_chunks", "chunks per hour",
        "chunks that nobody edited before and edits of all sessions of one address may write, or have guards "
        "in, each of which is generated, and stays in the index of edited chunks where it is written; an "
        "address saves up eight hours of them; no more count than fill the index in 32 hours; 0: no limit",
        number<&Config::rates, &Rates::address_new_chunks>(0, 16'777'216)},
    Field{"rates.gateway_requests", "requests per second",
          "requests accepted from one session with the right gateway, in place of session_requests and "
          "address_requests; 0: no limit",
          number<&Config::rates, &Rates::gateway_requests>(0, kMaxPerSecond)},
    Field{"rates.gateway_voxels", "voxels per second",
          "voxels that edits of one session with the right gateway name, in place of session_voxels and "
          "address_voxels; 0: no limit",
          number<&Config::rates, &Rates::gateway_voxels>(0, kMaxPerSecond)},
    Field{"rates.checkpoint_bytes", "bytes per second",
          "bytes of the store sent to all servers that take a checkpoint of it",
          number<&Config::rates, &Rates::checkpoint_bytes>(262'144, kMaxPerSecond)},
    Field{"rates.burst_ms", "ms", "how much of each rate an idle session or address saves up",
          duration<&Config::rates, &Rates::burst>(milliseconds{1}, milliseconds{600'000})},

    Field{"cache.chunk_bytes", "bytes", "size of the cache of encoded chunks",
          number<&Config::cache, &Cache::chunk_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"cache.patch_bytes", "bytes",
          "size of the cache of terrain, from which neighbouring chunks are extracted",
          number<&Config::cache, &Cache::patch_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"cache.disk_bytes", "bytes",
          "size of the cache of chunks in the data directory, which outlives a restart; what is cheap to "
          "generate is not kept; 0: none",
          number<&Config::cache, &Cache::disk_bytes>(0, 1024 * 1024 * kMebibyte)},

    Field{"generation.patch_tiles", "tiles",
          "edge of the square of terrain that is generated at once, a power of two; a tile is 32 columns; 0: "
          "by "
          "what the world's terrain is measured to cost",
          PowerOfTwoTarget{[](Config& c) -> std::uint64_t& { return c.generation.patch_tiles; }, 16}},
    Field{"generation.queue_chunks", "chunks",
          "chunks of all clients that wait for a generator; more are refused, but for clients that wait for "
          "nothing",
          number<&Config::generation, &Generation::queue_chunks>(1, 16'777'216)},

    Field{"shutdown.lead_ms", "ms",
          "time from the signal that ends the server until it accepts no connection, so that the balancer "
          "before several servers sends nobody here any more; 0: this server is alone",
          duration<&Config::shutdown, &Shutdown::lead>(milliseconds{0}, kDay)},
    Field{"shutdown.drain_ms", "ms", "time for sending pending answers before the server ends",
          duration<&Config::shutdown, &Shutdown::drain>(milliseconds{0}, kDay)},

    Field{
        "balance.per_second", "sessions per second",
        "sessions that are sent to other servers while the balancer says that this one has too many; 0: none",
        number<&Config::balance, &Balance::per_second>(0, 100'000)},
    Field{"balance.above_percent", "percent",
          "by how much more than its share this server may have before it sends sessions away",
          number<&Config::balance, &Balance::above_percent>(0, 1000)},
    Field{"balance.session_ms", "ms", "a session that began less long ago is not sent away",
          duration<&Config::balance, &Balance::session>(milliseconds{0}, kDay)},

    Field{"log.level", "", "lowest level that is logged",
          WordTarget{[](Config& c) -> std::string& { return c.log.level; }, kLevels}},
    Field{"log.format", "", "format of a log line: text, or one JSON object",
          WordTarget{[](Config& c) -> std::string& { return c.log.format; }, kLogFormats}},
};

constexpr std::array kRenamedKeys{
    RenamedKey{"http", "http.listen"},
    RenamedKey{"limits.handshakes_under_way", "limits.handshakes_in_flight"},
};

}  // namespace

std::span<const Field> fields() {
  return kFields;
}

const Field* find_field(std::string_view key) {
  const auto found =
      std::find_if(kFields.begin(), kFields.end(), [&](const Field& field) { return field.key == key; });
  return found == kFields.end() ? nullptr : &*found;
}

Counts counts(const Field& field) {
  const std::string_view key = field.key;
  if (key.starts_with("rates.") || key == "access.blocked_file" || key == "access.revoked_file" ||
      key.starts_with("shutdown.") || key.starts_with("balance.")) {
    return Counts::at_once;
  }
  if (!(key.starts_with("limits.") || key.starts_with("edits.")) || key == "limits.memory_bytes" ||
      key == "edits.settle" || key.starts_with("edits.history_")) {
    return Counts::after_restart;
  }
  return Counts::for_new_sessions;
}

std::span<const RenamedKey> renamed_keys() {
  return kRenamedKeys;
}

const RenamedKey* find_renamed(std::string_view old_key) {
  const auto* const found =
      std::find_if(kRenamedKeys.begin(), kRenamedKeys.end(),
                   [&](const RenamedKey& renamed) { return renamed.old_key == old_key; });
  return found == kRenamedKeys.end() ? nullptr : found;
}

std::string variable_name(std::string_view key) {
  std::string name = "TALUS_";
  for (const char c : key) {
    const bool lower = c >= 'a' && c <= 'z';
    name += c == '.' ? '_' : lower ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return name;
}

}  // namespace talus::server
