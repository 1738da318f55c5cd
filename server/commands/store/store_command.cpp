#include "commands/store/store_command.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "commands/store/moments.h"
#include "commands/store/store_commands.h"
#include "commands/store/subjects.h"
#include "config/parse_flags.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

using store_commands::Answer;
using store_commands::Flags;
using store_commands::Outside;

struct Subcommand {
  CLI::App* app = nullptr;
  Answer (*run)(const Flags&, const Outside&) = nullptr;
};

/// Takes missing flags from talusd's settings.
tl::expected<void, std::string> complete(Flags& flags, const Environment& environment) {
  Settings settings;
  if (!flags.config.empty()) {
    if (auto done = apply_file(settings, flags.config); !done) return done;
  }
  if (auto done = apply_environment(settings, environment); !done) return done;
  if (flags.data.empty()) flags.data = settings.config.data.string();
  if (flags.world.empty()) flags.world = settings.config.world.string();
  flags.cluster = settings.config.cluster;
  flags.secret = settings.config.secret;
  flags.settles = settings.config.edits.settle;
  return {};
}

/// Adds a check to the option: a text that `parse` rejects is wrong use.
template <typename Parse>
CLI::Option* check(CLI::Option* option, Parse parse) {
  return option->check([parse](const std::string& text) {
    const auto parsed = parse(text);
    std::string wrong = parsed ? std::string{} : parsed.error();
    std::ranges::replace(wrong, '"', '\'');  // parse_flags() escapes double quotes
    return wrong;
  });
}

int say(std::string_view name, const Answer& answer) {
  if (!answer) {
    fmt::print(stderr, "{}: {}\n", name, on_one_line(answer.error()));
    return kFailed;
  }
  fmt::print("{}", *answer);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
  fmt::print(stderr, "{}: standard output: cannot write to it\n", name);
  return kFailed;
}

}  // namespace

