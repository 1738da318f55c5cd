// The commands of "talusd store", as its flags ask for them. They print nothing but progress, and what is too
// long to keep. For one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "commands/store/cluster_moves.h"
#include "commands/store/history.h"
#include "commands/store/store_command.h"
#include "config/config.h"

namespace talus::server::store_commands {

/// What a command prints, or why it failed, in one line.
using Answer = tl::expected<std::string, std::string>;

/// As they were given; each command checks the texts that it reads.
struct Flags {
  std::string data;               // the data directory
  std::string config;             // talusd's file; empty: none
  bool json = false;              // stat, history: JSON in place of lines
  std::string path;               // of a backup or a file
  bool replace = false;           // restore: also where a store is
  std::optional<std::string> at;  // history: "X,Y,Z" in voxels; none: that of `subject`
  std::string subject;            // history, rollback: of whom
  std::string since;              // history, rollback: as parse_moment() reads it; empty: all records
  std::int64_t after = 0;         // history of a subject: of entries behind this one
  std::uint64_t count = SubjectQuery{}.most_edits;  // history of a subject: edits at most
  std::string box;            // rollback: "X0,Y0,Z0,X1,Y1,Z1" in voxels, both in it, or as tokens have boxes
  bool dry_run = false;       // rollback: only says what it would do
  bool keep = false;          // import: what both have is the store's, else the file's
  std::string world;          // the world's file; empty: the one built into talusd
  bool drop_unknown = false;  // rebase: loses voxels of materials that the new world does not name
  std::string from, to;       // rename: names of a material
  bool keep_id = false;       // leave-cluster: the store keeps the cluster's id
  bool yes = false;           // leave-cluster, fork: does it; else says what it would do, with status 1
  Cluster cluster;            // as talusd has it
};

/// What the program brings along.
struct Outside {
  const LoadWorld& load_world;
  const ClusterTools& cluster;
};

// These read: a server that uses the directory makes a checkpoint for them, where they run as its user; else
// they lock the directory, which they must be able to read. Refused where there is no store, where
// it lost what was acknowledged, and where another command changes it.

/// What the store has, in figures.
[[nodiscard]] Answer show_stat(const Flags& flags, const Outside& outside);
/// Reads everything; an error is the first damage.
[[nodiscard]] Answer verify_all(const Flags& flags, const Outside& outside);
/// `path` is a new directory, or an empty one.
[[nodiscard]] Answer backup(const Flags& flags, const Outside& outside);
/// Prints records itself, as it reads them: an error may come after some.
[[nodiscard]] Answer show_history(const Flags& flags, const Outside& outside);
/// Writes the file whole or not at all.
[[nodiscard]] Answer export_file(const Flags& flags, const Outside& outside);
/// Also writes: by the server that uses the directory, else as those below. An error may come after some
/// edits: those stay, and the next call goes on.
[[nodiscard]] Answer rollback(const Flags& flags, const Outside& outside);

// These write: refused where a server uses the directory, and for all users but its owner. After an error the
// store is what it was, unless the error says more. Those that replace the store refuse one of a cluster.

/// Makes the directory where it is missing.
[[nodiscard]] Answer restore(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer compact_store(const Flags& flags, const Outside& outside);
/// Makes the directory where it is missing; after an error it is missing again.
[[nodiscard]] Answer import_file(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rebase(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rename(const Flags& flags, const Outside& outside);
// Of clusters; they reach the stream as `cluster` says.
[[nodiscard]] Answer join_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer leave_with_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer fork_stopped_store(const Flags& flags, const Outside& outside);

}  // namespace talus::server::store_commands
