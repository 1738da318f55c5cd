// Options for connecting to a server: addresses, TLS, WebSocket and token.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/client/options.h>
#include <talus/protocol/endpoint.h>

namespace CLI {
class App;
}

namespace talus::command_line {

/// Values as typed by the user.
struct ConnectWords {
  std::string connect = "localhost:4780";
  std::string token;
  std::string token_file;
  client::TlsOptions tls;
  bool websocket = false;
};

/// Adds --connect, --token-file (or TALUS_TOKEN_FILE), --token (or TALUS_TOKEN), --tls, --ca, --tls-name and
/// --websocket. Flags override the environment variables, which unlike flags are hidden from the list of
/// processes. `words` must outlive the parsing.
void add_connect_options(CLI::App& app, ConnectWords& words);

struct ConnectOptions {
  protocol::Endpoint server;
  std::vector<protocol::Endpoint> more_servers;  // same world
  std::string token;                             // may be empty
  client::TlsOptions tls;
  client::WebSocketOptions websocket;
};

/// An error is one line that names the option.
[[nodiscard]] tl::expected<ConnectOptions, std::string> read_connect_options(const ConnectWords& words);

/// Converts to the client library's type.
[[nodiscard]] std::vector<client::ServerAddress> more_servers(const ConnectOptions& options);

/// HOST:PORT of a listening server, so not port 0. The error names `option`.
[[nodiscard]] tl::expected<protocol::Endpoint, std::string> read_server_address(std::string_view option,
                                                                                std::string_view text);

}  // namespace talus::command_line
