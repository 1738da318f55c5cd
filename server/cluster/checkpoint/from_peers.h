// Downloads a store from any peer that has it: tries the peers in random order, repeatedly, until one
// checkpoint is complete. Unreachable peers never cause a new empty store.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cluster/checkpoint/checkpoint_download.h"
#include "cluster/checkpoint/take_checkpoint.h"
#include "runtime/log/logger.h"

namespace talus::server {

struct Peers {
  std::vector<std::string> urls;  // "https://HOST:PORT"
  PeerAccess access;
};

/// Reports progress. Called on any thread.
using OnJoining = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Waits between two rounds, given the peers' answers of the previous one. Returns false to give up.
using AfterRound = std::function<bool(std::chrono::milliseconds, const Round&)>;

/// Downloads into the staging directory of `directory`, which must be locked; swap_in() makes it the
/// directory's store. An error is one line: there are no peers, the disk cannot be written, or `after_round`
/// gave up. Failures of single peers are logged.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> take_from_peers(
    const Peers& peers, const std::filesystem::path& directory, const WantedStore& wanted, const Logger& log,
    const OnJoining& on_joining, const AfterRound& after_round);

}  // namespace talus::server
