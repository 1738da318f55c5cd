#include "cluster/jetstream/leader_scout.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "cluster/jetstream/connection.h"
#include "cluster/jetstream/leader_questions.h"
#include "runtime/random_number.h"
#include "runtime/signals.h"

namespace talus::server::jetstream {
namespace {

using Clock = std::chrono::steady_clock;

/// Older results are outdated.
constexpr std::chrono::seconds kIsNews{5};
constexpr std::chrono::seconds kBetweenScouts{1};
constexpr std::chrono::seconds kBetweenManyScouts{5};
constexpr std::size_t kManyProbes = 120;
/// libnats must not be used while the program exits. A probe takes less, unless a server is silent.
constexpr std::chrono::seconds kLastWait{2};

bool leader_answers_by(const ServerUrls& server, const std::shared_ptr<const Credentials>& credentials,
                       const StreamNames& names, const LeaderScout::Requirement& wanted) {
  const auto connection = Connection::open(server, credentials, nullptr, Retry::never);
  if (!connection) return false;
  const auto info = ask_info(**connection, names);
  if (!info || !has_majority(*info) || info->state.last < wanted.last) return false;
  if (wanted.created_ns != 0 && info->state.created_ns != wanted.created_ns) return false;
  return ask_message(**connection, names, std::max<std::uint64_t>(info->state.last, 1)).has_value();
}

}  // namespace

/// Lives until the probing thread has ended, even without the scout.
struct LeaderScout::Probe {
  ServerUrls urls;
  std::size_t first = 0;
  std::shared_ptr<const Credentials> credentials;
  StreamNames names;
  Requirement wanted;

  std::mutex mutex;
  std::condition_variable ended;
  std::optional<Clock::time_point> ended_at;
  std::optional<ServerUrls> found;

  void run() {
    std::optional<ServerUrls> server;
    for (std::size_t i = 0; i < urls.size() && !server; ++i) {
      ServerUrls next = urls.just((first + i) % urls.size());
      try {
        if (leader_answers_by(next, credentials, names, wanted)) server = std::move(next);
      } catch (const std::exception&) {  // bad_alloc: try again later
      }
    }
    {
      const std::lock_guard lock{mutex};
      found = std::move(server);
      ended_at = Clock::now();
    }
    ended.notify_all();
  }
};

LeaderScout::LeaderScout(ServerUrls urls, std::shared_ptr<const Credentials> credentials, StreamNames names)
    : urls_{std::move(urls)},
      credentials_{std::move(credentials)},
      names_{std::move(names)},
      next_{static_cast<std::size_t>(random_number() % urls_.size())} {}  // spreads servers

LeaderScout::~LeaderScout() {
  const auto probe = probe_;
  if (probe == nullptr) return;
  std::unique_lock lock{probe->mutex};
  (void)probe->ended.wait_for(lock, kLastWait, [&] { return probe->ended_at.has_value(); });
}

std::optional<ServerUrls> LeaderScout::probe(std::chrono::milliseconds patience, Requirement wanted) {
  if (probe_ == nullptr) {
    const auto now = Clock::now();
    if (now - probed_at_ < (probes_ < kManyProbes ? kBetweenScouts : kBetweenManyScouts)) return std::nullopt;
    probed_at_ = now;
    ++probes_;
    auto probe = std::make_shared<Probe>();
    probe->urls = urls_;
    probe->first = next_++ % urls_.size();
    probe->credentials = credentials_;
    probe->names = names_;
    probe->wanted = wanted;
    const SignalBlocker blocked;
    try {
      std::thread{[probe] { probe->run(); }}.detach();
    } catch (const std::system_error&) {
      return std::nullopt;  // no thread available: try again later
    }
    probe_ = std::move(probe);
  }
  const auto probe = probe_;
  std::unique_lock lock{probe->mutex};
  if (!probe->ended.wait_for(lock, patience, [&] { return probe->ended_at.has_value(); }))
    return std::nullopt;
  probe_.reset();
  if (Clock::now() - *probe->ended_at > kIsNews) return std::nullopt;
  return std::move(probe->found);
}

}  // namespace talus::server::jetstream
