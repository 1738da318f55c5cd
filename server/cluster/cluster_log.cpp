#include "cluster/cluster_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cluster/log_reasons.h"
#include "cluster/server_number.h"
#include "edits/admission/log_admission.h"
#include "runtime/reasons.h"

namespace talus::server::cluster {
namespace {

using std::chrono::milliseconds;
using SteadyClock = std::chrono::steady_clock;

/// A deposed leader may report fewer messages until it learns of that.
constexpr std::chrono::seconds kSureOfShorter{15};

}  // namespace

ClusterLog::ClusterLog(Parts parts, Settings settings)
    : parts_{std::move(parts)},
      settings_{std::move(settings)},
      identity_{parts_.database.meta().store_id, parts_.database.meta().fingerprint},
      writer_{parts_.database, parts_.state,      parts_.clock,
              settings_.store, parts_.on_changed, [this] { parts_.stream.wake(); }},
      publisher_{{parts_.stream, parts_.clock, identity_, server_number(parts_.database.path()),
                  settings_.settles,
                  [this] {
                    const edits::Head head = writer_.status().head;
                    return Publisher::Stand{head.revision, head.hash};
                  },
                  [this] { tell_whether_it_takes(); }}},
      comparison_{publisher_.id()} {
  const store::StreamPlace place = parts_.database.meta().stream;
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
    // The applier answers entries, unless the store cannot be written.
    const auto until = SteadyClock::now() + settings_.last_wait;
    while (applier_.joinable() && fault_.empty() && !writer_.is_broken() && publisher_.takes() &&
           publisher_.open() > 0 && SteadyClock::now() < until) {
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

// ---- called from any thread

bool ClusterLog::takes_entries() const {
  return !status().read_only;
}

tl::expected<void, EditError> ClusterLog::append(LogEntry entry, Callback done) {
  if (auto admitted = admit_to_log(entry, parts_.state, parts_.clock); !admitted) {
    return tl::unexpected{unless_behind(std::move(admitted.error()))};
  }
  if (auto read_only = writer_.status().read_only) {
    return edit_error(EditErrorCode::unwritable, *std::move(read_only));
  }
  if (auto refuses = status().read_only) return edit_error(EditErrorCode::cut_off, *std::move(refuses));
  return publisher_.append(std::move(entry), std::move(done));
}

tl::expected<void, EditError> ClusterLog::room_for_editor() const {
  auto room = admit_editor(parts_.state, parts_.clock);
  if (!room) return tl::unexpected{unless_behind(std::move(room.error()))};
  return room;
}

EditError ClusterLog::unless_behind(EditError error) const {
  if (error.code != EditErrorCode::editors_full) return error;
  const State now = status();
  if (now.ready && !now.read_only && now.lag == 0) return error;
  return {EditErrorCode::cut_off,
          fmt::format("this server is not at the end of the log that this world's servers share ({} messages "
                      "behind), and may not know all editors; retry in 2 s",
                      now.lag)};
}

ClusterLog::State ClusterLog::status() const {
  State status;
  StoreWriter::State store = writer_.status();
  StreamFigures figures = parts_.stream.figures();
  const std::string publishing = publisher_.trouble();
  const bool takes = publisher_.takes();
  status.head = store.head;
  status.waiting = publisher_.open();
  status.republished = publisher_.republished();
  status.gaps = figures.gaps;
  status.false_messages = figures.false_messages;
  const std::lock_guard lock{mutex_};
  // In that case edits are rejected.
  const bool silent = end_.silent_since() && SteadyClock::now() - *end_.silent_since() > LogEnd::kSilent;
  status.connected = figures.connected;
  status.disk_wait = store.disk_wait;
  status.late = std::move(figures.late);
  status.quorum = heard_ && !silent && takes;
  status.differs = differs_;
  status.lag = end_.lag();
  status.sequence = sequence_;
  status.skipped = skipped_;
  status.bounded = bounded_;
  status.stuck = stuck_since_ && !fault_.empty();  // once fault_ is set
  if (stopping_) {
    status.read_only = "this server is shutting down";
  } else if (!fault_.empty()) {
    status.read_only = fault_;
  } else if (!undecided_.empty()) {
    status.read_only = undecided_;
  } else if (store.read_only) {
    status.read_only = store.read_only;
  } else if (!places_known_ && !begins_without_log()) {
    status.read_only = trouble_.empty() ? kLooking : trouble_;
  } else if (!unreadable_.empty()) {
    status.read_only = unreadable_;
  } else if (shorter_) {
    status.read_only = kShorter;
  } else if (!takes || silent || !places_known_) {
    const std::string& why = publishing.empty() || is_refused_ ? trouble_ : publishing;
    status.read_only =
        fmt::format("the log that this world's servers share cannot be reached or read, or has no quorum{}{}",
                    why.empty() ? "" : ": ", why);
  }
  const bool is_behind = !end_.is_ready() && !begins_without_log();
  status.ready = !store.gone && (fault_.empty() ? !shorter_ && !is_behind : all_are_stuck());
  if (!status.ready) status.not_ready = reasons(store, status.read_only.value_or(""), is_behind);
  return status;
}

std::string ClusterLog::reasons(const StoreWriter::State& store, const std::string& read_only,
                                bool is_behind) const {
  Reasons all;
  all.add(fault_);
  all.add(store.read_only.value_or(""));
  all.add(store.disk_wait);
  all.add(undecided_);
  all.add(unreadable_);
  if (shorter_) all.add(kShorter);
  if (is_behind && places_known_ && heard_) {
    const auto behind = std::chrono::duration_cast<std::chrono::seconds>(end_.behind());
    all.add(fmt::format("{} messages and {} s behind the log's end", end_.lag(), behind.count()));
  } else if (is_behind && trouble_.empty()) {
    all.add(kLooking);
  }
  // Behind a reason that may end with it.
  all.add(read_only);
  if (is_behind) all.add(trouble_);
  return all.text();
}

bool ClusterLog::all_are_stuck() const {
  return stuck_since_ && !others_go_on_ && (was_ready_ || stuck_at_end_);
}

bool ClusterLog::begins_without_log() const {
  return sequence_ > 0 && !heard_ && began_silent_;
}

// ---- the end of the stream

void ClusterLog::watch() {
  milliseconds left{};
  do {
    const auto began = SteadyClock::now();
    poll_end();
    // A failed request has already waited.
    left = std::chrono::ceil<milliseconds>(settings_.poll_interval - (SteadyClock::now() - began));
  } while (pause(std::max(left, milliseconds{0})));
}

void ClusterLog::poll_end() {
  const TimePoint asked = SteadyClock::now();
  std::uint64_t sequence = 0;
  std::int64_t created_ns = 0;
  bool known = false;  // the next message is available there
  {
    const std::lock_guard lock{mutex_};
    sequence = sequence_;
    created_ns = created_ns_;
    known = places_known_;
  }
  const bool is_of_stream = created_ns != 0;
  const auto stream = parts_.stream.state();
  bool shorter = false;
  {
    const std::lock_guard lock{mutex_};
    if (!stream) {
      end_.unanswered(asked);
      began_silent_ = began_silent_ || !heard_;
      shorter_since_.reset();  // the next answer may come from another leader
      if (!known || trouble_.empty() || trouble_is_silence_) {
        trouble_ = stream.error().reason;
        trouble_is_silence_ = true;
      }
      is_refused_ = stream.error().kind == StreamFailure::Kind::refused;
    } else {
      is_refused_ = false;
      end_.answered(asked);
      if (known && trouble_is_silence_) trouble_.clear();
      trouble_is_silence_ = false;
      if (known) heard_ = true;
      if (!is_of_stream || stream->created_ns != created_ns) {
        shorter_since_.reset();
      } else if (stream->last < sequence) {
        shorter_ = true;
        if (!shorter_since_) shorter_since_ = asked;
        shorter = asked - *shorter_since_ > kSureOfShorter;
      } else {
        shorter_ = false;
        shorter_since_.reset();
        if (known) end_.heard(stream->last, asked);
        if (stuck_since_ && asked - *stuck_since_ > settings_.sure_of_stuck) {
          if (!stuck_at_end_) stuck_at_end_ = stream->last;
          if (stream->last > *stuck_at_end_) others_go_on_ = true;
        }
      }
    }
  }
  tell_whether_it_takes();
  if (!stream || !is_of_stream) return;
  if (stream->created_ns != created_ns) {
    lose(StoreLoss::other, kMadeAnew);
  } else if (shorter) {
    lose(StoreLoss::other, fmt::format("the stream ends at message {}, and this server has applied {}",
                                       stream->last, sequence));
  }
}

void ClusterLog::tell_whether_it_takes() {
  {
    // The value is stored before another thread can check, so that the last check wins.
    const std::lock_guard lock{telling_};
    const bool takes = takes_entries();
    if (std::exchange(was_taking_, takes) == takes) return;
  }
  parts_.on_takes();
}

void ClusterLog::trouble(std::string reason) {
  const std::lock_guard lock{mutex_};
  trouble_ = std::move(reason);
  trouble_is_silence_ = false;
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

void ClusterLog::lose(StoreLoss how, const std::string& reason) {
  if (stop_applying(reason)) parts_.on_lost(how, reason);
}

}  // namespace talus::server::cluster
