// The commands of "talusd store". They print only progress, and output too long to hold in memory. For one
// thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/voxel/coords.h>

#include "commands/store/cluster_moves.h"
#include "commands/store/history.h"
#include "commands/store/store_command.h"
#include "config/boxes.h"
#include "config/config.h"

namespace talus::server::store_commands {

/// Output of a command, or a one-line error.
using Answer = tl::expected<std::string, std::string>;

/// Flags as given; each command validates the texts that it uses.
struct Flags {
  std::string data;               // the data directory
  std::string config;             // talusd's configuration file; may be empty
  bool json = false;              // stat, history: JSON instead of lines
  std::string path;               // backup directory or file
  bool replace = false;           // restore: replaces an existing store
  std::optional<std::string> at;  // history: "X,Y,Z" in voxels; nullopt: by `subject`
  std::string subject;            // history, rollback: the editor's
  std::string since;              // history, rollback: for parse_moment(); empty: all records
  std::int64_t after = 0;         // history of a subject: only entries after this one
  std::uint64_t count = SubjectQuery{}.max_edits;  // history of a subject: maximum number of edits
  std::string box;            // rollback: "X0,Y0,Z0,X1,Y1,Z1" in voxels, inclusive, or a box as in tokens
  bool dry_run = false;       // rollback: only reports what it would do
  bool keep = false;          // import: the store wins for voxels in both; otherwise the file
  std::string world;          // the world's file; empty: built-in
  bool save = false;          // export: as a save of a single player
  bool settles = false;       // talusd's setting edits.settle
  bool drop_unknown = false;  // rebase: drops voxels of materials that the new world lacks
  std::string from, to;       // rename: names of a material
  bool keep_id = false;       // leave-cluster: the store keeps the cluster's id
  bool yes = false;           // leave-cluster, fork: confirmed; otherwise reports its plan with status 1
  Cluster cluster;            // talusd's settings
  SecretLayers secret;        // the same
};

/// Functions that the program provides.
struct Outside {
  const LoadWorld& load_world;
  const ClusterTools& cluster;
};

// Texts of flags. An error is one line without the flag.

/// Reads "X,Y,Z".
[[nodiscard]] tl::expected<VoxelPos, std::string> parse_voxel(const std::string& text);
/// Reads six numbers, or a box as in tokens.
[[nodiscard]] tl::expected<Box, std::string> parse_box(const std::string& text);

// Commands that read. A server that uses the directory makes a checkpoint for them, if they run as its user;
// otherwise they lock the directory, which must be readable. They fail if there is no store, acknowledged
// edits were lost, or another command changes the store.

/// Reports figures of the store.
[[nodiscard]] Answer show_stat(const Flags& flags, const Outside& outside);
/// Reads everything; the error is the first damage found.
[[nodiscard]] Answer verify_all(const Flags& flags, const Outside& outside);
/// `path` must be a new or empty directory.
[[nodiscard]] Answer backup(const Flags& flags, const Outside& outside);
/// Prints records while reading them, so an error may follow output.
[[nodiscard]] Answer show_history(const Flags& flags, const Outside& outside);
/// Writes a complete file or none.
[[nodiscard]] Answer export_file(const Flags& flags, const Outside& outside);
/// Also writes: through the server that uses the directory, otherwise like the commands below. After an error
/// some edits may have been made; they stay, and the next call continues.
[[nodiscard]] Answer rollback(const Flags& flags, const Outside& outside);

// Commands that write. They fail if a server uses the directory, or for users other than its owner. An error
// leaves the store unchanged unless it says otherwise. Commands that replace the store reject a cluster's.

/// Creates the directory if it is missing.
[[nodiscard]] Answer restore(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer compact_store(const Flags& flags, const Outside& outside);
/// Creates the directory if it is missing; removes it again on error.
[[nodiscard]] Answer import_file(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rebase(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer rename(const Flags& flags, const Outside& outside);
// Commands for clusters, which reach the stream through `cluster`.
[[nodiscard]] Answer join_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer leave_with_stopped_store(const Flags& flags, const Outside& outside);
[[nodiscard]] Answer fork_stopped_store(const Flags& flags, const Outside& outside);

}  // namespace talus::server::store_commands
