// Prints what the tables of settings and metrics have: server/talusd.toml, and the tables of
// docs/REFERENCE.md and docs/OPERATIONS.md. tests/reference/check.py compares and writes the files.
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "config/fields.h"
#include "limits/pools.h"
#include "runtime/metrics/metrics_page.h"

namespace talus::server {
namespace {

/// A table of the configuration file; the first has the keys above all tables.
struct Section {
  std::string_view name;
  std::string_view help;
};

constexpr std::array kSections{
    Section{"", "Addresses, world and data directory."},
    Section{"access",
            "Tokens and lists. SIGHUP reads the files again. Key files and the secret must not be blank or "
            "one repeated character."},
    Section{
        "secret",
        "Ore that no client can see or compute before land or edits expose it (OPERATIONS.md); set both or "
        "neither."},
    Section{"edits", "Bounds of edits, in addition to those of tokens (talusd token --help)."},
    Section{"tls", "Set both or neither. SIGHUP reads both files again, for new connections."},
    Section{"http",
            "HTTP and WebSocket for players: chunks that caches can keep, and the stream for browsers. A "
            "connection from one of proxies may begin with a PROXY header, or name its client in "
            "X-Forwarded-For."},
    Section{"cluster",
            "A world on several servers (CLUSTER.md) that share a log of edits, a stream of NATS JetStream. "
            "Each has a data directory, too. Let only talusd's user read the files with secrets."},
    Section{"threads", "Threads."},
    Section{"limits",
            "Bounds of one connection, session or message, and of memory. An address is one IPv4 address or "
            "IPv6 /64 network."},
    Section{"rates", "Token buckets; 0: no limit. Rates of an address count all its sessions."},
    Section{"cache", "Maximum sizes of caches."},
    Section{"generation", "Generators."},
    Section{"shutdown", "The end of the server, from SIGTERM on."},
    Section{"balance", "Behind a balancer whose checks of /-/ready report the players of each server."},
    Section{"log", "The log on stdout."},
};

std::string_view section_of(const Field& field) {
  const std::size_t dot = field.key.find('.');
  return dot == std::string_view::npos ? std::string_view{} : field.key.substr(0, dot);
}

std::string_view name_in_section(const Field& field) {
  return field.key.substr(field.key.find('.') + 1);
}

/// The text with an upper-case first letter and a full stop.
std::string sentence(std::string_view text) {
  std::string sentence{text};
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  if (!sentence.ends_with('.')) sentence += '.';
  return sentence;
}

/// The values that a field takes: bounds with their unit, or words.
struct RangeOf {
  std::string_view unit;

