#include "config/command_line.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "config/fields.h"

namespace talus::server {
namespace {

/// A flag that sets a field of the table.
struct Flag {
  std::string_view key;
  std::string_view type;
  std::string text{};
  CLI::Option* option = nullptr;
};

std::string help_of(const Field& field, std::string_view fallback) {
  return fmt::format("{}{} ({})", field.help, fallback, variable_name(field));
}

Exit one_line(std::string text, int status) {
  return {fmt::format("talusd: {}\n", text), status};
}

}  // namespace

tl::expected<Command, Exit> read_command_line(int argc, const char* const* argv,
                                              const Environment& environment) {
  CLI::App app{"talusd streams an endless world, generated on demand, to game clients.", "talusd"};
  app.set_version_flag("--version", "talusd " TALUS_VERSION);
  app.footer(
      "Every setting of talusd.toml is also a variable: limits.connections is TALUS_LIMITS_CONNECTIONS.\n"
      "talusd token --help tells how to make tokens for clients.\n"
      "Flags win over variables, variables over the file, the file over the defaults.\n"
      "SIGTERM and SIGINT end the server after pending answers are sent; a second signal ends it at once.\n"
      "Exit status: 0 done, 1 failed, 2 wrong use.");

  Command command;
  std::string config_file;
  app.add_option("--config", config_file, "settings, as talusd.toml explains them (default: none)")
      ->type_name("FILE");
  std::array flags{Flag{"world", "FILE"}, Flag{"listen", "HOST:PORT"}, Flag{"http", "HOST:PORT"},
                   Flag{"admin", "HOST:PORT"}, Flag{"data", "DIR"}};
  for (Flag& flag : flags) {
    const std::string fallback =
        flag.key == "listen" ? fmt::format("; default {}", to_string(Config{}.listen)) : std::string{};
    flag.option =
        app.add_option(fmt::format("--{}", flag.key), flag.text, help_of(*find_field(flag.key), fallback))
            ->type_name(std::string{flag.type});
  }
  app.add_flag(
      "--check-config", command.check_only,
      "check settings, world and certificate, but neither address nor data directory; print ok, and exit");

  if (auto exit = parse_flags(app, argc, argv)) return tl::make_unexpected(*std::move(exit));

  if (!config_file.empty()) {
    if (auto done = apply_file(command.config, config_file); !done) {
      return tl::make_unexpected(one_line(done.error(), kFailed));
    }
  }
  if (auto done = apply_environment(command.config, environment); !done) {
    return tl::make_unexpected(one_line(done.error(), kFailed));
  }
  for (const Flag& flag : flags) {
    if (flag.option->count() == 0) continue;
    if (auto done = set_from_text(*find_field(flag.key), command.config, flag.text); !done) {
      return tl::make_unexpected(one_line(fmt::format("--{}: {}", flag.key, done.error()), kWrongUse));
    }
  }

  command.warnings = unknown_variables(environment);
  if (command.config.http) command.warnings.emplace_back("http is not served by this version; ignored");
  return command;
}

}  // namespace talus::server
