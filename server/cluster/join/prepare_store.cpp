#include "cluster/join/prepare_store.h"

#include <chrono>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <talus/files/atomic_file.h>
#include <talus/files/read_file.h>
#include <talus/store/acknowledged_file.h>
#include <talus/store/id_check.h>
#include <talus/store/read_only_store.h>
#include <talus/store/regular_files.h>
#include <talus/store/store_swap.h>

#include "cluster/join/start_plan.h"
#include "cluster/last_message.h"
#include "cluster/message.h"
#include "cluster/server_number.h"
#include "runtime/log/escape.h"

namespace talus::server::join {
namespace {

namespace fs = std::filesystem;
using Status = tl::expected<void, std::string>;
using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kMaxReasonBytes = 1'000;
constexpr std::chrono::milliseconds kFirstWait{500};
constexpr std::chrono::milliseconds kLongestWait{5'000};
constexpr std::chrono::seconds kGenesisPatience{2};
/// Maximum number of consecutive checkpoints that were too old on arrival.
constexpr int kMaxJoins = 3;

class Preparation {
 public:
  explicit Preparation(const Parts& parts) : parts_{parts} {}

  [[nodiscard]] tl::expected<PreparedStore, std::string> run() {
    if (auto read = read_local(); !read) return tl::unexpected{std::move(read.error())};
    id_ = parts_.store_id;
    if (!id_ && local_) id_ = local_->store_id;
    if (!id_ && is_damaged_) id_ = parts_.directory.store_id();
    if (!id_) {
      parts_.log->info("joining: neither the data directory nor cluster.store names a store");
      if (auto taken = take(WantedPlace{}); !taken) return tl::unexpected{std::move(taken.error())};
      is_compared_ = false;
    }
    auto stream = parts_.open_stream(*id_);
    if (!stream) return tl::unexpected{std::move(stream.error())};
    for (int joins = 0; joins < kMaxJoins; ++joins) {
      auto facts = find_facts(**stream);
      if (!facts) return tl::unexpected{std::move(facts.error())};
      if (!*facts) return PreparedStore{*std::move(stream), joins_};
      StartPlan plan = plan_start(**facts);
      using Kind = StartPlan::Kind;
      if (plan.kind == Kind::refused) return refused(plan.reason);
      // A damaged store stays until another replaces it.
      if (is_damaged_) plan = {Kind::from_peer, "this server's store is damaged"};
      if (plan.kind == Kind::as_it_is) {
        parts_.log->info("cluster: this store is {}", plan.reason);
        return PreparedStore{*std::move(stream), joins_};
      }
      parts_.log->info("joining: {}", plan.reason);
      if (plan.kind == Kind::from_peer) {
        auto taken = take_for(plan, (*facts)->stream);
        if (!taken) return tl::unexpected{std::move(taken.error())};
        if (*taken) continue;
        if (own_goes_on_) {
          if (auto own = use_own(); !own) return tl::unexpected{std::move(own.error())};
          continue;
        }
        if (local_) return PreparedStore{*std::move(stream), joins_};
      }
      if (auto begun = begin_empty(); !begun) return tl::unexpected{std::move(begun.error())};
      return PreparedStore{*std::move(stream), joins_};
    }
    return refused(
        "the stream forgets faster than a peer's store can be taken; let it keep more (max_age, max_bytes)");
  }

 private:
  /// An operator must act: a new stream would start with an empty store.
  [[nodiscard]] std::string without_stream(std::string reason) const {
    if (local_ && local_->stream.sequence > 0) {
      reason +=
          "; this store has read a stream already: if that stream is lost for good, see \"talusd store fork "
          "--help\"";
    }
    return reason;
  }
  [[nodiscard]] tl::unexpected<std::string> refused(std::string_view why) const {
    return tl::unexpected{fmt::format("data {}: {}", parts_.directory.path().string(), why)};
  }

  /// Reads the local store if it has entries.
  [[nodiscard]] Status read_local() {
    const fs::path& path = parts_.directory.path();
    std::error_code code;
    if (fs::exists(path / store::kRejoinName, code)) {
      const auto reason = files::read_regular_file(path / store::kRejoinName, kMaxReasonBytes);
      rejoin_ = reason ? on_one_line(*reason) : std::string{"it was found to be wrong"};
    }
    if (!fs::exists(path / "db" / "CURRENT", code)) {
      if (!fs::exists(path / "acknowledged", code)) return {};
      return refused(
          "its store has lost its database, but not the file acknowledged; move that away for this server to "
          "take the store from a peer");
    }
    const auto store = store::ReadOnlyStore::open(path);
    if (!store) return leave_damaged(store.error(), store::ReadOnlyStore::is_damaged(path));
    const store::StoreMeta& meta = (*store)->meta();
    if (auto one = store::check_store_id(path, meta); !one) return one;
    if (auto whole = store::check_acknowledged(path, meta); !whole) {
      return leave_damaged(whole.error(), store::can_read_acknowledged(path));
    }
    if (meta.head.position == 0 && meta.stream.sequence == 0) return {};  // it is empty
    if (parts_.store_id && meta.store_id != *parts_.store_id) {
      return refused(fmt::format("it has store {}, and cluster.store names {}; give --data another directory",
                                 to_string(meta.store_id), to_string(*parts_.store_id)));
    }
    local_ = meta;
    return {};
  }

  /// Goes on without a damaged store if a peer's can replace it.
  [[nodiscard]] Status leave_damaged(const std::string& reason, bool is_damage) {
    if (!is_damage || parts_.peers.urls.empty() || !parts_.directory.identity()) {
      return tl::unexpected{reason};
    }
    parts_.log->error("joining: {}; this server takes another server's store", reason);
    is_damaged_ = true;
    return {};
  }

  /// Returns nullopt if the stream cannot be asked and the store on the disk is served as it is.
  [[nodiscard]] tl::expected<std::optional<StartFacts>, std::string> find_facts(LogStream& stream) {
    using Kind = StreamFailure::Kind;
    for (auto wait = kFirstWait;; wait = std::min(2 * wait, kLongestWait)) {
      const auto state = stream.state();
      auto facts = state ? facts_of(*state, stream) : tl::unexpected{state.error()};
      if (facts) {
        is_compared_ = true;
        return *std::move(facts);
      }
      if (facts.error().kind != Kind::unavailable) {
        // In any case the stream cannot be this store's.
        if (local_ && local_->stream.sequence == 0) return refused(plan_start({local_, {}}).reason);
        return refused(without_stream(facts.error().reason));
      }
      if (local_ && local_->stream.sequence > 0 && rejoin_.empty() && is_compared_) {
        parts_.log->warn(
            "cluster: {}; until it can be reached this server serves the store on its disk, and takes no "
            "edits",
            facts.error().reason);
        return std::nullopt;
      }
      parts_.log->warn("joining: {}; asked again in {} ms", facts.error().reason, wait.count());
      if (!parts_.pause(wait)) return tl::unexpected{std::string{"joining was given up"}};
    }
  }

  [[nodiscard]] tl::expected<StartFacts, StreamFailure> facts_of(const StreamState& state,
                                                                 LogStream& stream) {
    StartFacts facts{local_,
                     state,
                     false,
                     !parts_.peers.urls.empty(),
                     local_ ? store::bytes_of_files(parts_.directory.path() / "db") : 0,
                     rejoin_};
    is_known_ = false;
    if (local_ && local_->stream.sequence > 0 && local_->stream.created_ns == state.created_ns &&
        local_->stream.sequence <= state.last) {
      const auto last = cluster::compare_last_message(stream, state, local_->stream);
      if (!last) return tl::unexpected{last.error()};
      facts.is_other = *last == cluster::LastMessage::other;
      is_known_ = *last == cluster::LastMessage::as_applied;
    }
    if (local_ || state.last == 0 || state.first > 1) return facts;
    const auto first = stream.next(0, SteadyClock::now() + kGenesisPatience);
    if (!first) {
      if (first.error().kind == StreamFailure::Kind::gone) return facts;
      return tl::unexpected{first.error()};
    }
    if (!*first) return tl::unexpected{StreamFailure{{}, "the stream's first message does not arrive"}};
    const auto genesis = cluster::decode_genesis((*first)->bytes);
    const auto wrong = [](std::string reason) {
      return tl::unexpected{StreamFailure{StreamFailure::Kind::refused, std::move(reason)}};
    };
    if (!genesis) {
      return wrong(fmt::format("the stream's first message: {}{}", genesis.error().reason,
                               remedy_of(genesis.error())));
    }
    if (genesis->identity != store::StoreIdentity{*id_, parts_.fingerprint}) {
      return wrong(fmt::format(
          "the stream is of store {} and the world with fingerprint {}; this server has {} and {}; "
          "give all servers of a cluster the same --world and secret.key_file",
          to_string(genesis->identity.store_id), to_string(genesis->identity.fingerprint), to_string(*id_),
          to_string(parts_.fingerprint)));
    }
    facts.from_nothing = genesis->head.position == 0 && genesis->head.revision == 0;
    return facts;
  }

  /// Returns false if no peer has a store and this server continues without.
  [[nodiscard]] tl::expected<bool, std::string> take_for(const StartPlan& plan, const StreamState& stream) {
    give_up_ = plan.may_do_without;
    // If messages between store and stream are missing, the store is useless whatever others have.
    if (local_ && !rejoin_.empty() && local_->stream.sequence + 1 >= stream.first) {
      aside_ = AsideStore{local_->stream.sequence, local_->stream.created_ns,
                          cluster::server_number(parts_.directory.path())};
    }
    parts_.on_aside(aside_);
    auto taken = take(WantedPlace{stream.created_ns, stream.first});
    if (!taken && own_goes_on_) return false;
    aside_.reset();
    parts_.on_aside(aside_);
    if (taken) return true;
    if (!give_up_ || !gave_up_) return tl::unexpected{std::move(taken.error())};
    parts_.log->info("joining: reading the stream instead");
    return false;
  }

  /// Uses the store that was put aside, because no peer has another.
  [[nodiscard]] Status use_own() {
    parts_.log->error(
        "joining: all servers that answer have put their stores aside, so votes in the log must have been "
        "false. This one, at message {}, has read most: it goes on with its own, and the others take it from "
        "here. Check which users may publish to the log (NATS' permissions, \"talusd cluster check\"). It "
        "was put aside because: {}",
        local_->stream.sequence, rejoin_);
    if (auto forgotten = forget_rejoin(parts_.directory.path()); !forgotten) return forgotten;
    rejoin_.clear();
    own_goes_on_ = false;
    aside_.reset();
    parts_.on_aside(aside_);
    return {};
  }

  [[nodiscard]] Status take(const WantedPlace& place) {
    const auto began = SteadyClock::now();
    const AfterRound after_round = [this, began](std::chrono::milliseconds wait, const Round& round) {
      gave_up_ = give_up_;
      const bool patient = SteadyClock::now() - began < parts_.silent_patience;
      own_goes_on_ = aside_ && goes_on(*aside_, round, patient);
      return !own_goes_on_ && !give_up_ && parts_.pause(wait);
    };
    const fs::path& path = parts_.directory.path();
    const auto meta = take_from_peers(parts_.peers, path, {parts_.fingerprint, id_, place}, parts_.log,
                                      parts_.on_joining, after_round);
    if (!meta) return tl::unexpected{meta.error()};
    const auto replaced = store::swap_in(path);
    if (!replaced) return tl::unexpected{replaced.error()};
    if (auto tidied = tidy(*replaced, *meta); !tidied) return tidied;
    if (auto known = parts_.directory.learn_identity(); !known) return known;
    ++joins_;
    local_ = *meta;
    id_ = meta->store_id;
    return {};
  }

  /// Keeps the previous store unless the new one has everything in it.
  [[nodiscard]] Status tidy(const fs::path& replaced, const store::StoreMeta& now) {
    const bool of_value =
        is_damaged_ || (local_ && (!is_ancestor(*local_, now) || !is_known_ || !rejoin_.empty()));
    is_damaged_ = false;
    std::error_code code;
    if (!replaced.empty() && of_value) {
      const auto kept = store::keep_rejoined(parts_.directory.path(), replaced);
      if (!kept) return tl::unexpected{kept.error()};
      parts_.log->warn(
          "joining: the store that was here is kept as {}, until two more are replaced; delete it if it is "
          "not needed",
          kept->string());
    } else if (!replaced.empty()) {
      fs::remove_all(replaced, code);
    }
    if (auto forgotten = forget_rejoin(parts_.directory.path()); !forgotten) return forgotten;
    rejoin_.clear();
    return {};
  }

  /// Creates an empty store with the cluster's id, replacing one without entries.
  [[nodiscard]] Status begin_empty() {
    const fs::path& path = parts_.directory.path();
    std::error_code code;
    for (const char* const part : {"acknowledged", "db", "store.toml"}) {
      fs::remove_all(path / part, code);
      if (code) return tl::unexpected{fmt::format("{}: {}", (path / part).string(), code.message())};
    }
    return parts_.directory.begin({*id_, parts_.fingerprint});
  }

  const Parts& parts_;
  std::optional<ContentHash> id_;
  std::optional<store::StoreMeta> local_;
  std::string rejoin_;
  bool is_damaged_ = false;  // the local store cannot be read
  bool give_up_ = false;     // if no peer has a store
  bool gave_up_ = false;
  std::optional<AsideStore> aside_;  // the local store while it must not be used
  bool own_goes_on_ = false;         // it is used after all
  bool is_known_ = false;            // the stream has the local store's last applied message
  bool is_compared_ = true;  // false only if the local store came from a peer before there was a stream
  std::uint64_t joins_ = 0;
};

}  // namespace

tl::expected<PreparedStore, std::string> prepare_store(const Parts& parts) {
  return Preparation{parts}.run();
}

Status want_rejoin(const fs::path& directory, const std::string& reason) {
  const std::string text = on_one_line(reason).substr(0, kMaxReasonBytes);
  if (const auto written = files::write_file(directory / store::kRejoinName, std::string_view{text});
      !written) {
    return tl::unexpected{written.error().message()};
  }
  return {};
}

Status forget_rejoin(const fs::path& directory) {
  std::error_code code;
  fs::remove(directory / store::kRejoinName, code);
  if (code)
    return tl::unexpected{fmt::format("{}: {}", (directory / store::kRejoinName).string(), code.message())};
  return {};
}

}  // namespace talus::server::join