  std::string operator()(const NumberTarget& target) const {
    return fmt::format("{}-{} {}", target.min, target.max, unit);
  }
  std::string operator()(const OptionalNumberTarget& target) const {
    return fmt::format("{}-{} {}, or {}", target.min, target.max, unit, kAuto);
  }
  std::string operator()(const PowerOfTwoTarget& target) const {
    return fmt::format("0 or a power of two to {} {}", target.max, unit);
  }
  std::string operator()(const DurationTarget& target) const {
    return fmt::format("{}-{} {}", target.min.count(), target.max.count(), unit);
  }
  std::string operator()(const WordTarget& target) const {
    return fmt::format("{}", fmt::join(target.words, "; "));
  }
  std::string operator()(const WordsTarget& target) const {
    return fmt::format("list of {}", fmt::join(target.words, "; "));
  }
  std::string operator()(const UrlsTarget& target) const {
    return fmt::format("list of {}://HOST:PORT", fmt::join(target.schemes, "://HOST:PORT or "));
  }
  std::string operator()(const SwitchTarget&) const { return "true; false"; }
  template <typename Target>
  std::string operator()(const Target&) const {
    return std::string{unit};
  }
};

std::string range_of(const Field& field) {
  return std::visit(RangeOf{field.unit}, field.target);
}

/// The default as the configuration file has it.
std::string toml_default(const Field& field) {
  const std::string text = text_of(field, Config{});
  if (std::holds_alternative<SwitchTarget>(field.target) || (is_number(field) && text != kAuto)) return text;
  if (std::holds_alternative<UrlsTarget>(field.target) || std::holds_alternative<WordsTarget>(field.target)) {
    return "[]";
  }
  return fmt::format("\"{}\"", text);
}

/// " (1 GiB)" after a whole number of MiB or GiB.
std::string binary_size(const Field& field) {
  if (field.unit != "bytes") return {};
  const std::string text = text_of(field, Config{});
  const std::uint64_t bytes = std::stoull(text);
  constexpr std::uint64_t kMebibyte = 1U << 20;
  if (bytes == 0 || bytes % kMebibyte != 0) return {};
  const std::uint64_t mebibytes = bytes / kMebibyte;
  return mebibytes % 1024 == 0 ? fmt::format(" ({} GiB)", mebibytes / 1024)
                               : fmt::format(" ({} MiB)", mebibytes);
}

std::string_view reload_of(const Field& field) {
  switch (counts(field)) {
    case Counts::at_once:
      return "at once";
    case Counts::for_new_sessions:
      return "new sessions";
    case Counts::after_restart:
      break;
  }
  return "restart";
}

/// Prints `text` in lines of at most 120 characters that begin with `prefix`.
void print_wrapped(std::string_view prefix, std::string_view text) {
  const std::size_t width = 120 - prefix.size();
  while (text.size() > width) {
    const std::size_t end = text.rfind(' ', width);
    fmt::print("{}{}\n", prefix, text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  fmt::print("{}{}\n", prefix, text);
}

void print_toml() {
  print_wrapped("# ",
                "The settings of talusd, each with its default. An environment variable overrides this file, "
                "and a flag overrides both: limits.connections is TALUS_LIMITS_CONNECTIONS. An empty setting "
                "is not used, unless its text says otherwise. SIGHUP reads this file again; the log says "
                "what needs a restart. REFERENCE.md has the same as tables.");
  for (const Section& section : kSections) {
    if (!section.name.empty()) {
      fmt::print("\n");
      print_wrapped("# ", section.help);
      fmt::print("[{}]\n", section.name);
    }
    for (const Field& field : fields()) {
      if (section_of(field) != section.name) continue;
      fmt::print("\n");
      const std::string range = range_of(field);
      print_wrapped("# ", sentence(field.help) + (range.empty() ? "" : fmt::format(" [{}]", range)));
      fmt::print("{} = {}\n", name_in_section(field), toml_default(field));
    }
  }
}

/// Escapes what would end a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

void print_settings() {
  for (const Section& section : kSections) {
    fmt::print("\n### {}\n\n", section.name.empty() ? "top level" : section.name);
    print_wrapped("", section.help);
    fmt::print("\n| setting | default | values | reload | meaning |\n| --- | --- | --- | --- | --- |\n");
    for (const Field& field : fields()) {
      if (section_of(field) != section.name) continue;
      fmt::print("| `{}` | `{}`{} | {} | {} | {} |\n", name_in_section(field), toml_default(field),
                 binary_size(field), cell(range_of(field)), reload_of(field), cell(sentence(field.help)));
    }
  }
}

void print_metrics() {
  constexpr std::array<std::string_view, 3> kTypes{"counter", "gauge", "histogram"};
  fmt::print("| metric | type | meaning |\n| --- | --- | --- |\n");
  for (const MetricRow& row : metric_rows()) {
    const std::string labels = row.labels.empty() ? "" : fmt::format("{{{}}}", fmt::join(row.labels, ", "));
    fmt::print("| `{}{}` | {} | {} |\n", row.name, labels, kTypes.at(static_cast<std::size_t>(row.type)),
               cell(row.help));
  }
}

void print_pools() {
  fmt::print(
      "| pool | in all | one flow, while others want some | gives way to a flow that holds less |\n"
      "| --- | --- | --- | --- |\n");
  for (const Pool& pool : kPools) {
    fmt::print("| {} | {} | {} | {} |\n", pool.name, pool.size, pool.share, pool.gives_way);
  }
}

int run(std::string_view wanted) {
  if (wanted == "toml") {
    print_toml();
  } else if (wanted == "settings") {
    print_settings();
  } else if (wanted == "metrics") {
    print_metrics();
  } else if (wanted == "pools") {
    print_pools();
  } else {
    fmt::print(stderr, "usage: talus-reference toml | settings | metrics | pools\n");
    return 2;
  }
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace
}  // namespace talus::server

int main(int argc, char** argv) {
  return talus::server::run(argc == 2 ? argv[1] : "");
}
