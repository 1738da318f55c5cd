#include "cluster/checkpoint/from_peers.h"

#include <algorithm>
#include <random>
#include <utility>

#include <fmt/format.h>

#include <talus/progress/progress_bar.h>
#include <talus/store/store_swap.h>

namespace talus::server {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kFirstPause{1'000};
constexpr std::chrono::milliseconds kLongestPause{30'000};
constexpr std::chrono::seconds kBetweenLines{5};
constexpr double kMebibytes = 1 << 20;

tl::expected<store::StoreMeta, PeerRefusal> take_from_peer(const std::string& peer, const PeerAccess& access,
                                                           const std::filesystem::path& staging,
                                                           const WantedStore& wanted, const Logger& log,
                                                           const OnJoining& on_joining) {
  const auto begun = SteadyClock::now();
  auto download = CheckpointDownload::open(peer, access);
  if (!download) return tl::unexpected{std::move(download.error())};
  const std::uint64_t total = (*download)->size();
  log->info("joining: {} sends its store, {:.1f} MiB", peer, static_cast<double>(total) / kMebibytes);
  ProgressBar bar{"joining", "bytes", ProgressBar::only_terminal()};
  bar.expect(total);
  std::uint64_t before = 0;
  auto next_line = begun + kBetweenLines;
  auto meta = take_checkpoint(**download, staging, wanted, [&](std::uint64_t done) {
    bar.advance(done - before);
    before = done;
    on_joining(done, total);
    const auto now = SteadyClock::now();
    if (now < next_line) return;
    next_line = now + kBetweenLines;
    log->info("joining: {:.0f} of {:.0f} MiB", static_cast<double>(done) / kMebibytes,
              static_cast<double>(total) / kMebibytes);
  });
  if (!meta) {
    const bool named = meta.error().starts_with(peer);
    return tl::unexpected{
        PeerRefusal{named ? std::move(meta.error()) : fmt::format("{}: {}", peer, meta.error())}};
  }
  const double took = std::chrono::duration<double>(SteadyClock::now() - begun).count();
  log->info("joining: the store of {} is here and verified, {:.1f} MiB in {:.1f} s, position {}, revision {}",
            peer, static_cast<double>(total) / kMebibytes, took, meta->head.position, meta->head.revision);
  return *std::move(meta);
}

}  // namespace

tl::expected<store::StoreMeta, std::string> take_from_peers(const Peers& peers,
                                                            const std::filesystem::path& directory,
                                                            const WantedStore& wanted, const Logger& log,
                                                            const OnJoining& on_joining,
                                                            const AfterRound& after_round) {
  if (peers.urls.empty()) {
    return tl::unexpected{
        std::string{"cluster.peers: is empty, so the store cannot be taken from a peer; name the operators' "
                    "ports of other servers"}};
  }
  std::mt19937_64 random{std::random_device{}()};
  std::vector<std::string> order = peers.urls;
  for (auto wait = kFirstPause;; wait = std::min(2 * wait, kLongestPause)) {
    std::ranges::shuffle(order, random);
    Round round{order.size()};
    for (const std::string& peer : order) {
      const auto staging = store::make_staging(directory);
      if (!staging) return tl::unexpected{staging.error()};
      auto taken = take_from_peer(peer, peers.access, *staging, wanted, log, on_joining);
      if (taken) return *std::move(taken);
      log->warn("joining: {}", taken.error().reason);
      if (!taken.error().answers) ++round.silent;
      if (taken.error().aside) round.aside.push_back(*taken.error().aside);
    }
    if (const auto emptied = store::make_staging(directory); !emptied) return tl::unexpected{emptied.error()};
    log->warn("joining: no peer's store could be taken; all are asked again in {} ms", wait.count());
    if (!after_round(wait, round)) return tl::unexpected{std::string{"joining was given up"}};
  }
}

}  // namespace talus::server
