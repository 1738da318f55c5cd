#include "config/command_line.h"

#include <array>

#include <fmt/format.h>
#include <talus/mistyped/nearest.h>
#include <CLI/CLI.hpp>

#include "config/fields.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

/// Command-line flag of a setting.
struct Flag {
  std::string_view name;
  std::string_view key;
  std::string_view type;
  std::string text{};
  CLI::Option* option = nullptr;
};

std::string help_of(const Field& field, std::string_view fallback) {
  return fmt::format("{}{} ({})", field.help, fallback, variable_name(field.key));
}

Exit one_line(std::string text, int status) {
  return {fmt::format("talusd: {}\n", on_one_line(text)), status};
}

/// Error text for an unknown first word: only flags may follow the program's name.
std::string no_such_command(std::string_view word) {
  constexpr std::array<std::string_view, 5> kCommands{"token", "top", "store", "cluster", "pregen"};
  const std::string_view near = meant(word, kCommands);
  return fmt::format("unknown command {}; {} talusd --help", escaped(word),
                     near.empty() ? fmt::format("there are {}; see", fmt::join(kCommands, ", "))
                                  : fmt::format("did you mean {}? See", near));
}

}  // namespace

tl::expected<Command, Exit> read_command_line(int argc, const char* const* argv,
                                              const Environment& environment, std::string_view version) {
  if (argc > 1 && argv[1][0] != '-') return tl::unexpected{one_line(no_such_command(argv[1]), kWrongUse)};
  CLI::App app{"talusd streams an endless voxel world, generated on demand, to game clients.", "talusd"};
  app.set_version_flag("--version", fmt::format("talusd {}", version));
  app.footer(
      "Each setting of talusd.toml has an environment variable: TALUS_LIMITS_CONNECTIONS for "
      "limits.connections.\n"
      "A flag overrides a variable, a variable overrides the file, and the file overrides the default.\n"
      "\"talusd token --help\" explains how to make tokens for clients, \"talusd top --help\" how to see "
      "which flows use most, \"talusd store --help\" how to back up what players built, \"talusd pregen\n"
      "--help\" how to make land before they come, \"talusd cluster --help\" how several servers share a "
      "world.\n"
      "SIGTERM or SIGINT ends the server once pending answers are sent; a second signal ends it at once.\n"
      "Exit status: 0 success, 1 failure, 2 wrong flags, 75 start it again: its store was lost to the "
      "cluster.");

  Command command;
  std::string config_file;
  app.add_option("--config", config_file, "settings in TOML, as in talusd.toml")->type_name("FILE");
  std::array flags{Flag{"world", "world", "FILE"},           Flag{"listen", "listen", "HOST:PORT"},
                   Flag{"http", "http.listen", "HOST:PORT"}, Flag{"web", "http.web", "DIR"},
                   Flag{"admin", "admin", "HOST:PORT"},      Flag{"data", "data", "DIR"},
                   Flag{"publish", "publish", "none|public"}};
  for (Flag& flag : flags) {
    const std::string fallback =
        flag.key == "listen" ? fmt::format("; default {}", to_string(Config{}.listen)) : std::string{};
    flag.option =
        app.add_option(fmt::format("--{}", flag.name), flag.text, help_of(*find_field(flag.key), fallback))
            ->type_name(std::string{flag.type});
  }
  app.add_flag("--check-config", command.check_only,
               "check settings, world, user, keys and certificate, not addresses or the data directory; "
               "print ok and exit");

  if (auto exit = parse_flags(app, argc, argv)) return tl::make_unexpected(*std::move(exit));

  if (!config_file.empty()) {
    command.has_file = true;
    if (auto done = apply_file(command, config_file); !done) {
      return tl::make_unexpected(one_line(done.error(), kFailed));
    }
  }
  if (auto done = apply_environment(command, environment); !done) {
    return tl::make_unexpected(one_line(done.error(), kFailed));
  }
  for (const Flag& flag : flags) {
    if (flag.option->count() == 0) continue;
    if (auto done = set_from_text(*find_field(flag.key), command.config, flag.text); !done) {
      return tl::make_unexpected(one_line(fmt::format("--{}: {}", flag.name, done.error()), kWrongUse));
    }
    command.origins.forget(flag.key);
  }
  return command;
}

}  // namespace talus::server
