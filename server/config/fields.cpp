#include "config/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include <fmt/format.h>

#include "log/escape.h"

namespace talus::server {
namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;
constexpr std::uint64_t kDayMs = 86'400'000;
constexpr std::uint64_t kMostPerSecond = 0xFFFF'FFFF;  // rates/token_bucket.h

constexpr std::array<std::string_view, 2> kLogFormats{"text", "json"};
constexpr std::array<std::string_view, 6> kLevels{"trace", "debug", "info", "warning", "error", "off"};
constexpr std::array<std::string_view, 3> kRights{"read", "read,edit", "read,edit,admin"};
constexpr std::array<std::string_view, 4> kRightsWithoutToken{"auto", "none", "read", "read,edit"};

template <typename Group, Group Config::*group, std::uint64_t Group::*member>
std::uint64_t& number_at(Config& config) {
  return config.*group.*member;
}

template <auto group, auto member>
struct Place;
template <typename Group, Group Config::*group, std::uint64_t Group::*member>
struct Place<group, member> {
  static constexpr auto at = &number_at<Group, group, member>;
};

template <auto group, auto member>
constexpr NumberTarget number(std::uint64_t least, std::uint64_t most) {
  return {Place<group, member>::at, least, most};
}

const std::array kFields{
    Field{"listen", "HOST:PORT", "where game clients connect; port 0 takes a free one",
          EndpointTarget{[](Config& c) -> Endpoint& { return c.listen; }}},
    Field{"http", "HOST:PORT", "public HTTP and WebSocket; accepted, not served yet; empty: none",
          OptionalEndpointTarget{[](Config& c) -> std::optional<Endpoint>& { return c.http; }}},
    Field{"admin", "HOST:PORT",
          "metrics and health for operators, over HTTP; not for the open network; empty: none",
          OptionalEndpointTarget{[](Config& c) -> std::optional<Endpoint>& { return c.admin; }}},
    Field{"data", "directory", "what must outlive the server; empty: nothing is kept",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.data; }}},
    Field{"world", "file", "the world's spec; empty: the world built into talusd",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.world; }}},
    Field{"user", "user, as NAME, UID or UID:GID",
          "whom talusd becomes where root starts it, when it has its addresses and keys; empty: nobody else",
          TextTarget{[](Config& c) -> std::string& { return c.user; }}},

    Field{"access.secret_file", "file", "the secret that clients may show as their token; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.secret_file; }}},
    Field{"access.secret_rights", "rights", "of clients that show the secret",
          WordTarget{[](Config& c) -> std::string& { return c.access.secret_rights; }, kRights}},
    Field{"access.signing_key_file", "file",
          "the key of signed tokens, as talusd token makes them; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.signing_key_file; }}},
    Field{"access.previous_signing_key_file", "file",
          "the key before it, whose tokens are still good; empty: none",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.access.previous_signing_key_file; }}},
    Field{"access.without_token", "rights",
          "of clients without a token; auto: none where one of the files is given, else read",
          WordTarget{[](Config& c) -> std::string& { return c.access.without_token; }, kRightsWithoutToken}},

    Field{"proxies", "networks",
          "whose PROXY headers (version 2) are believed, and without which they are refused; empty: nobody's",
          NetworksTarget{[](Config& c) -> Networks& { return c.proxies; }}},

    Field{"tls.certificate", "file", "PEM, with the chain; SIGHUP reads it again; empty: no TLS",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.certificate; }}},
    Field{"tls.key", "file", "PEM, without passphrase, of the certificate",
          PathTarget{[](Config& c) -> std::filesystem::path& { return c.tls.key; }}},

    Field{"threads.io", "threads", "threads that serve sockets; 0: as many as the machine's cores",
          number<&Config::threads, &Threads::io>(0, 1024)},
    Field{"threads.generator", "threads", "threads that generate chunks; 0: as many as the machine's cores",
          number<&Config::threads, &Threads::generator>(0, 1024)},

    Field{"limits.connections", "connections", "in all; one more is refused",
          number<&Config::limits, &Limits::connections>(1, 1'000'000)},
    Field{"limits.connections_per_address", "connections", "from one IPv4 address or one IPv6 /64 network",
          number<&Config::limits, &Limits::connections_per_address>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_per_second", "connections",
          "that an address, counted as above, may begin in the long run",
          number<&Config::limits, &Limits::handshakes_per_address_per_second>(1, 1'000'000)},
    Field{"limits.handshakes_per_address_burst", "connections", "that it may begin at once after a rest",
          number<&Config::limits, &Limits::handshakes_per_address_burst>(1, 1'000'000)},
    Field{"limits.handshakes_under_way", "connections",
          "in all whose TLS handshake or PROXY header is not done; one more is refused",
          number<&Config::limits, &Limits::handshakes_under_way>(1, 1'000'000)},
    Field{"limits.frame_bytes", "bytes", "of one frame from a client, its length prefix included",
          number<&Config::limits, &Limits::frame_bytes>(protocol::kMinClientFrameBytes, 16 * kMebibyte)},
    Field{"limits.requests_in_flight", "requests", "chunk and height requests of a session not yet answered",
          number<&Config::limits, &Limits::requests_in_flight>(1, 65'536)},
    Field{"limits.handshake_timeout_ms", "ms",
          "from the connection to a whole Hello, PROXY header and TLS included",
          number<&Config::limits, &Limits::handshake_timeout_ms>(10, kDayMs)},
    Field{"limits.idle_timeout_ms", "ms", "without a whole frame from the client",
          number<&Config::limits, &Limits::idle_timeout_ms>(10, kDayMs)},
    Field{"limits.write_timeout_ms", "ms", "in which a client that is sent something reads none of it",
          number<&Config::limits, &Limits::write_timeout_ms>(10, kDayMs)},
    Field{"limits.queued_bytes_per_session", "bytes",
          "of answers that wait in memory for one client; above it nothing more is read from it",
          number<&Config::limits, &Limits::queued_bytes_per_session>(64 * 1024, 1024 * kMebibyte)},
    Field{"limits.window_bytes", "bytes", "of Chunk frames that a client may leave without Credit",
          number<&Config::limits, &Limits::window_bytes>(1024, 1024 * kMebibyte)},
    Field{"limits.heights_per_request", "columns", "in one GetHeights",
          number<&Config::limits, &Limits::heights_per_request>(1, protocol::kMaxHeightsPerRequest)},
    Field{"limits.view_horizontal_radius", "chunks",
          "of a View along x and z, in chunks of level 0; a ring of level l may reach 2^l times as far",
          number<&Config::limits, &Limits::view_horizontal_radius>(0, 512)},
    Field{"limits.view_vertical_radius", "chunks", "of a View along y, in chunks of level 0",
          number<&Config::limits, &Limits::view_vertical_radius>(0, 512)},
    Field{"limits.view_chunks", "chunks", "of all levels in one View",
          number<&Config::limits, &Limits::view_chunks>(1, 4'194'304)},
    Field{"limits.memory_bytes", "bytes",
          "of memory in all: near it caches shrink, then new work and connections are refused; 0: no limit",
          number<&Config::limits, &Limits::memory_bytes>(0, 1024 * 1024 * kMebibyte)},

    Field{"rates.session_chunks", "chunks a second", "sent to one session; 0: no limit",
          number<&Config::rates, &Rates::session_chunks>(0, kMostPerSecond)},
    Field{"rates.session_bytes", "bytes a second", "sent to one session; chunks wait for it; 0: no limit",
          number<&Config::rates, &Rates::session_bytes>(0, kMostPerSecond)},
    Field{"rates.session_requests", "requests a second",
          "of one session; those beyond are refused; 0: no limit",
          number<&Config::rates, &Rates::session_requests>(0, kMostPerSecond)},
    Field{"rates.address_chunks", "chunks a second", "sent to all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_chunks>(0, kMostPerSecond)},
    Field{"rates.address_bytes", "bytes a second", "sent to all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_bytes>(0, kMostPerSecond)},
    Field{"rates.address_requests", "requests a second", "of all sessions of one address; 0: no limit",
          number<&Config::rates, &Rates::address_requests>(0, kMostPerSecond)},
    Field{"rates.burst_ms", "ms", "of each rate, saved up for when more is wanted at once",
          number<&Config::rates, &Rates::burst_ms>(1, 600'000)},

    Field{"cache.chunk_bytes", "bytes", "of encoded chunks kept in memory",
          number<&Config::cache, &Cache::chunk_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},
    Field{"cache.patch_bytes", "bytes", "of terrain kept so that neighbouring chunks are cheap",
          number<&Config::cache, &Cache::patch_bytes>(kMebibyte, 1024 * 1024 * kMebibyte)},

    Field{"generation.patch_tiles", "tiles",
          "along each edge of the square of terrain that is generated at once; a tile is 32 columns",
          number<&Config::generation, &Generation::patch_tiles>(1, 16)},
    Field{"generation.queue_chunks", "chunks",
          "of all clients that wait for a generator; above it requests are refused",
          number<&Config::generation, &Generation::queue_chunks>(1, 16'777'216)},

    Field{"shutdown.drain_ms", "ms", "in which pending answers are still sent before the server ends",
          number<&Config::shutdown, &Shutdown::drain_ms>(0, kDayMs)},

    Field{"log.level", "", "the least important lines that are written",
          WordTarget{[](Config& c) -> std::string& { return c.log.level; }, kLevels}},
    Field{"log.format", "", "how a line is written: for people, or one JSON object",
          WordTarget{[](Config& c) -> std::string& { return c.log.format; }, kLogFormats}},
};

tl::unexpected<std::string> refused(const Field& field, std::string_view value) {
  return tl::make_unexpected(fmt::format("{} is wrong; give {}", value, expectation(field)));
}

tl::expected<void, std::string> assign_number(const Field& field, const NumberTarget& target, Config& config,
                                              std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool whole = !text.empty() && error == std::errc{} && stop == end;
  if (!whole || value < target.least || value > target.most) {
    return refused(field, fmt::format("\"{}\"", escaped(text)));
  }
  target.at(config) = value;
  return {};
}

/// Assigns a text to each kind of target.
struct AssignText {
  const Field& field;
  Config& config;
  std::string_view text;

  tl::expected<void, std::string> operator()(const NumberTarget& target) const {
    return assign_number(field, target, config, text);
  }
  tl::expected<void, std::string> operator()(const EndpointTarget& target) const {
    auto endpoint = parse_endpoint(text);
    if (!endpoint) return tl::make_unexpected(endpoint.error());
    target.at(config) = *std::move(endpoint);
    return {};
  }
  tl::expected<void, std::string> operator()(const OptionalEndpointTarget& target) const {
    if (text.empty()) {
      target.at(config).reset();
      return {};
    }
    auto endpoint = parse_endpoint(text);
    if (!endpoint) return tl::make_unexpected(endpoint.error());
    target.at(config) = *std::move(endpoint);
    return {};
  }
  tl::expected<void, std::string> operator()(const PathTarget& target) const {
    // The system would read the path only up to it.
    if (text.find('\0') != std::string_view::npos)
      return refused(field, fmt::format("\"{}\"", escaped(text)));
    target.at(config) = std::filesystem::path{text};
    return {};
  }
  tl::expected<void, std::string> operator()(const NetworksTarget& target) const {
    auto networks = Networks::parse(text);
    if (!networks) return tl::make_unexpected(networks.error());
    target.at(config) = *std::move(networks);
    return {};
  }
  tl::expected<void, std::string> operator()(const WordTarget& target) const {
    if (std::find(target.words.begin(), target.words.end(), text) == target.words.end()) {
      return refused(field, fmt::format("\"{}\"", escaped(text)));
    }
    target.at(config) = std::string{text};
    return {};
  }
  tl::expected<void, std::string> operator()(const TextTarget& target) const {
    target.at(config) = std::string{text};
    return {};
  }
};

/// Describes what each kind of target takes.
struct Describe {
  std::string_view unit;

  std::string operator()(const NumberTarget& target) const {
    return fmt::format("a whole number from {} to {} ({})", target.least, target.most, unit);
  }
  std::string operator()(const EndpointTarget&) const { return "\"HOST:PORT\""; }
  std::string operator()(const OptionalEndpointTarget&) const { return "\"HOST:PORT\" or \"\" for none"; }
  std::string operator()(const PathTarget&) const { return fmt::format("the name of a {} in quotes", unit); }
  std::string operator()(const NetworksTarget&) const {
    return "addresses and networks in one string, with commas between, or \"\" for none";
  }
  std::string operator()(const WordTarget& target) const {
    return fmt::format("one of \"{}\"", fmt::join(target.words, "\", \""));
  }
  std::string operator()(const TextTarget&) const { return fmt::format("a {} in quotes", unit); }
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

std::string variable_name(const Field& field) {
  std::string name = "TALUS_";
  for (const char c : field.key) {
    const bool lower = c >= 'a' && c <= 'z';
    name += c == '.' ? '_' : lower ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return name;
}

tl::expected<void, std::string> set_from_text(const Field& field, Config& config, std::string_view text) {
  return std::visit(AssignText{field, config, text}, field.target);
}

tl::expected<void, std::string> set_from_number(const Field& field, Config& config, std::int64_t number) {
  const auto* target = std::get_if<NumberTarget>(&field.target);
  if (target == nullptr || number < 0) return refused(field, fmt::to_string(number));
  const auto value = static_cast<std::uint64_t>(number);
  if (value < target->least || value > target->most) return refused(field, fmt::to_string(number));
  target->at(config) = value;
  return {};
}

std::string expectation(const Field& field) {
  return std::visit(Describe{field.unit}, field.target);
}

}  // namespace talus::server
