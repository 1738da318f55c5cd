#include "commands/cluster/nats_greeting.h"

#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <asio/ip/tcp.hpp>
#include <nlohmann/json.hpp>

#include <talus/protocol/endpoint.h>

#include "cluster/jetstream/json_member.h"
#include "runtime/log/escape.h"

namespace talus::server::cluster_tool {
namespace {

constexpr std::size_t kMaxGreetingBytes = 64U << 10U;

std::string greeting_text(const nlohmann::json& greeting, const char* name) {
  return escaped(jetstream::json_member<std::string>(greeting, name), 100);
}

/// Returns the first line sent unprompted or in reply to `question`; empty if nothing is sent.
tl::expected<std::string, std::string> first_line_of(const protocol::Endpoint& endpoint,
                                                     std::string_view question,
                                                     std::chrono::milliseconds patience) {
  asio::ip::tcp::iostream stream;
  stream.expires_after(patience);
  stream.connect(endpoint.host, std::to_string(endpoint.port));
  if (!stream) return tl::unexpected{fmt::format("cannot connect: {}", stream.error().message())};
  stream << question << std::flush;
  std::string line;
  for (char c = 0; line.size() < kMaxGreetingBytes && stream.get(c) && c != '\n';) line += c;
  return line;
}

}  // namespace

tl::expected<Greeting, std::string> parse_greeting(std::string_view line) {
  constexpr std::string_view kInfo = "INFO ";
  const auto no_server = [&](std::string_view why) {
    return tl::unexpected{fmt::format(
        "the peer is not a NATS server: it sent \"{}\"{}; give the port of NATS for clients, 4222 as a rule",
        escaped(line.substr(0, line.find('\r')), 60), why)};
  };
  if (!line.starts_with(kInfo)) return no_server("");
  const nlohmann::json info = nlohmann::json::parse(line.substr(kInfo.size()), nullptr, false);
  if (!info.is_object()) return no_server(", without a JSON object after INFO");
  // Without this check the errors below would blame the wrong thing.
  for (const auto& [name, is] : {std::pair{"version", &nlohmann::json::is_string},
                                 std::pair{"max_payload", &nlohmann::json::is_number_integer}}) {
    const auto member = info.find(name);
    if (member == info.end() || !((*member).*is)()) {
      return no_server(fmt::format(", without the field {}", name));
    }
  }
  return Greeting{greeting_text(info, "server_name"),
                  greeting_text(info, "version"),
                  jetstream::json_member<bool>(info, "jetstream"),
                  jetstream::json_member<bool>(info, "tls_required"),
                  jetstream::json_member<bool>(info, "tls_verify"),
                  jetstream::json_member<std::int64_t>(info, "max_payload")};
}

tl::expected<Greeting, std::string> greeting_of(std::string_view url, std::chrono::milliseconds patience) {
  const auto endpoint = protocol::parse_endpoint(url.substr(url.find("://") + 3));
  if (!endpoint) return tl::unexpected{endpoint.error()};
  auto line = first_line_of(*endpoint, "", patience);
  if (!line) return tl::unexpected{line.error()};
  // NATS speaks first. Many other servers wait for a request, and then identify themselves.
  if (line->empty()) line = first_line_of(*endpoint, "GET / HTTP/1.0\r\n\r\n", patience);
  if (!line || line->empty()) {
    return tl::unexpected{std::string{
        "does not answer, though it takes connections; give the port of NATS for clients, 4222 as a rule"}};
  }
  return parse_greeting(*line);
}

bool at_least(std::string_view version, int major, int minor) {
  int is_major = 0;
  int is_minor = 0;
  if (std::sscanf(std::string{version}.c_str(), "%d.%d", &is_major, &is_minor) != 2) return false;
  return is_major > major || (is_major == major && is_minor >= minor);
}

}  // namespace talus::server::cluster_tool
