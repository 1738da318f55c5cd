// A store taken from whichever peer has it: the peers in random order, again and again, until one's
// checkpoint is whole. A store is never begun empty because no peer answers.
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

/// How far it is, for who asks meanwhile. Any thread calls it.
using OnJoining = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// What it waits with between two rounds, and what peers answered in the one before; false: it is given up.
using AfterRound = std::function<bool(std::chrono::milliseconds, const Round&)>;

/// Into the staging directory of `directory`, which is locked: swap_in() makes it the directory's store. An
/// error is one line: there are no peers, nothing can be written here, or `after_round` gave up. What goes
/// wrong with a peer is logged.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> take_from_peers(
    const Peers& peers, const std::filesystem::path& directory, const WantedStore& wanted, const Logger& log,
    const OnJoining& on_joining, const AfterRound& after_round);

}  // namespace talus::server
