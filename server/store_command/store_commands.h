// The commands of "talusd store", as its flags ask for them. They print nothing but progress, and what is too
// long to keep. For one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "config/config.h"
#include "store_command/cluster_moves.h"
#include "store_command/history.h"
#include "store_command/store_command.h"

namespace talus::server::store_commands {

/// What a command prints, or why it failed, in one line.
using Answer = tl::expected<std::string, std::string>;

struct Flags {
  std::string data;
  std::string config;
  bool json = false;
  std::string path;  // of a backup or a file
  bool replace = false;
  std::optional<std::string> at;
  std::string subject;
  std::string since;
  std::int64_t after = 0;
  std::uint64_t count = SubjectQuery{}.most_edits;
  std::string box;
  bool dry_run = false;
  bool keep = false;
  std::string world;
  bool drop_unknown = false;
  std::string from, to;  // names of materials
  bool keep_id = false;
  bool yes = false;
  Cluster cluster;  // as talusd has it
};

/// What the program brings along.
struct Outside {
  const LoadWorld& load_world;
  const ClusterTools& cluster;
};

[[nodiscard]] Answer show_stat(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer verify_all(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer backup(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer restore(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer compact_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer show_history(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rollback(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer export_file(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer import_file(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rebase(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rename(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer join_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer leave_with_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer fork_stopped_store(const Flags& flags, const Outside& outside);

}  // namespace talus::server::store_commands
