#include "admin/top_command.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <asio/error.hpp>
#include <asio/io_context.hpp>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

tl::unexpected<Exit> top_refused(const std::string& text, int status) {
  return tl::make_unexpected(Exit{fmt::format("talusd top: {}\n", on_one_line(text)), status});
}

constexpr std::size_t kMaxAnswerBytes = std::size_t{1} << 20;

/// Reads Content-Length from an answer's head; nullopt if it is missing or malformed.
std::optional<std::size_t> content_length(std::string_view head) {
  constexpr std::string_view kName{"\r\nContent-Length: "};
  const std::size_t at = head.find(kName);
  if (at == std::string_view::npos) return std::nullopt;
  std::size_t length = 0;
  const char* const end = head.data() + head.size();
  const auto [stop, error] = std::from_chars(head.data() + at + kName.size(), end, length);
  if (error != std::errc{} || (stop != end && *stop != '\r')) return std::nullopt;
  return length;
}

/// Escapes control characters, so that an untrusted server cannot command the terminal.
std::string printable_lines(std::string_view page) {
  std::string lines;
  while (!page.empty()) {
    const std::string_view line = page.substr(0, page.find('\n'));
    lines += on_one_line(line);
    page.remove_prefix(line.size());
    if (page.empty()) break;
    lines += '\n';
    page.remove_prefix(1);
  }
  return lines;
}

/// Resolving a name cannot be cancelled, so it runs on a thread that is abandoned at the deadline.
std::vector<asio::ip::tcp::endpoint> resolve_until(std::chrono::steady_clock::time_point deadline,
                                                   const protocol::Endpoint& host, Resolve resolve,
                                                   std::error_code& failed) {
  struct Answer {
    std::vector<asio::ip::tcp::endpoint> addresses;
    std::error_code failed;
  };
  std::promise<Answer> promise;
  std::future<Answer> answer = promise.get_future();
  std::thread{[host, resolve = std::move(resolve), promise = std::move(promise)]() mutable {
    Answer found;
    found.addresses = resolve(host, found.failed);
    promise.set_value(std::move(found));
  }}.detach();
  if (answer.wait_until(deadline) != std::future_status::ready) {
    failed = asio::error::timed_out;
    return {};
  }
  Answer found = answer.get();
  failed = found.failed;
  return std::move(found.addresses);
}

}  // namespace

std::vector<asio::ip::tcp::endpoint> resolve_by_system(const protocol::Endpoint& host,
                                                       std::error_code& failed) {
  asio::io_context io;
  const auto results = asio::ip::tcp::resolver{io}.resolve(host.host, std::to_string(host.port), failed);
  return {results.begin(), results.end()};
}

tl::expected<TopCommand, Exit> read_top_command(int argc, const char* const* argv,
                                                const Environment& environment) {
  CLI::App app{
      "Shows the ten flows that use most of a running talusd: by generator time, bytes sent, and refusals.\n"
      "A flow is an address (IPv6: a /64 network), or a token's subject.",
      "talusd top"};
  app.footer(
      "Units: ms/s are ms of processor time of generator threads a second, /min refusals a minute: of\n"
      "requests over a limit or rate, of requests for which the server was too full, and of connections.\n"
      "The rates are weighted by age, as load averages are, over 10 s and 1 min; the share is a part of\n"
      "all flows over 1 min; totals count since a flow is listed.\n"
      "A name is as access.blocked_file has it, unless it ends in \"...\": then it was cut, and\n"
      "/flows.json on the same port has the whole subject, up to 120 bytes.\n"
      "On a terminal the page is shown again and again until Ctrl-C, elsewhere once.\n"
      "Exit status: 0 success, 1 failure, 2 wrong flags.");
  std::string admin;
  std::string config_file;
  std::int64_t interval = TopCommand{}.interval.count();
  app.add_option("--admin", admin, "the server's address for operators; default: \"admin\" of the settings")
      ->type_name("HOST:PORT");
  app.add_option("--config", config_file, "the server's settings in TOML; default: no file")
      ->type_name("FILE");
  app.add_option("--interval", interval, "seconds between updates, on a terminal")
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
    return top_refused("the operators' address is not set; give --admin HOST:PORT, as talusd has it",
                       kWrongUse);
  }
  command.admin = *settings.config.admin;
  return command;
}

tl::expected<Page, std::string> fetch_any_page(const protocol::Endpoint& admin, std::string_view path,
                                               std::chrono::milliseconds patience, Resolve resolve) {
  const std::string where = fmt::format("http://{}{}", to_string(admin), path);
  const auto failed = [&](std::string_view why) {
    return tl::make_unexpected(fmt::format("{}: {}", where, why));
  };
  const auto deadline = std::chrono::steady_clock::now() + patience;
  std::error_code unknown;
  const auto addresses = resolve_until(deadline, admin, std::move(resolve), unknown);
  if (unknown) return failed(unknown.message());
  asio::ip::tcp::iostream stream;
  stream.expires_at(deadline);
  for (const asio::ip::tcp::endpoint& address : addresses) {
    stream.clear();
    stream.connect(address);
    if (stream) break;
  }
  stream << "GET " << path << " HTTP/1.1\r\nHost: " << to_string(admin) << "\r\nConnection: close\r\n\r\n"
         << std::flush;
  std::string answer;
  for (std::array<char, 4096> part{}; stream && answer.size() <= kMaxAnswerBytes;) {
    stream.read(part.data(), part.size());
    answer.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (answer.empty()) return failed(stream.error() ? stream.error().message() : "no answer");
  const std::string_view text{answer};
  const std::size_t head_ends = text.find("\r\n\r\n");
  const std::string_view head = text.substr(0, head_ends);
  const auto length = content_length(head);
  constexpr std::string_view kBegin = "HTTP/1.1 ";
  int status = 0;
  if (head.starts_with(kBegin))
    std::from_chars(head.data() + kBegin.size(), head.data() + head.size(), status);
  if (status == 0 || head_ends == std::string_view::npos || !length) {
    return failed(fmt::format("\"{}\" is not the answer of a talusd of this version",
                              escaped(head.substr(0, head.find('\r')), 80)));
  }
  const std::string_view page = text.substr(head_ends + 4).substr(0, *length);
  if (answer.size() > kMaxAnswerBytes) return failed("answered more than 1 MiB");
  if (page.size() < *length) return failed(fmt::format("answered only {} of {} bytes", page.size(), *length));
  return Page{status, printable_lines(page)};
}

tl::expected<std::string, std::string> fetch_page(const protocol::Endpoint& admin, std::string_view path,
                                                  std::chrono::milliseconds patience, Resolve resolve) {
  auto page = fetch_any_page(admin, path, patience, std::move(resolve));
  if (!page) return tl::unexpected{std::move(page.error())};
  if (page->status == 200) return std::move(page->text);
  return tl::make_unexpected(
      fmt::format("http://{}{}: status {} is not the answer of a talusd of this version", to_string(admin),
                  path, page->status));
}

}  // namespace talus::server