int store_command(int argc, const char* const* argv, const Environment& environment,
                  const LoadWorld& load_world, const ClusterTools& cluster) {
  CLI::App app{"Inspects, backs up, restores and repairs the store of edits in a data directory.",
               "talusd store"};
  app.require_subcommand(1);
  app.footer(
      "stat, verify, backup, export, history and rollback work while a talusd uses the directory, through a\n"
      "socket in it that the server's own user alone may use. The others need that talusd to be stopped.\n"
      "Lengths are voxels; times are UTC.\n"
      "Exit status: 0 success, 1 failure, 2 wrong flags.");
  Flags flags;
  std::vector<Subcommand> commands;
  const auto add = [&](const char* name, const char* help, Answer (*run)(const Flags&, const Outside&)) {
    CLI::App* const command = app.add_subcommand(name, help);
    command
        ->add_option("--data", flags.data, "the data directory; default: \"data\" of --config, or TALUS_DATA")
        ->type_name("DIR");
    command->add_option("--config", flags.config, "the server's settings in TOML; default: no file")
        ->type_name("FILE");
    commands.push_back({command, run});
    return command;
  };
  const auto add_json = [&](CLI::App* command) {
    command->add_flag("--json", flags.json, "as JSON, for programs");
  };
  const auto add_world = [&](CLI::App* command) {
    command->add_option("--world", flags.world, "the store's world; default: \"world\" of the settings")
        ->type_name("FILE");
  };
  add_json(add("stat", "what the store holds, by reading all of it", store_commands::show_stat));
  add("verify",
      "reads everything: checksums, the chain of the log, the hash of all edits, coarse levels against fine "
      "ones. Changes nothing",
      store_commands::verify_all);
  add("backup",
      "a backup of one moment into DIR, which must be new or empty: files with a manifest of their checksums",
      store_commands::backup)
      ->add_option("DIR", flags.path, "the backup")
      ->required();
  CLI::App* const restoring = add(
      "restore",
      "puts the backup DIR into the data directory, once every byte of it is verified, as a store of a new "
      "id, so that clients forget what they know",
      store_commands::restore);
  restoring->add_option("DIR", flags.path, "the backup")->required();
  restoring->add_flag("--replace", flags.replace,
                      "move a store in the data directory aside, to replaced-N in it");
  add("compact", "rewrites the files without replaced or deleted data", store_commands::compact_store);
  CLI::App* const exporting =
      add("export", "all edits into one file that any talusd reads", store_commands::export_file);
  exporting
      ->add_option("FILE", flags.path, "the file; one that is there is replaced once the new one is whole")
      ->required();
  exporting->add_flag(
      "--save", flags.save,
      "as a save for one player without a server, with the world in it; loose material settles in "
      "it if edits.settle is on");
  add_world(exporting);
  CLI::App* const importing =
      add("import",
          "adds the edits of a file that export wrote, or of a player's save, to the store; if the directory "
          "holds no store, makes "
          "one of them, of the file's world. The store gets a new id, and its history stays in replaced-N",
          store_commands::import_file);
  importing->add_option("FILE", flags.path, "the file")->required();
  importing->add_flag("--keep", flags.keep, "keep the store's voxel if both have one; else the file's wins");
  add_world(importing);
  CLI::App* const rebasing =
      add("rebase",
          "carries the edits over to another world, or to this one after its file has changed or lost a "
          "[[placeable]]: edits that differ from the new ground stay, and materials are matched by name. The "
          "store gets a new id, and its history stays in replaced-N",
          store_commands::rebase);
  rebasing->add_option("--world", flags.world, "the new world; default: \"world\" of the settings")
      ->type_name("FILE");
  rebasing->add_flag(
      "--drop-unknown", flags.drop_unknown,
      "drop voxels of materials that the new world does not name; else they are counted and nothing changes");
  CLI::App* const renaming = add("rename",
                                 "gives a material that players have placed another name: its voxels stay, "
                                 "and the world's file must then use that name for its [[placeable]]",
                                 store_commands::rename);
  renaming->add_option("FROM", flags.from, "the name in the store; of states \"door: open\"")->required();
  renaming->add_option("TO", flags.to, "the new name, which no material may have")->required();
  const auto add_yes = [&](CLI::App* command) {
    command->add_flag(
        "--yes", flags.yes,
        "do it; else the command says what it would do, changes nothing, and ends with status 1");
  };
  add_world(add("join-cluster",
                "makes the store of one machine a cluster's store: begins its stream in NATS, as [cluster] "
                "of --config or the environment reaches it. Id, revisions and editors stay. A store that is "
                "in a cluster already is left as it is, with status 1",
                store_commands::join_stopped_store));
  CLI::App* const leaving = add("leave-cluster",
                                "makes the store this machine's alone, at the place that it has reached; "
                                "prints what the cluster's stream has beyond it. Revisions and editors stay; "
                                "the store gets a new id, as the cluster may go on under the old",
                                store_commands::leave_with_stopped_store);
  leaving->add_flag("--keep-id", flags.keep_id,
                    "keep the id: only if no server of the cluster ever starts again");
  add_yes(leaving);
  CLI::App* const forking =
      add("fork",
          "if the cluster's stream is lost for good: gives the store a new id, and begins a new stream from "
          "the place that it has reached. All other servers have to take it from here",
          store_commands::fork_stopped_store);
  add_world(forking);
  add_yes(forking);
  CLI::App* const history = add("history",
                                "prints the changes of a voxel: subject, time, material before and after; or "
                                "a subject's changes, edit by edit, the oldest first",
                                store_commands::show_history);
  CLI::Option_group* const whose = history->add_option_group("of what");
  CLI::Option* const at = check(whose->add_option("--at", flags.at, "the voxel"), store_commands::parse_voxel)
                              ->type_name("X,Y,Z");
  check(whose->add_option("--subject", flags.subject,
                          "of the token, as history prints it; \"\": all editors without one"),
        parse_subject)
      ->type_name("NAME");
  whose->require_option(1);
  const auto moment = [](const std::string& text) { return parse_moment(text, 0); };
  check(history->add_option(
            "--since", flags.since,
            "with --subject: 90s, 30m, 2h, 7d ago, or 2026-11-25T08:30:00Z; default: all records"),
        moment)
      ->excludes(at)
      ->type_name("TIME");
  history->add_option("--after", flags.after, "with --subject: after this entry of the log, to read on")
      ->excludes(at)
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()))
      ->type_name("ENTRY");
  history
      ->add_option("--count", flags.count,
                   fmt::format("with --subject: maximum number of edits; default: {}", flags.count))
      ->excludes(at)
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100'000}))
      ->type_name("COUNT");
  add_json(history);
  CLI::App* const rolling =
      add("rollback",
          "undoes a subject's changes: each voxel that is still as the subject left it becomes what it was "
          "before. Later changes by others stay. A second run changes nothing",
          store_commands::rollback);
  check(rolling->add_option("--subject", flags.subject,
                            "of the token, as history prints it; \"\": all editors without one"),
        parse_subject)
      ->required()
      ->type_name("NAME");
  check(rolling->add_option("--since", flags.since, "90s, 30m, 2h, 7d ago, or 2026-11-25T08:30:00Z"), moment)
      ->required()
      ->type_name("TIME");
  check(rolling->add_option(
            "--box", flags.box,
            "two corners, both in it; or a token's box, X0,Y0,Z0:X1,Y1,Z1 or, for all heights, X0,Z0:X1,Z1"),
        store_commands::parse_box)
      ->required()
      ->type_name("X0,Y0,Z0,X1,Y1,Z1");
  rolling->add_flag("--dry-run", flags.dry_run, "count, and change nothing");

  if (const auto exit = parse_flags(app, argc, argv)) {
    fmt::print(exit->status == 0 ? stdout : stderr, "{}", exit->text);
    return exit->status;
  }
  for (const Subcommand& command : commands) {
    if (!command.app->parsed()) continue;
    const std::string name = "talusd store " + command.app->get_name();
    if (auto done = complete(flags, environment); !done) return say(name, tl::unexpected{done.error()});
    if (flags.data.empty()) {
      fmt::print(stderr, "{}: the data directory is not set; give --data DIR, as talusd has it\n", name);
      return kWrongUse;
    }
    return say(name, command.run(flags, {load_world, cluster}));
  }
  return kWrongUse;
}

}  // namespace talus::server
