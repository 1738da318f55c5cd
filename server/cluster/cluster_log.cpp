#include "cluster/cluster_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cluster/batch_time.h"
#include "cluster/entry_codec.h"
#include "cluster/server_number.h"
#include "edits/index_room.h"

namespace talus::server::cluster {
namespace {

using std::chrono::milliseconds;
using SteadyClock = std::chrono::steady_clock;

constexpr milliseconds kSoon{20};
constexpr milliseconds kRetryOfFault{1'000};
/// A chunk that the disk did not give so often it does not have.
constexpr int kTriesToRead = 10;
constexpr std::string_view kShorter = "the log that this world's servers share seems to have lost its end";
constexpr const char* kMadeAnew = "the stream was made anew since this server read it";
constexpr const char* kNotUnderstood =
    "; and what the stream's description says of log formats it does not understand; upgrade it, or mend the "
    "description (talusd cluster check) and restart it";
constexpr std::chrono::seconds kLastWait{2};
/// A leader that was deposed may say less than there is, until it knows.
constexpr std::chrono::seconds kSureOfShorter{15};
/// Without a word of the leader for so long no edits are taken.
constexpr std::chrono::seconds kSilent{3};
/// Between lines about messages of one kind.
constexpr std::chrono::seconds kBetweenWarnings{1};

std::string not_applied(std::uint64_t sequence, std::string_view reason) {
  return fmt::format("message {} of the log cannot be applied: {}", sequence, reason);
}

}  // namespace

ClusterLog::ClusterLog(Parts parts, Settings settings)
    : parts_{std::move(parts)},
      settings_{std::move(settings)},
      identity_{parts_.database.meta().store_id, parts_.database.meta().fingerprint},
      writer_{parts_.database, parts_.state, settings_.store, parts_.on_changed},
      publisher_{{parts_.stream, parts_.clock, identity_, server_number(parts_.database.path()),
                  settings_.settles,
                  [this] {
                    const edits::Head head = writer_.status().head;
                    return Publisher::Stand{head.revision, head.hash};
                  },
                  [this] { tell_whether_it_takes(); }}},
      comparison_{publisher_.id()} {
  const StreamPlace place = parts_.database.meta().stream;
  sequence_ = place.sequence;
  created_ns_ = place.created_ns;
  end_.applied(place.sequence);
}

void ClusterLog::start() {
  publisher_.start();
  applier_ = std::thread{[this] { apply_all(); }};
  watcher_ = std::thread{[this] { watch(); }};
}

void ClusterLog::stop() {
  {
    std::unique_lock lock{mutex_};
    if (std::exchange(stopping_, true)) return;
    // Answers come from the applier.
    const auto until = SteadyClock::now() + kLastWait;
    while (applier_.joinable() && fault_.empty() && publisher_.takes() && publisher_.open() > 0 &&
           SteadyClock::now() < until) {
      changed_.wait_for(lock, kSoon);
    }
    ending_ = true;
  }
  changed_.notify_all();
  parts_.stream.stop();
  publisher_.stop();
  if (applier_.joinable()) applier_.join();
  if (watcher_.joinable()) watcher_.join();
}

bool ClusterLog::stopping() const {
  const std::lock_guard lock{mutex_};
  return ending_;
}

bool ClusterLog::pause(milliseconds time) {
  std::unique_lock lock{mutex_};
  return !changed_.wait_for(lock, time, [&] { return ending_; });
}

// ---- what is asked from any thread

bool ClusterLog::takes_entries() const {
  return !status().read_only;
}

tl::expected<void, LogFailure> ClusterLog::append(LogEntry entry, Done done) {
  using Kind = LogFailure::Kind;
  if (auto fits = keep_to_index(parts_.state, entry); !fits) return fits;
  if (auto read_only = writer_.status().read_only) {
    return tl::unexpected{LogFailure{Kind::unwritable, *std::move(read_only)}};
  }
  if (auto refuses = status().read_only) {
    return tl::unexpected{LogFailure{Kind::cut_off, *std::move(refuses)}};
  }
  return publisher_.append(std::move(entry), std::move(done));
}

ClusterLog::Status ClusterLog::status() const {
  Status status;
  StoreWriter::Status store = writer_.status();
  const StreamFigures figures = parts_.stream.figures();
  const std::string publishing = publisher_.trouble();
  const bool takes = publisher_.takes();
  status.head = store.head;
  status.waiting = publisher_.open();
  status.republished = publisher_.republished();
  status.gaps = figures.gaps;
  const std::lock_guard lock{mutex_};
  const bool silent = silent_since_ && SteadyClock::now() - *silent_since_ > kSilent;
  status.connected = figures.connected;
  status.quorum = heard_ && !silent && takes;
  status.differs = differs_;
  status.lag = end_.lag();
  status.sequence = sequence_;
  status.skipped = skipped_;
  status.bounded = bounded_;
  status.stuck = stuck_since_.has_value();
  if (stopping_) {
    status.read_only = "this server is about to end";
  } else if (!fault_.empty()) {
    status.read_only = fault_;
  } else if (!undecided_.empty()) {
    status.read_only = undecided_;
  } else if (store.read_only) {
    status.read_only = std::move(store.read_only);
  } else if (!places_known_ && !begins_without_log()) {
    status.read_only = trouble_.empty() ? "this server is looking for its place in the log" : trouble_;
  } else if (!unreadable_.empty()) {
    status.read_only = unreadable_;
  } else if (shorter_) {
    status.read_only = kShorter;
  } else if (!takes || silent || !places_known_) {
    const std::string& why = publishing.empty() ? trouble_ : publishing;
    status.read_only =
        fmt::format("the log that this world's servers share cannot be reached, or has no quorum{}{}",
                    why.empty() ? "" : ": ", why);
  }
  if (!fault_.empty()) {
    if (!all_are_stuck()) status.not_ready = fault_;
  } else if (shorter_) {
    status.not_ready = kShorter;
  } else if (!end_.is_ready() && !begins_without_log()) {
    const auto behind = std::chrono::duration_cast<std::chrono::seconds>(end_.behind());
    status.not_ready = !places_known_ || !heard_
                           ? (trouble_.empty() ? "looking for its place in the log" : trouble_)
                           : fmt::format("{} messages and {} s behind the log's end{}{}", end_.lag(),
                                         behind.count(), trouble_.empty() ? "" : ": ", trouble_);
  }
  status.ready = status.not_ready.empty();
  return status;
}

bool ClusterLog::all_are_stuck() const {
  return stuck_since_ && !others_go_on_ && (was_ready_ || stuck_at_end_);
}

bool ClusterLog::begins_without_log() const {
  return sequence_ > 0 && !heard_ && began_silent_;
}

// ---- the end of the stream

void ClusterLog::watch() {
  do {
    look_at_end();
  } while (pause(settings_.look_interval));
}

void ClusterLog::look_at_end() {
  const TimePoint asked = SteadyClock::now();
  std::uint64_t sequence = 0;
  std::int64_t created_ns = 0;
  bool known = false;
  {
    const std::lock_guard lock{mutex_};
    sequence = sequence_;
    created_ns = created_ns_;
    known = places_known_;
  }
  const auto stream = parts_.stream.state();
  bool shorter = false;
  {
    const std::lock_guard lock{mutex_};
    if (!stream) {
      if (!silent_since_) silent_since_ = asked;
      began_silent_ = began_silent_ || !heard_;
      shorter_since_.reset();  // it may be another leader that speaks next
      if (!known || trouble_.empty()) trouble_ = stream.error().reason;
    } else {
      silent_since_.reset();
      if (known) heard_ = true;
      if (!known || stream->created_ns != created_ns) {
        shorter_since_.reset();
      } else if (stream->last < sequence) {
        shorter_ = true;
        if (!shorter_since_) shorter_since_ = asked;
        shorter = asked - *shorter_since_ > kSureOfShorter;
      } else {
        shorter_ = false;
        shorter_since_.reset();
        end_.heard(stream->last, asked);
        if (stuck_since_ && asked - *stuck_since_ > settings_.sure_of_stuck) {
          if (!stuck_at_end_) stuck_at_end_ = stream->last;
          if (stream->last > *stuck_at_end_) others_go_on_ = true;
        }
      }
    }
  }
  tell_whether_it_takes();
  if (!stream || !known) return;
  if (stream->created_ns != created_ns) {
    lose(Lost::other, kMadeAnew);
  } else if (shorter) {
    lose(Lost::other, fmt::format("the stream ends at message {}, and this server has applied {}",
                                  stream->last, sequence));
  }
}

void ClusterLog::tell_whether_it_takes() {
  const bool takes = takes_entries();
  {
    const std::lock_guard lock{mutex_};
    if (std::exchange(was_taking_, takes) == takes) return;
  }
  parts_.on_takes();
}

void ClusterLog::trouble(std::string reason) {
  const std::lock_guard lock{mutex_};
  trouble_ = std::move(reason);
}

bool ClusterLog::stop_applying(std::string reason) {
  {
    const std::lock_guard lock{mutex_};
    if (!fault_.empty() || ending_) return false;
    fault_ = reason;
    parts_.log->error("cluster: {}; this server takes no edits", fault_);
  }
  changed_.notify_all();
  publisher_.give_up(reason);
  tell_whether_it_takes();
  return true;
}

void ClusterLog::lose(Lost how, const std::string& reason) {
  if (stop_applying(reason)) parts_.on_lost(how, reason);
}

// ---- applying

void ClusterLog::apply_all() {
  while (!stopping()) {
    writer_.look();
    bool faulty = false;
    {
      const std::lock_guard lock{mutex_};
      faulty = !fault_.empty();
    }
    if (faulty || writer_.has_batch()) {
      // The store is minded all the same.
      const auto left = std::chrono::ceil<milliseconds>(writer_.next_look() - SteadyClock::now());
      (void)pause(std::clamp(left, milliseconds{1}, kRetryOfFault));
      continue;
    }
    {
      // What look() could write at last.
      const StreamPlace place = writer_.status().stream;
      if (place.sequence != 0) applied(place.sequence);
    }
    if (!placed_ && !find_place()) {
      (void)pause(kRetryOfFault / 4);
      continue;
    }
    next_message();
  }
  writer_.flush_all();
}

bool ClusterLog::find_place() {
  const auto stream = parts_.stream.state();
  if (!stream) {
    trouble(stream.error().reason);
    return false;
  }
  const StreamPlace place = parts_.database.meta().stream;
  if (stream->last == 0) {
    trouble("the stream has no genesis; run talusd cluster init");
    const std::lock_guard lock{mutex_};
    began_silent_ = false;  // it spoke, and this is no stream to wait for
    return false;
  }
  if (place.sequence == 0) {
    if (!begin_at_genesis(*stream)) return false;
  } else if (place.created_ns != stream->created_ns) {
    lose(Lost::other, kMadeAnew);
    return false;
  } else if (stream->first > place.sequence + 1) {
    lose(Lost::too_old,
         fmt::format("the stream keeps messages from {} on, and this server has those up to {}",
                     stream->first, place.sequence));
    return false;
  }
  const StreamPlace now = parts_.database.meta().stream;
  placed_ = true;
  {
    const std::lock_guard lock{mutex_};
    places_known_ = true;
    created_ns_ = now.created_ns;
    sequence_ = now.sequence;
    end_.applied(now.sequence);
    trouble_.clear();
  }
  const edits::Head& head = parts_.state.head();
  comparison_.stands(head.revision, head.hash);
  parts_.log->info("cluster: goes on behind message {} of {}", now.sequence, stream->last);
  tell_whether_it_takes();
  return true;
}

bool ClusterLog::begin_at_genesis(const StreamState& stream) {
  const edits::Head& own = parts_.state.head();
  const bool is_empty = own.position == 0;
  if (stream.first > 1) {
    lose(is_empty ? Lost::no_start : Lost::too_old,
         fmt::format("the stream keeps messages from {} on, and this server has none of it", stream.first));
    return false;
  }
  const auto first = parts_.stream.next(0, SteadyClock::now() + milliseconds{500});
  if (!first || !*first) {
    trouble(first ? "the stream's first message does not come" : first.error().reason);
    return false;
  }
  const auto genesis = decode_genesis((*first)->bytes);
  if (!genesis) {
    const MessageFault& fault = genesis.error();
    stop_applying(not_applied(1, fmt::format("{}{}", fault.reason, remedy_of(fault))));
    return false;
  }
  if (genesis->identity.store_id != identity_.store_id) {
    stop_applying(fmt::format("the stream is of store {}; this server has store {}",
                              to_string(genesis->identity.store_id), to_string(identity_.store_id)));
  } else if (genesis->identity.fingerprint != identity_.fingerprint) {
    stop_applying(
        fmt::format("the stream is of the world with fingerprint {}; this server's world has {}; "
                    "all servers of a store must have the same world",
                    to_string(genesis->identity.fingerprint), to_string(identity_.fingerprint)));
  } else if (genesis->level_rule != edits::kLevelRule) {
    stop_applying(
        fmt::format("the stream's coarse levels are made by rule {}; this talusd has rule {}; all "
                    "servers of a store must have the same",
                    genesis->level_rule, edits::kLevelRule));
  } else if (settings_.settles != nullptr && *settings_.settles != genesis->settles) {
    stop_applying(
        "loose material slides otherwise in this world than in the stream's; all servers of a "
        "store must have the same world");
  } else if (genesis->head != own) {
    lose(is_empty ? Lost::no_start : Lost::other,
         fmt::format("the stream begins at revision {}, entry {}; this server's store is at revision {}, "
                     "entry {}",
                     genesis->head.revision, genesis->head.position, own.revision, own.position));
  } else {
    EditDatabase::Done entered;
    if (is_empty && !genesis->materials.empty()) entered = parts_.database.bind(genesis->materials);
    if (entered) entered = parts_.database.enter({1, stream.created_ns});
    writer_.entered();
    if (entered) return true;
    trouble(entered.error());
  }
  return false;
}

void ClusterLog::next_message() {
  if (held_) {
    apply(*held_);
    return;
  }
  const std::uint64_t after = parts_.database.meta().stream.sequence;
  const auto until = std::min(writer_.next_look(), SteadyClock::now() + kRetryOfFault);
  auto message = parts_.stream.next(after, until);
  if (message) {
    if (!*message) return;
    if ((*message)->sequence != after + 1) {
      stop_applying(
          fmt::format("behind message {} of the log comes message {}", after, (*message)->sequence));
      return;
    }
    held_ = **std::move(message);
    apply(*held_);
    return;
  }
  cannot_get(message.error());
}

void ClusterLog::cannot_get(const StreamFailure& failure) {
  switch (failure.kind) {
    case StreamFailure::Kind::unavailable:
      trouble(failure.reason);
      (void)pause(kSoon);
      break;
    case StreamFailure::Kind::refused:
      trouble(failure.reason);
      (void)pause(kRetryOfFault);
      break;
    case StreamFailure::Kind::gone:
      lose(Lost::too_old, failure.reason);
      break;
    case StreamFailure::Kind::other:
      lose(Lost::other, failure.reason);
      break;
    case StreamFailure::Kind::false_message:
      lose(Lost::wrong_state, failure.reason);
      break;
  }
}

void ClusterLog::apply(const StreamMessage& message) {
  const auto decoded = decode_batch(message.bytes, identity_);
  if (!decoded) {
    const bool is_newer = decoded.error().kind == MessageFault::Kind::newer;
    return is_newer ? meet_unknown(message, decoded.error()) : skip(message, decoded.error().reason);
  }
  const auto time = time_of(decoded->head, message);
  if (!time) return;
  edits::Batch& batch = writer_.begin(time->ms);
  for (std::size_t i = 0; i < decoded->entries.size(); ++i) {
    const auto entry = decode_entry(decoded->entries[i], decoded->settles);
    if (!entry) {
      writer_.drop();
      const auto fault = fault_of_entries(*decoded, i);
      return fault.kind == MessageFault::Kind::newer ? meet_unknown(message, fault)
                                                     : skip(message, fault.reason);
    }
    std::visit([&](const auto& each) { batch.apply(each); }, *entry);
    if (const auto& unreadable = writer_.reading().error()) {
      const std::string reason = not_applied(message.sequence, *unreadable);
      writer_.drop();
      return cannot_read(reason);
    }
  }
  can_read();
  std::vector<Done> done = publisher_.seen(decoded->head, message.bytes);
  if (done.size() != decoded->entries.size()) done.clear();
  const BatchHead said = decoded->head;
  finish(std::move(done), {message.sequence, parts_.database.meta().stream.created_ns, time->looked_ms},
         &said);
}

void ClusterLog::skip(const StreamMessage& message, const std::string& reason) {
  {
    const std::lock_guard lock{mutex_};
    ++skipped_;
  }
  if (const auto now = SteadyClock::now(); now - skip_told_ > kBetweenWarnings) {
    skip_told_ = now;
    parts_.log->error("cluster: message {} of the log counts for no talusd, and all servers pass over it: {}",
                      message.sequence, reason);
  }
  const StreamPlace place = parts_.database.meta().stream;
  (void)writer_.begin(parts_.state.head().time_ms);
  finish({}, {message.sequence, place.created_ns, place.looked_ms}, nullptr);
}

void ClusterLog::meet_unknown(const StreamMessage& message, const MessageFault& fault) {
  if (message.sequence > none_newer_to_) {
    const auto stream = parts_.stream.state();
    if (!stream) return cannot_get(stream.error());
    if (stream->created_ns != parts_.database.meta().stream.created_ns) {
      return lose(Lost::other, kMadeAnew);
    }
    if (stream->last < message.sequence) {
      // A leader that was deposed: it may not know either what was enabled.
      trouble(
          fmt::format("message {} of the log is one that this talusd does not know, and the leader does "
                      "not know the message",
                      message.sequence));
      (void)pause(kSoon);
      return;
    }
    if (!stream->enabled.understood) return get_stuck(message, fault.reason + kNotUnderstood);
    if (stream->enabled.is_newer_at(message.sequence)) {
      return get_stuck(message, fmt::format("{}{}", fault.reason, remedy_of(fault)));
    }
    // What is enabled later begins behind what there is now. That rests upon this leader's settings being no
    // older than its messages, for which whoever enables a format waits (FORMAT.md).
    none_newer_to_ = std::min(stream->last, stream->enabled.newer_from() - 1);
  }
  skip(message, fault.reason);
}

void ClusterLog::get_stuck(const StreamMessage& message, const std::string& reason) {
  {
    const std::lock_guard lock{mutex_};
    if (!stuck_since_) {
      was_ready_ = end_.is_ready();
      stuck_since_ = SteadyClock::now();
    }
  }
  stop_applying(not_applied(message.sequence, reason));
}

void ClusterLog::finish(std::vector<Done> done, const StreamPlace& place, const BatchHead* said) {
  const bool stored = writer_.store(std::move(done), place);
  held_.reset();  // else the writer has it
  if (said != nullptr) compare(*said);
  if (stored) return applied(place.sequence);
  const std::string reason = *writer_.read_only();
  trouble(reason);
  parts_.log->error("cluster: message {} of the log cannot be written: {}; it is tried again each second",
                    place.sequence, reason);
  tell_whether_it_takes();
}

std::optional<ClusterLog::Time> ClusterLog::time_of(const BatchHead& head, const StreamMessage& message) {
  const std::int64_t looked_ms = parts_.database.meta().stream.looked_ms;
  if (!must_ask_stream(head.time_ms, looked_ms)) return Time{head.time_ms, looked_ms};
  const auto stream_ms = parts_.stream.time_of(message.sequence);
  if (!stream_ms) {
    cannot_get(stream_ms.error());
    return std::nullopt;
  }
  const std::int64_t time_ms = bounded_time(head.time_ms, *stream_ms);
  if (time_ms < head.time_ms) {
    {
      const std::lock_guard lock{mutex_};
      ++bounded_;
    }
    const bool is_own = publisher_.is_open(head, message.bytes);
    if (is_own) publisher_.go_by(*stream_ms);
    if (const auto now = SteadyClock::now(); now - clock_told_ > kBetweenWarnings) {
      clock_told_ = now;
      parts_.log->error(
          "cluster: message {} of the log, of {}, was written by a clock that is {} s before that of "
          "the host that leads the log; let all machines have their time by NTP",
          message.sequence, is_own ? "this server" : fmt::format("server {:08x}", server_of(head.publisher)),
          (head.time_ms - *stream_ms) / 1000);
    }
  }
  return Time{time_ms, std::max(looked_ms, time_ms)};
}

void ClusterLog::cannot_read(const std::string& reason) {
  if (++unread_ >= kTriesToRead) return lose(Lost::wrong_state, reason);
  {
    const std::lock_guard lock{mutex_};
    unreadable_ = reason;
  }
  parts_.log->error("cluster: {}; it is tried again each second", reason);
  tell_whether_it_takes();
  (void)pause(settings_.store.retry_interval);
}

void ClusterLog::can_read() {
  if (std::exchange(unread_, 0) == 0) return;
  const std::lock_guard lock{mutex_};
  unreadable_.clear();  // applied() tells
}

void ClusterLog::applied(std::uint64_t sequence) {
  const edits::Head& head = parts_.state.head();
  comparison_.stands(head.revision, head.hash);
  using Verdict = StateComparison::Verdict;
  const auto verdict = comparison_.judge(SteadyClock::now());
  {
    const std::lock_guard lock{mutex_};
    if (sequence_ != sequence) trouble_.clear();
    sequence_ = sequence;
    end_.applied(sequence);
    differs_ = verdict != Verdict::same;
    const bool was_undecided = !undecided_.empty();
    if (verdict == Verdict::undecided) {
      undecided_ = comparison_.what() +
                   ", and as many say this as say that; run talusd store verify on each, and take away the "
                   "store of one that is not sound";
    } else {
      undecided_.clear();
    }
    if (!was_undecided && !undecided_.empty()) parts_.log->error("cluster: {}", undecided_);
    if (was_undecided && undecided_.empty()) {
      parts_.log->info("cluster: it is decided whose state is right; edits are taken again");
    }
  }
  tell_whether_it_takes();
  if (verdict == Verdict::wrong) {
    lose(Lost::wrong_state, comparison_.what() + ", as most have; this server's store is wrong");
  }
}

void ClusterLog::compare(const BatchHead& head) {
  const auto say = comparison_.heard({head.publisher, head.revision, head.hash}, SteadyClock::now());
  if (!say) return;
  parts_.log->error("cluster: {}; all servers now say what they had then", comparison_.what());
  publisher_.say({say->revision, say->hash});
}

}  // namespace talus::server::cluster
