// Prepares the store of a cluster's server before it is opened: uses the one on the disk, starts an empty one
// that reads the stream, or downloads one from a peer. Never starts empty if the cluster's store is not.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>
#include <talus/voxel/content_hash.h>

#include "cluster/checkpoint/from_peers.h"
#include "cluster/log_stream.h"
#include "runtime/log/logger.h"

namespace talus::server::join {

struct Parts {
  store::DataDirectory& directory;      // locked by open_member()
  ContentHash fingerprint;              // the world's
  std::optional<ContentHash> store_id;  // cluster.store; nullopt: the directory's or the peers'
  Peers peers;
  /// Opens the stream of a store. An error is one line.
  std::function<tl::expected<std::unique_ptr<LogStream>, std::string>(ContentHash store_id)> open_stream;
  Logger log;
  OnJoining on_joining;
  /// Sleeps; returns false if the start is cancelled.
  std::function<bool(std::chrono::milliseconds)> pause;
  /// Reports the local store that must not be used, for peers that ask; nullopt once it is resolved.
  std::function<void(const std::optional<AsideStore>&)> on_aside = [](const auto&) {};
  /// Time to wait for silent peers before the answering ones decide.
  std::chrono::milliseconds silent_patience = std::chrono::minutes{2};
};

struct PreparedStore {
  std::unique_ptr<LogStream> stream;  // of the store that the directory has then
  std::uint64_t joins = 0;            // number of checkpoints downloaded
};

/// Makes the directory's store ready to be opened, and opens its stream. Waits as long as neither stream nor
/// peers can be reached, unless the store on the disk can be served meanwhile. An error is one line; an
/// operator must act.
[[nodiscard]] tl::expected<PreparedStore, std::string> prepare_store(const Parts& parts);

/// Marks the store in `directory` as unusable: the next prepare_store() downloads one from a peer. `reason`
/// is one line. Requires the directory's lock.
[[nodiscard]] tl::expected<void, std::string> want_rejoin(const std::filesystem::path& directory,
                                                          const std::string& reason);

/// Removes the mark of want_rejoin(): the store was replaced, or starts another stream.
[[nodiscard]] tl::expected<void, std::string> forget_rejoin(const std::filesystem::path& directory);

}  // namespace talus::server::join
