#include "command_line/connect_options.h"

#include <algorithm>
#include <cstdlib>

#include <CLI/CLI.hpp>

#include <talus/files/path_text.h>
#include <talus/files/read_file.h>
#include <talus/protocol/limits.h>

namespace talus::command_line {
namespace {

constexpr std::size_t kMaxTokenBytes = protocol::kMaxStringBytes;
constexpr std::string_view kWebSocket = "ws://";
constexpr std::string_view kSecureWebSocket = "wss://";
constexpr std::string_view kSchemeEnd = "://";

tl::expected<std::string, std::string> read_token(const ConnectWords& words) {
  if (words.token_file.empty()) return words.token;
  const auto wrong = [&](const std::string& what) {
    return tl::unexpected{"--token-file " + words.token_file + ": " + what};
  };
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  constexpr std::size_t kAddedBytes = 16;  // by editors: the mark, and line ends
  auto text = files::read_file(files::to_path(words.token_file), kMaxTokenBytes + kAddedBytes);
  if (!text && text.error().code != std::errc::file_too_large) return wrong(text.error().reason);
  if (text && text->starts_with(kByteOrderMark)) text->erase(0, kByteOrderMark.size());
  while (text && (text->ends_with('\n') || text->ends_with('\r'))) text->pop_back();
  if (!text || text->empty() || text->size() > kMaxTokenBytes) {
    return wrong("holds no token; give a file with 1 to " + std::to_string(kMaxTokenBytes) + " bytes");
  }
  return *std::move(text);
}

/// Error of an address whose scheme is unknown, or not in front of the first address.
std::string scheme_error(const ConnectWords& words, std::string_view address) {
  const std::string_view scheme = address.substr(0, address.find(kSchemeEnd) + kSchemeEnd.size());
  std::string text = "--connect " + words.connect + ": ";
  if (scheme == kWebSocket || scheme == kSecureWebSocket) {
    return text + "write " + std::string{scheme} + " once, before the first address: it is for all of them";
  }
  const bool http = scheme == "http://" || scheme == "https://";
  text += "this client does not speak " + std::string{scheme};
  if (http) text += ", but talusd's HTTP address is reached by WebSocket";
  return text + "; write HOST:PORT, with --tls for TLS, or ws://HOST:PORT[/PATH] or wss:// (by TLS)";
}

}  // namespace

void add_connect_options(CLI::App& app, ConnectWords& words) {
  app.add_option("--connect", words.connect,
                 "HOST:PORT of the server, or ws://HOST:PORT[/PATH] (wss:// by TLS) for its HTTP address; "
                 "HOST:PORT,HOST:PORT,... if several servers have the same world")
      ->capture_default_str();
  // A flag overrides both variables, so they are read only if neither flag was given.
  auto* file = app.add_option("--token-file", words.token_file,
                              "File with a token from the server's operator; default: $TALUS_TOKEN_FILE");
  auto* token = app.add_option(
      "--token", words.token,
      "The token itself; visible to all users of this machine, unlike its default $TALUS_TOKEN");
  file->excludes(token);
  app.callback([&words, file, token] {
    if (file->count() != 0 || token->count() != 0) return;
    if (const char* text = std::getenv("TALUS_TOKEN")) words.token = text;
    if (const char* name = std::getenv("TALUS_TOKEN_FILE"); name != nullptr && words.token.empty())
      words.token_file = name;
  });
  app.add_flag("--tls", words.tls.on, "Use TLS");
  app.add_option("--ca", words.tls.ca_file,
                 "Use TLS and trust the certificates in this PEM file (default: the system's certificates)");
  app.add_option("--tls-name", words.tls.server_name,
                 "Use TLS and expect a certificate for this name (default: the host of --connect)");
  app.add_flag("--websocket", words.websocket,
               "Connect by WebSocket, as ws:// in --connect: to talusd's HTTP address (--http) or a proxy");
}

tl::expected<ConnectOptions, std::string> read_connect_options(const ConnectWords& words) {
  ConnectOptions options;
  options.tls = words.tls;
  options.websocket.on = words.websocket;
  std::string_view address = words.connect;
  const bool secure = address.starts_with(kSecureWebSocket);
  if (secure || address.starts_with(kWebSocket)) {
    options.websocket.on = true;
    address.remove_prefix((secure ? kSecureWebSocket : kWebSocket).size());
    const std::size_t slash = std::min(address.find('/'), address.size());
    if (slash + 1 < address.size()) options.websocket.path = address.substr(slash);
    address = address.substr(0, slash);
  }
  std::vector<protocol::Endpoint> servers;
  for (;;) {
    const std::size_t comma = std::min(address.find(','), address.size());
    const std::string_view one = address.substr(0, comma);
    if (one.find(kSchemeEnd) != std::string_view::npos) return tl::unexpected{scheme_error(words, one)};
    auto server = read_server_address("--connect", one);
    if (!server) return tl::unexpected{server.error()};
    servers.push_back(*std::move(server));
    if (comma == address.size()) break;
    address.remove_prefix(comma + 1);
  }
  options.server = servers.front();
  options.more_servers.assign(servers.begin() + 1, servers.end());
  auto token = read_token(words);
  if (!token) return tl::unexpected{token.error()};
  options.token = *std::move(token);
  options.tls.on = secure || words.tls.on || !words.tls.ca_file.empty() || !words.tls.server_name.empty();
  return options;
}

std::vector<client::ServerAddress> more_servers(const ConnectOptions& options) {
  std::vector<client::ServerAddress> servers;
  for (const protocol::Endpoint& server : options.more_servers) {
    servers.push_back({server.host, std::to_string(server.port)});
  }
  return servers;
}

tl::expected<protocol::Endpoint, std::string> read_server_address(std::string_view option,
                                                                  std::string_view text) {
  auto endpoint = protocol::parse_endpoint(text);
  const bool listens = endpoint && endpoint->port != 0;
  if (listens) return endpoint;
  const std::string reason =
      endpoint ? "no server listens on port 0; give one from 1 to 65535" : endpoint.error();
  return tl::unexpected{std::string{option} + " " + std::string{text} + ": " + reason};
}

}  // namespace talus::command_line
