// The store of a server of a cluster, made ready before it is opened: as it is on the disk, or begun anew and
// read from the stream, or taken from a peer. A store is never begun empty where the cluster's is not.
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
  store::DataDirectory& directory;  // locked, as open_member() opens it
  ContentHash fingerprint;          // of the world
  std::optional<ContentHash>
      store_id;  // as cluster.store has it; none: that of the directory, or of the peers
  Peers peers;
  /// Of a store. An error is one line.
  std::function<tl::expected<std::unique_ptr<LogStream>, std::string>(ContentHash store_id)> open_stream;
  Logger log;
  OnJoining on_joining;
  /// Sleeps; false: the start is given up.
  std::function<bool(std::chrono::milliseconds)> pause;
  /// The store that is here must not be used, for who asks meanwhile; none: there is no such any more.
  std::function<void(const std::optional<AsideStore>&)> on_aside = [](const auto&) {};
  /// So long peers that do not answer are waited for before those that do decide.
  std::chrono::milliseconds silent_patience = std::chrono::minutes{2};
};

struct Prepared {
  std::unique_ptr<LogStream> stream;  // of the store that the directory has then
  std::uint64_t joins = 0;            // checkpoints that were taken
};

/// Makes the store in the directory ready to be opened, and opens its stream. Waits as long as neither stream
/// nor peers can be reached, unless the store on the disk can be served meanwhile. An error is one line: a
/// person has to act.
[[nodiscard]] tl::expected<Prepared, std::string> prepare_store(const Parts& parts);

/// The store in `directory` must not be used any more: the next prepare_store() takes one from a peer.
/// `reason` is one line. For who holds the directory's lock.
[[nodiscard]] tl::expected<void, std::string> want_rejoin(const std::filesystem::path& directory,
                                                          const std::string& reason);

/// What want_rejoin() said is no more: the store in `directory` is another now, or begins another stream.
[[nodiscard]] tl::expected<void, std::string> forget_rejoin(const std::filesystem::path& directory);

}  // namespace talus::server::join
