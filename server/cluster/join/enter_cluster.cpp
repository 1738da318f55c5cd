#include "cluster/join/enter_cluster.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <talus/store/id_check.h>
#include <talus/store/read_only_store.h>
#include <talus/store/whole_store.h>

#include "cluster/message.h"

namespace talus::server::join {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxAttempts = 20;
constexpr std::chrono::milliseconds kBetweenTries{250};
constexpr std::chrono::seconds kFirstPatience{2};

/// Retries while the stream may come back.
template <typename Ask>
auto insist(const Ask& ask) {
  auto answer = ask();
  for (int tries = 1; !answer && tries < kMaxAttempts; ++tries) {
    if (answer.error().kind != StreamFailure::Kind::unavailable) break;
    std::this_thread::sleep_for(kBetweenTries);
    answer = ask();
  }
  return answer;
}

tl::expected<cluster::Genesis, std::string> genesis_of(const fs::path& directory,
                                                       const edits::SettleRules& settles) {
  const auto store = store::ReadOnlyStore::open(directory);
  if (!store) return tl::unexpected{store.error()};
  const store::StoreMeta& meta = (*store)->meta();
  cluster::Genesis genesis;
  genesis.identity = {meta.store_id, meta.fingerprint};
  genesis.level_rule = meta.level_rule;
  genesis.head = meta.head;
  genesis.settles = settles;
  for (const auto& [name, id] : (*store)->materials()) {
    if (to_integer(id) >= edits::kFirstBound) genesis.materials.emplace(name, id);
  }
  return genesis;
}

/// An existing first message must be this one.
tl::expected<void, std::string> check_first(LogStream& stream, const StreamState& state,
                                            const cluster::Genesis& ours) {
  const auto another = [&](std::string_view what) {
    return tl::unexpected{
        fmt::format("the stream of store {} is begun already, by {}; if that store is lost for good, delete "
                    "the stream in NATS, or run \"talusd store fork\"",
                    to_string(ours.identity.store_id), what)};
  };
  if (state.first > 1) return another("a store that went on since");
  const auto first =
      insist([&] { return stream.next(0, std::chrono::steady_clock::now() + kFirstPatience); });
  if (!first) return tl::unexpected{first.error().reason};
  if (!*first) return tl::unexpected{std::string{"the stream's first message does not arrive"}};
  const auto genesis = cluster::decode_genesis((*first)->bytes);
  if (!genesis) {
    const cluster::MessageFault& fault = genesis.error();
    // A stream started by a newer talusd must not be deleted.
    if (fault.kind == cluster::MessageFault::Kind::newer) {
      return tl::unexpected{
          fmt::format("the stream's first message: {}{}", fault.reason, cluster::remedy_of(fault))};
    }
    return another(fmt::format("a message that is not a genesis: {}", fault.reason));
  }
  if (*genesis != ours) {
    return another(fmt::format("it at position {}, revision {}; here it is at position {}, revision {}",
                               genesis->head.position, genesis->head.revision, ours.head.position,
                               ours.head.revision));
  }
  return {};
}

}  // namespace

tl::expected<store::StoreMeta, std::string> read_place(const fs::path& directory) {
  const auto store = store::ReadOnlyStore::open(directory);
  if (!store) return tl::unexpected{store.error()};
  const store::StoreMeta meta = (*store)->meta();
  if (const auto whole = store::check_whole_store(directory, meta); !whole)
    return tl::unexpected{whole.error()};
  return meta;
}

tl::expected<store::StoreMeta, std::string> enter_cluster(const fs::path& directory,
                                                          const edits::SettleRules& settles,
                                                          LogStream& stream) {
  auto meta = read_place(directory);
  if (!meta) return meta;
  if (meta->stream.sequence != 0) {
    return tl::unexpected{fmt::format("data {}: the store is in a cluster already, at message {}",
                                      directory.string(), meta->stream.sequence)};
  }
  const auto genesis = genesis_of(directory, settles);
  if (!genesis) return tl::unexpected{genesis.error()};
  const auto bytes = cluster::encode(*genesis);
  if (!bytes) return tl::unexpected{bytes.error()};
  auto state = insist([&] { return stream.state(); });
  if (!state) return tl::unexpected{state.error().reason};
  for (int tries = 0; state->last == 0; ++tries) {
    const auto published = stream.publish(*bytes);
    // Without an answer the message may be stored now or later; servers skip a second one.
    state = insist([&] { return stream.state(); });
    if (!state) return tl::unexpected{state.error().reason};
    if (published || state->last > 0) continue;
    if (published.error().kind != StreamFailure::Kind::unavailable || tries == kMaxAttempts) {
      return tl::unexpected{published.error().reason};
    }
  }
  if (const auto right = check_first(stream, *state, *genesis); !right) return tl::unexpected{right.error()};
  meta->stream = {1, state->created_ns, 0, cluster::hash_of_message(*bytes)};
  if (const auto entered = store::enter_stream(directory, meta->stream); !entered)
    return tl::unexpected{entered.error()};
  return meta;
}

}  // namespace talus::server::join
