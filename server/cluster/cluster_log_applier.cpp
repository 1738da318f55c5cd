// The applier's thread: applies the stream's messages and runs the store writer.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cluster/batch_time.h"
#include "cluster/cluster_log.h"
#include "cluster/entry_codec.h"
#include "cluster/log_reasons.h"
#include "cluster/server_number.h"

namespace talus::server::cluster {
namespace {

using std::chrono::milliseconds;
using SteadyClock = std::chrono::steady_clock;

/// After this many failed reads a chunk counts as lost.
constexpr int kTriesToRead = 10;
constexpr const char* kNotUnderstood =
    "; and it cannot read the log formats in the stream's description; upgrade it, or correct the "
    "description (talusd cluster check) and restart it";
/// Minimum time between log lines about one kind of message.
constexpr std::chrono::seconds kBetweenWarnings{1};

}  // namespace

void ClusterLog::apply_all() {
  while (!stopping()) {
    writer_.poll();
    if (const std::string& damage = parts_.database.damage(); !damage.empty()) {
      lose(StoreLoss::wrong_state, damage);
    }
    bool faulty = false;
    {
      const std::lock_guard lock{mutex_};
      faulty = !fault_.empty();
    }
    // A store that is closed after a disk error does not tell whether a chunk can be read.
    if (faulty || writer_.has_batch() || writer_.is_broken()) {
      // The store writer keeps running.
      const auto left = std::chrono::ceil<milliseconds>(writer_.next_poll() - SteadyClock::now());
      (void)pause(std::clamp(left, milliseconds{1}, kRetryOfFault));
      continue;
    }
    {
      // poll() may have written a pending batch.
      const store::StreamPlace place = writer_.status().stream;
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

void ClusterLog::next_message() {
  if (held_) {
    apply(*held_);
    return;
  }
  const std::uint64_t after = parts_.database.meta().stream.sequence;
  const auto until = std::min(writer_.next_poll(), SteadyClock::now() + kRetryOfFault);
  auto message = parts_.stream.next(after, until);
  if (message) {
    if (!*message) return;
    if ((*message)->sequence != after + 1) {
      stop_applying(
          fmt::format("message {} of the log is followed by message {}", after, (*message)->sequence));
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
    case StreamFailure::Kind::too_large:  // of publish() only, as the next
    case StreamFailure::Kind::rejected:
      trouble(failure.reason);
      (void)pause(kRetryOfFault);
      break;
    case StreamFailure::Kind::gone:
      lose(StoreLoss::too_old, failure.reason);
      break;
    case StreamFailure::Kind::other:
      lose(StoreLoss::other, failure.reason);
      break;
    case StreamFailure::Kind::false_message:
      lose(StoreLoss::wrong_state, failure.reason);
      break;
  }
}

void ClusterLog::apply(const StreamMessage& message) {
  const auto decoded = decode_batch(message.bytes, identity_);
  if (!decoded) {
    if (came_damaged(message, decoded.error().reason)) return;
    if (message.bytes.empty()) return skip(message, "it is empty");
    const bool is_newer = decoded.error().kind == MessageFault::Kind::newer;
    return is_newer ? meet_unknown(message, decoded.error()) : skip(message, decoded.error().reason);
  }
  const auto time = time_of(decoded->head, message);
  if (!time) return;
  edits::Batch& batch = writer_.begin(std::max(time->ms, parts_.state.head().time_ms));
  for (std::size_t i = 0; i < decoded->entries.size(); ++i) {
    const auto entry = decode_entry(decoded->entries[i], decoded->settles);
    if (!entry) {
      writer_.drop();
      const auto fault = fault_of_entries(*decoded, i);
      if (came_damaged(message, fault.reason)) return;
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
  std::vector<Callback> done = publisher_.seen(decoded->head, message.bytes);
  if (done.size() != decoded->entries.size()) done.clear();
  const BatchHead said = decoded->head;
  finish(std::move(done),
         {message.sequence, parts_.database.meta().stream.created_ns, time->asked_ms,
          hash_of_message(message.bytes)},
         &said);
}

bool ClusterLog::came_damaged(const StreamMessage& message, const std::string& reason) {
  if (message.of_leader) return false;
  if (const auto now = SteadyClock::now(); now - damage_told_ > kBetweenWarnings) {
    damage_told_ = now;
    parts_.log->error(
        "cluster: message {} of the log arrived damaged, or another program sent it: {}; requesting it from "
        "the log's leader",
        message.sequence, reason);
  }
  parts_.stream.ask_again();
  held_.reset();
  return true;
}

void ClusterLog::skip(const StreamMessage& message, const std::string& reason) {
  {
    const std::lock_guard lock{mutex_};
    ++skipped_;
  }
  if (const auto now = SteadyClock::now(); now - skip_told_ > kBetweenWarnings) {
    skip_told_ = now;
    parts_.log->error(
        "cluster: message {} of the log is not valid for any talusd, and all servers pass over it: {}",
        message.sequence, reason);
  }
  const store::StreamPlace place = parts_.database.meta().stream;
  (void)writer_.begin(parts_.state.head().time_ms);
  finish({}, {message.sequence, place.created_ns, place.asked_ms, hash_of_message(message.bytes)}, nullptr);
}

void ClusterLog::meet_unknown(const StreamMessage& message, const MessageFault& fault) {
  if (message.sequence > none_newer_to_) {
    const auto stream = parts_.stream.state();
    if (!stream) return cannot_get(stream.error());
    if (stream->created_ns != parts_.database.meta().stream.created_ns) {
      return lose(StoreLoss::other, kMadeAnew);
    }
    if (stream->last < message.sequence) {
      // A deposed leader, which may not know enabled formats either.
      trouble(fmt::format("this talusd does not know message {} of the log, and neither does the leader",
                          message.sequence));
      (void)pause(kSoon);
      return;
    }
    if (!stream->enabled.understood) return get_stuck(message, fault.reason + kNotUnderstood);
    if (stream->enabled.is_newer_at(message.sequence)) {
      return get_stuck(message, fmt::format("{}{}", fault.reason, remedy_of(fault)));
    }
    // Formats enabled later begin after the stream's current end. This requires the leader's settings to be
    // at least as new as its messages, which the procedure for enabling a format ensures (FORMAT.md).
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

void ClusterLog::finish(std::vector<Callback> done, const store::StreamPlace& place, const BatchHead* said) {
  const bool stored = writer_.store(std::move(done), place);
  held_.reset();  // if not stored, the writer keeps the batch
  if (said != nullptr) compare(*said);
  if (stored) return applied(place.sequence);
  const std::string reason = *writer_.read_only();
  trouble(reason);
  parts_.log->error("cluster: message {} of the log cannot be written: {}; it is tried again each second",
                    place.sequence, reason);
  tell_whether_it_takes();
}

std::optional<ClusterLog::Time> ClusterLog::time_of(const BatchHead& head, const StreamMessage& message) {
  const std::int64_t asked_ms = parts_.database.meta().stream.asked_ms;
  if (!must_ask_stream(head.time_ms, asked_ms)) return Time{head.time_ms, asked_ms};
  tl::expected<std::int64_t, StreamFailure> stream_ms;
  if (message.time_ms) {
    stream_ms = *message.time_ms;
  } else {
    stream_ms = parts_.stream.time_of(message.sequence);
  }
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
          "cluster: message {} of the log, of {}, was written by a clock that is {} s ahead of the clock of "
          "the log's leader; synchronize all machines by NTP",
          message.sequence, is_own ? "this server" : fmt::format("server {:08x}", server_of(head.publisher)),
          (head.time_ms - *stream_ms) / 1000);
    }
  }
  return Time{time_ms, std::max(asked_ms, time_ms)};
}

void ClusterLog::cannot_read(const std::string& reason) {
  if (++unread_ >= kTriesToRead) return lose(StoreLoss::wrong_state, reason);
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
  unreadable_.clear();  // applied() notifies
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
                   ", and the servers' votes are equal; run talusd store verify on each, and remove the "
                   "store of one that is not sound";
    } else {
      undecided_.clear();
    }
    if (!was_undecided && !undecided_.empty()) parts_.log->error("cluster: {}", undecided_);
    if (was_undecided && undecided_.empty()) {
      parts_.log->info("cluster: the right state is decided; edits are taken again");
    }
  }
  tell_whether_it_takes();
  if (verdict == Verdict::wrong) {
    lose(StoreLoss::wrong_state, comparison_.what() + ", as most servers have; this server's store is wrong");
  }
}

void ClusterLog::compare(const BatchHead& head) {
  const auto say = comparison_.heard({head.publisher, head.revision, head.hash}, SteadyClock::now());
  if (!say) return;
  parts_.log->error("cluster: {}; all servers now report their state at that revision", comparison_.what());
  publisher_.say({say->revision, say->hash});
}

}  // namespace talus::server::cluster
