#include "admin/top_command.h"

#include <cstdint>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <asio/ip/tcp.hpp>

#include "log/escape.h"

namespace talus::server {
namespace {

tl::unexpected<Exit> top_refused(const std::string& text, int status) {
  return tl::make_unexpected(Exit{fmt::format("talusd top: {}\n", on_one_line(text)), status});
}

}  // namespace

tl::expected<TopCommand, Exit> read_top_command(int argc, const char* const* argv,
                                                const Environment& environment) {
  CLI::App app{
      "Shows the ten flows that use most of a running talusd: by generator time, bytes sent, and refusals.\n"
      "A flow is an address (IPv6: a /64 network), or a token's subject.",
      "talusd top"};
  app.footer(
      "Units: ms/s are ms of processor time of generator threads a second, /min refusals a minute: of\n"
      "requests that were too many or too fast, and of connections. The rates are weighted by age, as load\n"
      "averages are, over 10 s and 1 min; the share is that of all flows over 1 min; totals count since a\n"
      "flow is listed. A name is as access.blocked_file has it, unless it ends in \"...\": then it was cut, "
      "and\n"
      "/flows.json on the same port has the whole subject, up to 120 bytes.\n"
      "On a terminal the page is shown again and again until Ctrl-C, elsewhere once.\n"
      "Exit status: 0 success, 1 failure, 2 wrong flags.");
  std::string admin;
  std::string config_file;
  std::int64_t interval = TopCommand{}.interval.count();
  app.add_option("--admin", admin,
                 "the server's address for operators; default: \"admin\" of --config, or TALUS_ADMIN")
      ->type_name("HOST:PORT");
  app.add_option("--config", config_file, "the server's settings in TOML; default: no file")
      ->type_name("FILE");
  app.add_option("--interval", interval, "seconds between two looks, on a terminal")
      ->type_name("SECONDS")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  if (auto exit = parse_flags(app, argc, argv)) return tl::make_unexpected(*std::move(exit));

  TopCommand command;
  command.interval = std::chrono::seconds{interval};
  if (!admin.empty()) {
    auto endpoint = protocol::parse_endpoint(admin);
    if (!endpoint) {
      return top_refused(fmt::format("--admin: \"{}\": {}", escaped(admin), endpoint.error()), kWrongUse);
    }
    command.admin = *std::move(endpoint);
    return command;
  }
  Settings settings;
  if (!config_file.empty()) {
    if (auto done = apply_file(settings, config_file); !done) return top_refused(done.error(), kFailed);
  }
  if (auto done = apply_environment(settings, environment); !done) return top_refused(done.error(), kFailed);
  if (!settings.config.admin) {
    return top_refused("no address of operators; give --admin HOST:PORT, as talusd has it", kWrongUse);
  }
  command.admin = *settings.config.admin;
  return command;
}

tl::expected<std::string, std::string> fetch_flows(const protocol::Endpoint& admin) {
  const std::string where = fmt::format("http://{}/flows", to_string(admin));
  constexpr std::chrono::seconds kLongest{5};
  asio::ip::tcp::iostream stream;
  stream.expires_after(kLongest);
  stream.connect(admin.host, std::to_string(admin.port));
  stream << "GET /flows HTTP/1.1\r\nHost: " << admin.host << "\r\nConnection: close\r\n\r\n" << std::flush;
  std::ostringstream answer;
  if (stream) answer << stream.rdbuf();
  const std::string text = answer.str();
  if (text.empty()) {
    return tl::make_unexpected(
        fmt::format("{}: {}", where, stream.error() ? stream.error().message() : "no answer"));
  }
  const auto body = text.find("\r\n\r\n");
  if (!text.starts_with("HTTP/1.1 200 ") || body == std::string::npos) {
    return tl::make_unexpected(fmt::format("{}: \"{}\" is not the answer of a talusd of this version", where,
                                           escaped(text.substr(0, text.find('\r')), 80)));
  }
  return text.substr(body + 4);
}

}  // namespace talus::server
