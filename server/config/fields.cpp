#include "config/fields.h"

#include <algorithm>
#include <array>

namespace talus::server {
namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;
constexpr milliseconds kDay = std::chrono::hours{24};
constexpr milliseconds kMinTimeout{10};
constexpr std::uint64_t kMaxPerSecond = 0xFFFF'FFFF;  // limits/rates/token_bucket.h

constexpr std::array<std::string_view, 2> kPublish{"none", "public"};
constexpr std::array<std::string_view, 2> kLogFormats{"text", "json"};
constexpr std::array<std::string_view, 6> kLevels{"trace", "debug", "info", "warning", "error", "off"};
constexpr std::array<std::string_view, 5> kRights{"read", "read,edit", "read,edit,admin", "read,edit,gateway",
                                                  "read,edit,admin,gateway"};
constexpr std::array<std::string_view, 1> kSecretLayers{"veins"};
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
    Field{"listen", "HOST:PORT",
          "address for game clients; IPv6 as [::]:4780; port 0: a free port, which talusd prints",
          EndpointTarget{[](Config& c) -> protocol::Endpoint& { return c.listen; }}},
    Field{"admin", "HOST:PORT",
          "address for operators over HTTP; it asks for no password, so choose one that players cannot "
          "reach, such as 127.0.0.1:4781",
          OptionalEndpointTarget{[](Config& c) -> std::optional<protocol::Endpoint>& { return c.admin; }}},
    Field{
        "data", "directory",
        "directory for one world's edits, created if missing; empty: no edits are taken, and nothing is kept",
        PathTarget{[](Config& c) -> std::filesystem::path& { return c.data; }}},
    Field{"world", "file", "the world's spec, a TOML file; empty: the world built into talusd",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.world; }}},
    Field{"publish", "",
          "public: clients get the world's file, so that they can make chunks themselves and are sent only "
          "edits; it tells every ore and cave",
          WordTarget{[](Config& c) -> std::string& { return c.publish; }, kPublish}},
    Field{"publish_files", "switch",
          "true: height maps over 1 MiB are published too; without them their worlds are not",
          SwitchTarget{[](Config& c) -> bool& { return c.publish_files; }}},
    Field{"user", "user, as NAME, UID or UID:GID",
          "user to switch to after binding ports and reading keys, if started as root; empty: talusd stays "
          "root, with a warning",
          TextTarget{[](Config& c) -> std::string& { return c.user; }}},
    Field{
        "proxies", "networks",
        "addresses and networks of proxies in front, separated by commas; their connections must begin with "
        "a PROXY header, version 2, whose address limits and log use; from other addresses it is an error",
        NetworksTarget{[](Config& c) -> Networks& { return c.proxies; }}},

    Field{"access.secret_file", "file",
          "file with a secret of 16 to 1,024 bytes that clients may send as their token",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.secret_file; }}},
    Field{"access.secret_rights", "rights", "rights of clients that send the secret",
          WordTarget{[](Config& c) -> std::string& { return c.access.secret_rights; }, kRights}},
    Field{"access.signing_key_file", "file",
          "file with the key that signs tokens, 32 to 4,096 bytes; empty: signed tokens are refused",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.signing_key_file; }}},
    Field{"access.previous_signing_key_file", "file",
          "file with the previous signing key, whose tokens are accepted until they expire",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.previous_signing_key_file; }}},
    Field{"access.revoked_file", "file", "file that lists revoked signed tokens",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.revoked_file; }}},
    Field{"access.blocked_file", "file",
          "file that lists addresses, networks and token subjects that are not served",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.blocked_file; }}},
    Field{"access.without_token", "rights",
          "rights of clients without a token; auto: none if a secret or a key is set, else read",
          WordTarget{[](Config& c) -> std::string& { return c.access.without_token; }, kRightsWithoutToken}},

    Field{"secret.key_file", "file",
          "file with the key that draws the secret layers: 32 random bytes, the same on all servers of the "
          "world; keep a copy, as the world cannot be served without it",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.secret.key_file; }}},
    Field{"secret.layers", "", "what the key draws; veins: the ores",
          WordsTarget{[](Config& c) -> std::vector<std::string>& { return c.secret.layers; }, kSecretLayers}},

    Field{"edits.protected", "boxes",
          "boxes X,Z:X,Z or X,Y,Z:X,Y,Z, separated by semicolons, that only tokens with the right admin may "
          "edit",
          BoxesTarget{[](Config& c) -> Boxes& { return c.edits.protected_boxes; }}},
    Field{"edits.protect_spawn", "columns",
          "distance from the world's spawn, at all heights, within which only tokens with the right admin "
          "may edit; 0: off",
          number<&Config::edits, &Edits::protect_spawn>(0, 65'536)},
    Field{"edits.gateway", "", "required: only sessions with the right gateway, of game servers, may edit",
          WordTarget{[](Config& c) -> std::string& { return c.edits.gateway; }, kGateway}},
    Field{"edits.settle", "switch",
          "true: loose material (gravel, soil, sand) that edits undermine or place slides to its angle of "
          "repose",
          SwitchTarget{[](Config& c) -> bool& { return c.edits.settle; }}},
    Field{"edits.history_bytes", "bytes",
          "disk for the history of edits (talusd store history, rollback); the oldest records go first",
          number<&Config::edits, &Edits::history_bytes>(16 * kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"edits.history_days", "days", "time that a record of the history is kept",
          number<&Config::edits, &Edits::history_days>(1, 3650)},

    Field{
        "tls.certificate", "file",
        "PEM file with the certificate and its chain; clients then connect by TLS 1.3 only; empty: plain TCP",
        PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.certificate; }}},
    Field{"tls.key", "file", "PEM file with its key, without a passphrase",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.key; }}},

    Field{"http.listen", "HOST:PORT", "address for HTTP and WebSocket of players, such as 0.0.0.0:4782",
          OptionalEndpointTarget{
              [](Config& c) -> std::optional<protocol::Endpoint>& { return c.http.listen; }}},
    Field{"http.web", "directory", "directory served at / of http.listen, read at the start: the viewer",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.http.web; }}},
    Field{"http.tls", "switch",
          "true: HTTP uses TLS if tls.certificate is set; false: a proxy in front speaks TLS",
          SwitchTarget{[](Config& c) -> bool& { return c.http.tls; }}},
    Field{"http.public_chunks", "switch", "true: chunks need no token, so that every cache may keep them",
          SwitchTarget{[](Config& c) -> bool& { return c.http.public_chunks; }}},
    Field{
        "http.origins", "origins",
        "origins whose pages may read and stream, in addition to the server's own and, if http.listen is a "
        "loopback address and proxies is empty, those of loopback addresses; *: all; empty: others may only "
        "read what every cache may keep",
        OriginsTarget{[](Config& c) -> AllowedOrigins& { return c.http.origins; }}},
    Field{"http.log_every", "answers", "number of HTTP answers of which one is logged; 0: off",
          number<&Config::http, &Http::log_every>(0, 1'000'000'000)},

    Field{"cluster.nats", "addresses",
          "NATS servers that hold the shared log; tls:// for all if there are passwords or tokens; empty: "
          "this server is alone",
          UrlsTarget{[](Config& c) -> ServerUrls& { return c.cluster.nats; }, kNatsSchemes}},
    Field{"cluster.store", "id of a store",
          "id of the world's store, 32 hexadecimal digits; empty: the id in the data directory, or of the "
          "peer whose store is taken",
          TextTarget{[](Config& c) -> std::string& { return c.cluster.store; }}},
    Field{"cluster.user", "user's name",
          "user at the NATS servers, with password_file; set at most one of user, token_file and nkey_file",
          TextTarget{[](Config& c) -> std::string& { return c.cluster.user; }}},
    Field{"cluster.password_file", "file", "file with the user's password",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.password_file; }}},
    Field{"cluster.token_file", "file", "file with a token for the NATS servers",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.token_file; }}},
    Field{"cluster.nkey_file", "file", "file with an NKey's seed, a line that begins with SU",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.nkey_file; }}},
    Field{"cluster.ca", "file", "PEM file with the authorities of NATS servers (tls://) and peers (https://)",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.ca; }}},
    Field{"cluster.certificate", "file", "PEM file with this server's certificate for NATS servers and peers",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.certificate; }}},
    Field{"cluster.key", "file", "PEM file with its key, without a passphrase",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.key; }}},
    Field{"cluster.peers", "addresses",
          "other servers' admin addresses, such as https://10.0.1.2:4781, to take a store from if the log "
          "does not reach back far enough",
          UrlsTarget{[](Config& c) -> ServerUrls& { return c.cluster.peers; }, kPeerSchemes}},
    Field{"cluster.peers_token_file", "file", "file with a token with the right admin, which peers require",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.cluster.peers_token_file; }}},
    Field{"cluster.replicas", "NATS servers",
          "NATS servers that hold the log of talusd cluster init: 1, 3 or 5",
          number<&Config::cluster, &Cluster::replicas>(1, 5)},

    Field{"threads.io", "threads", "threads that serve sockets; 0: one per core",
          number<&Config::threads, &Threads::io>(0, 1024)},
    Field{"threads.generator", "threads", "threads that generate chunks; 0: one per core",
          number<&Config::threads, &Threads::generator>(0, 1024)},

    Field{"limits.connections", "connections",
          "open connections in all; protects memory and file descriptors",
          number<&Config::limits, &Limits::connections>(1, 1'000'000)},
    Field{"limits.connections_per_address", "connections",
          "open connections of one address; raise it for players behind NAT",
          number<&Config::limits, &Limits::connections_per_address>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_per_second", "connections",
          "new connections of one address per second, in the long run; protects CPU time",
          number<&Config::limits, &Limits::handshakes_per_address_per_second>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_burst", "connections",
          "new connections of one address at once, after a pause, as of players behind one NAT who reconnect",
          number<&Config::limits, &Limits::handshakes_per_address_burst>(1, 1'000'000)},
    Field{"limits.handshakes_in_flight", "connections", "unfinished TLS handshakes and PROXY headers in all",
          number<&Config::limits, &Limits::handshakes_in_flight>(1, 1'000'000)},
    Field{"limits.frame_bytes", "bytes", "size of a client's frame, with its length prefix",
          number<&Config::limits, &Limits::frame_bytes>(protocol::kMinClientFrameBytes, 16 * kMebibyte)},
    Field{"limits.requests_in_flight", "requests", "unanswered chunk and height requests of a session",
          number<&Config::limits, &Limits::requests_in_flight>(1, 65'536)},
    Field{"limits.handshake_timeout_ms", "ms",
          "time from the connection to the client's whole Hello, with PROXY header and TLS",
          duration<&Config::limits, &Limits::handshake_timeout>(kMinTimeout, kDay)},
    Field{"limits.idle_timeout_ms", "ms",
          "time without a whole frame from the client; idle clients send Ping",
          duration<&Config::limits, &Limits::idle_timeout>(kMinTimeout, kDay)},
    Field{"limits.write_timeout_ms", "ms", "time in which the client reads nothing that it is sent",
          duration<&Config::limits, &Limits::write_timeout>(kMinTimeout, kDay)},
    Field{"limits.queued_bytes_per_session", "bytes",
          "answers queued for a client; above it, and above a quarter of it in unanswered edits, the server "
          "stops reading from the client",
          number<&Config::limits, &Limits::queued_bytes_per_session>(64 * 1024, 1024 * kMebibyte)},
    Field{"limits.window_bytes", "bytes",
          "Chunk frames in flight that the client has not acknowledged by Credit; protects its link",
          number<&Config::limits, &Limits::window_bytes>(1024, 1024 * kMebibyte)},
    Field{"limits.heights_per_request", "columns", "columns in one GetHeights",
          number<&Config::limits, &Limits::heights_per_request>(1, protocol::kMaxHeightsPerRequest)},
    Field{"limits.view_horizontal_radius", "chunks",
          "radius of a View along x and z; 2^l times that at level l",
          number<&Config::limits, &Limits::view_horizontal_radius>(0, 512)},
    Field{"limits.view_vertical_radius", "chunks", "radius of a View along y; 2^l times that at level l",
          number<&Config::limits, &Limits::view_vertical_radius>(0, 512)},
    Field{"limits.view_chunks", "chunks", "chunks of all levels in a View",
          number<&Config::limits, &Limits::view_chunks>(1, 4'194'304)},
    Field{"limits.memory_bytes", "bytes",
          "memory budget; near it caches shrink, then new work and connections are refused; 0: no limit, "
          "else at least 75497472 with up to 16 threads",
          number<&Config::limits, &Limits::memory_bytes>(0, 1024 * 1024 * kMebibyte)},

    Field{"rates.session_chunks", "chunks per second", "chunks sent to a session; further chunks wait",
          number<&Config::rates, &Rates::session_chunks>(0, kMaxPerSecond)},
    Field{"rates.session_bytes", "bytes per second",
          "bytes sent to a session; further chunks wait; new requests are refused while it owes more than a "
          "burst and 8 KiB",
          number<&Config::rates, &Rates::session_bytes>(0, kMaxPerSecond)},
    Field{"rates.session_requests", "requests per second",
          "chunks and heights requested by id, Views, Pings and Edits of a session; more are refused with a "
          "time to retry",
          number<&Config::rates, &Rates::session_requests>(0, kMaxPerSecond)},
    Field{"rates.address_chunks", "chunks per second",
          "chunks sent to an address; each session reserves what 10 ms earn, at most 16 chunks and 32 KiB",
          number<&Config::rates, &Rates::address_chunks>(0, kMaxPerSecond)},
    Field{"rates.address_bytes", "bytes per second", "bytes sent to an address",
          number<&Config::rates, &Rates::address_bytes>(0, kMaxPerSecond)},
    Field{"rates.address_requests", "requests per second", "requests accepted from an address",
          number<&Config::rates, &Rates::address_requests>(0, kMaxPerSecond)},
    Field{"rates.session_voxels", "voxels per second",
          "voxels that a session's edits name, with fills, pastes and guards; a burst holds at least one "
          "edit of 65,536 voxels",
          number<&Config::rates, &Rates::session_voxels>(0, kMaxPerSecond)},
    Field{"rates.address_voxels", "voxels per second", "voxels that an address's edits name",
          number<&Config::rates, &Rates::address_voxels>(0, kMaxPerSecond)},
    Field{"rates.address_editors", "editors per hour",
          "new editors of an address, each remembered for a day; resuming one is free; eight hours are saved "
          "up; auto: 512, or fewer with little limits.memory_bytes (65 at 256 MiB, 18 at 72 MiB)",
          OptionalNumberTarget{
              [](Config& c) -> std::optional<std::uint64_t>& { return c.rates.address_editors; }, 0, 65'536}},
    Field{"rates.address_new_chunks", "chunks per hour",
          "unedited chunks that an address's edits may write, settle into or guard; a session pays for each "
          "of its last 128 once; eight hours are saved up; at most what fills the index of edited chunks in "
          "32 hours counts",
          number<&Config::rates, &Rates::address_new_chunks>(0, 16'777'216)},
    Field{"rates.gateway_requests", "requests per second",
          "requests accepted from a session with the right gateway, instead of session_requests and "
          "address_requests",
          number<&Config::rates, &Rates::gateway_requests>(0, kMaxPerSecond)},
    Field{"rates.gateway_voxels", "voxels per second",
          "voxels that such a session's edits name, instead of session_voxels and address_voxels",
          number<&Config::rates, &Rates::gateway_voxels>(0, kMaxPerSecond)},
    Field{"rates.checkpoint_bytes", "bytes per second",
          "bytes sent to all servers that take a checkpoint of the store",
          number<&Config::rates, &Rates::checkpoint_bytes>(262'144, kMaxPerSecond)},
    Field{"rates.burst_ms", "ms", "time for which an idle session or address saves up each rate",
          duration<&Config::rates, &Rates::burst>(milliseconds{1}, milliseconds{600'000})},

    Field{"cache.chunk_bytes", "bytes",
          "cache of encoded chunks; an eighth holds map tiles if http.listen is set",
          number<&Config::cache, &Cache::chunk_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"cache.patch_bytes", "bytes", "cache of terrain, from which neighbouring chunks are extracted",
          number<&Config::cache, &Cache::patch_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"cache.disk_bytes", "bytes",
          "cache of chunks in the data directory, which outlives a restart, without chunks that are cheap to "
          "generate; 0: off",
          number<&Config::cache, &Cache::disk_bytes>(0, 1024 * 1024 * kMebibyte)},

    Field{"generation.patch_tiles", "tiles",
          "edge of the terrain generated at once, in tiles of 32 columns; 0: 1, 2 or 4, by its measured cost "
          "and limits.memory_bytes",
          PowerOfTwoTarget{[](Config& c) -> std::uint64_t& { return c.generation.patch_tiles; }, 16}},
    Field{"generation.queue_chunks", "chunks",
          "chunks that wait for a generator; more are refused, except for clients that wait for nothing",
          number<&Config::generation, &Generation::queue_chunks>(1, 16'777'216)},

    Field{"shutdown.lead_ms", "ms",
          "time from SIGTERM, when /-/ready becomes 503, until connections are refused, so that a balancer "
          "sends new players elsewhere; 0: this server is alone",
          duration<&Config::shutdown, &Shutdown::lead>(milliseconds{0}, kDay)},
    Field{"shutdown.drain_ms", "ms",
          "time to send pending answers before the server ends; after a lead, players are sent away in its "
          "first half",
          duration<&Config::shutdown, &Shutdown::drain>(milliseconds{0}, kDay)},

    Field{"balance.per_second", "sessions per second",
          "sessions sent to other servers while this one has more than its share; 0: off",
          number<&Config::balance, &Balance::per_second>(0, 100'000)},
    Field{"balance.above_percent", "percent", "excess over its share that this server may have",
          number<&Config::balance, &Balance::above_percent>(0, 1000)},
    Field{"balance.session_ms", "ms", "age below which a session is not sent away",
          duration<&Config::balance, &Balance::session>(milliseconds{0}, kDay)},

    Field{"log.level", "", "lowest level logged",
          WordTarget{[](Config& c) -> std::string& { return c.log.level; }, kLevels}},
    Field{"log.format", "", "text, or one JSON object a line with time, level and text",
          WordTarget{[](Config& c) -> std::string& { return c.log.format; }, kLogFormats}},
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

std::string variable_name(std::string_view key) {
  std::string name = "TALUS_";
  for (const char c : key) {
    const bool lower = c >= 'a' && c <= 'z';
    name += c == '.' ? '_' : lower ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return name;
}

}  // namespace talus::server
