#include "commands/cluster/cluster_command.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <talus/store/store_identity.h>
#include <CLI/CLI.hpp>

#include "commands/cluster/check.h"
#include "commands/cluster/init.h"
#include "commands/cluster/status.h"
#include "commands/cluster/target.h"
#include "config/parse_flags.h"
#include "runtime/log/escape.h"

namespace talus::server::cluster_tool {
namespace {

struct Flags {
  std::string config;
  std::string store;
  std::string world;
  bool json = false;
  std::uint64_t messages = kCheckedMessages;
  bool all = false;
};

/// Output of a command, and true if all is well.
struct CommandOutput {
  std::string text;
  bool well = true;
};
using Answer = tl::expected<CommandOutput, std::string>;

tl::expected<Config, std::string> settings_of(const Flags& flags, const Environment& environment) {
  Settings settings;
  if (!flags.config.empty()) {
    if (auto done = apply_file(settings, flags.config); !done) return tl::unexpected{done.error()};
  }
  if (auto done = apply_environment(settings, environment); !done) return tl::unexpected{done.error()};
  if (!flags.store.empty()) settings.config.cluster.store = flags.store;
  if (!flags.world.empty()) settings.config.world = flags.world;
  if (auto done = check_target(settings.config); !done) {
    return tl::unexpected{settings.origins.locate(done.error())};
  }
  return settings.config;
}

Answer run_init(const Config& config, const Flags& /*flags*/, const MakeGenesis& make_genesis) {
  const auto target = Target::for_init(config);
  if (!target) return tl::unexpected{target.error()};
  const auto genesis = make_genesis(config, target->store_id);
  if (!genesis) return tl::unexpected{genesis.error()};
  const auto made = init(*target, *genesis);
  if (!made) return tl::unexpected{made.error()};
  return CommandOutput{made_lines(*target, *genesis, *made)};
}

Answer run_check(const Config& config, const Flags& flags, const MakeGenesis& make_genesis) {
  const auto target = Target::of(config);
  if (!target) return tl::unexpected{target.error()};
  const auto genesis = make_genesis(config, target->store_id);
  if (!genesis) return tl::unexpected{genesis.error()};
  const std::vector<Finding> findings = check(*target, *genesis, flags.all ? UINT64_MAX : flags.messages);
  return CommandOutput{finding_lines(findings), !any_fault(findings)};
}

Answer run_status(const Config& config, const Flags& flags, const MakeGenesis& /*make_genesis*/) {
  const auto target = Target::of(config);
  if (!target) return tl::unexpected{target.error()};
  const auto status = read_status(*target);
  if (!status) return tl::unexpected{status.error()};
  return CommandOutput{flags.json ? status_json(*status) : status_lines(*status), has_majority(status->info)};
}

int say(std::string_view name, const Answer& answer) {
  if (!answer) {
    fmt::print(stderr, "{}: {}\n", name, on_one_line(answer.error()));
    return kFailed;
  }
  fmt::print("{}", answer->text);
  if (std::fflush(stdout) == 0) return answer->well ? 0 : kFailed;
  fmt::print(stderr, "{}: standard output: cannot write to it\n", name);
  return kFailed;
}

struct Subcommand {
  CLI::App* app = nullptr;
  Answer (*run)(const Config&, const Flags&, const MakeGenesis&) = nullptr;
};

}  // namespace
}  // namespace talus::server::cluster_tool

namespace talus::server {

int cluster_command(int argc, const char* const* argv, const Environment& environment,
                    const MakeGenesis& make_genesis) {
  using namespace cluster_tool;
  CLI::App app{
      "Makes and inspects the log that several servers of one world share: a stream of NATS JetStream, at "
      "the NATS servers of [cluster] in talusd.toml.",
      "talusd cluster"};
  app.require_subcommand(1);
  app.footer(
      "The settings are talusd's: --config, or TALUS_CLUSTER_NATS and so on.\n"
      "Exit status: 0 success, 1 failure, check found a fault, or status no leader, 2 wrong flags.");
  cluster_tool::Flags flags;
  std::vector<cluster_tool::Subcommand> commands;
  const auto add = [&](const char* name, const char* help, auto run) {
    CLI::App* const command = app.add_subcommand(name, help);
    command->add_option("--config", flags.config, "the server's settings in TOML; default: no file")
        ->type_name("FILE");
    command
        ->add_option(
            "--store", flags.store,
            "the store's id, 32 hexadecimal digits; default: cluster.store, or the id in the data directory")
        ->check([](const std::string& text) {
          const bool fits = text.empty() || store::parse_hash(text);
          return fits ? std::string{} : "'" + text + "' is not an id; give 32 hexadecimal digits";
        })
        ->type_name("ID");
    commands.push_back({command, run});
    return command;
  };
  const auto add_world = [&](CLI::App* command) {
    command->add_option("--world", flags.world, "the world; default: \"world\" of the settings")
        ->type_name("FILE");
  };
  add_world(
      add("init",
          "makes the stream of a new world, and prints the store's id, a new one unless --store names one. A "
          "second run changes nothing. A store that has edits comes in by talusd store join-cluster",
          run_init));
  CLI::App* const checking = add(
      "check", "checks everything that could keep this server from its log, and changes nothing", run_check);
  add_world(checking);
  CLI::Option* const messages =
      checking
          ->add_option("--messages", flags.messages,
                       "newest messages to read, to find any that servers cannot apply")
          ->type_name("N")
          ->capture_default_str();
  checking->add_flag("--all", flags.all, "read all messages of the log")->excludes(messages);
  add("status", "the stream, its leader and replicas, and this server's place in it", run_status)
      ->add_flag("--json", flags.json, "as JSON, for programs");

  if (const auto exit = parse_flags(app, argc, argv)) {
    fmt::print(exit->status == 0 ? stdout : stderr, "{}", exit->text);
    return exit->status;
  }
  for (const cluster_tool::Subcommand& command : commands) {
    if (!command.app->parsed()) continue;
    const std::string name = "talusd cluster " + command.app->get_name();
    const auto config = settings_of(flags, environment);
    return say(name, config ? command.run(*config, flags, make_genesis) : tl::unexpected{config.error()});
  }
  return kWrongUse;
}

}  // namespace talus::server
