#include "cluster/publisher.h"

#include <algorithm>
#include <iterator>
#include <random>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cluster/entry_codec.h"

namespace talus::server::cluster {
namespace {

// Size of the length before each entry of a batch.
constexpr std::size_t kLengthBytes = 3;

std::span<const std::byte> seal_of(std::span<const std::byte> message) {
  return message.last(std::min(kSealBytes, message.size()));
}

}  // namespace

Publisher::Publisher(Parts parts)
    : parts_{std::move(parts)}, id_{publisher_of(parts_.server_number, std::random_device{}())}, queue_{{}} {}

void Publisher::start() {
  thread_ = std::thread{[this] { run(); }};
}

void Publisher::stop() {
  {
    const std::lock_guard lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  queue_.stop();
  if (thread_.joinable()) thread_.join();
}

void Publisher::give_up(const std::string& why) {
  {
    const std::lock_guard lock{mutex_};
    if (std::exchange(gave_up_, true)) return;
    trouble_ = why;
  }
  set_takes(false);
  changed_.notify_all();
  queue_.wake();
}

EditError Publisher::cut_off() const {
  const std::string why = trouble();
  return {EditErrorCode::cut_off,
          fmt::format("the log that this world's servers share takes no edits now{}{}; retry in 2 s",
                      why.empty() ? "" : ": ", why)};
}

tl::expected<void, EditError> Publisher::append(LogEntry entry, EditLog::Callback done) {
  if (!takes()) return tl::unexpected{cut_off()};
  EncodedMessage encoded;
  encode(entry, encoded.bytes);
  const auto too_large = [&] {
    return encoded.bytes.size() + kLengthBytes + batch_overhead(parts_.settles) > kMaxMessageBytes;
  };
  // A refusal for its secrets, or their size in it, would tell how much ore there is: it reveals none.
  if (auto* const edit = std::get_if<edits::EditEntry>(&entry);
      edit != nullptr && !edit->secrets.empty() && too_large()) {
    edit->secrets = {};
    encoded.bytes.clear();
    encode(entry, encoded.bytes);
  }
  if (too_large()) {
    return edit_error(
        EditErrorCode::out_of_range,
        fmt::format("the edit takes {} bytes of the log, over the limit {} of a message; split it",
                    encoded.bytes.size(), kMaxMessageBytes - batch_overhead(parts_.settles)));
  }
  // An undecodable entry would stop all servers.
  if (!decode_entry(encoded.bytes, parts_.settles)) {
    return edit_error(EditErrorCode::out_of_range, "the edit exceeds a bound of the log's entries; split it");
  }
  // Bounds the memory for decoding as well as the encoded size.
  const std::size_t bytes = std::max(encoded.bytes.size() + kLengthBytes, bytes_of(entry));
  return queue_.put({std::move(encoded), std::move(done), bytes});
}

void Publisher::say(const Stand& stand) {
  {
    const std::lock_guard lock{mutex_};
    to_say_ = stand;
  }
  queue_.wake();
}

std::string Publisher::trouble() const {
  const std::lock_guard lock{mutex_};
  return trouble_;
}

std::size_t Publisher::open() const {
  std::size_t open = queue_.size();
  const std::lock_guard lock{mutex_};
  for (const auto& [number, each] : open_) open += each.done.size();
  return open;
}

std::vector<EditLog::Callback> Publisher::seen(const BatchHead& head, std::span<const std::byte> message) {
  if (head.publisher != id_) return {};
  std::vector<EditLog::Callback> done;
  {
    const std::lock_guard lock{mutex_};
    const auto open = open_.find(head.number);
    if (open == open_.end() || !std::ranges::equal(open->second.seal, seal_of(message))) return {};
    done = std::exchange(open->second.done, {});
    open->second.seen = true;
  }
  changed_.notify_all();
  return done;
}

bool Publisher::is_open(const BatchHead& head, std::span<const std::byte> message) const {
  if (head.publisher != id_) return false;
  const std::lock_guard lock{mutex_};
  const auto open = open_.find(head.number);
  return open != open_.end() && !open->second.seen && std::ranges::equal(open->second.seal, seal_of(message));
}

void Publisher::go_by(std::int64_t time_ms) {
  const std::lock_guard lock{mutex_};
  right_time_ = RightTime{time_ms, std::chrono::steady_clock::now()};
}

std::int64_t Publisher::time_ms() const {
  using std::chrono::milliseconds;
  const std::lock_guard lock{mutex_};
  if (right_time_) {
    const auto since = std::chrono::steady_clock::now() - right_time_->at;
    return right_time_->ms + std::chrono::duration_cast<milliseconds>(since).count();
  }
  const auto now = std::chrono::duration_cast<milliseconds>(parts_.clock.wall().time_since_epoch());
  return std::max<std::int64_t>(now.count(), 0);
}

void Publisher::run() {
  constexpr std::chrono::hours kLong{1};
  for (;;) {
    // The sleep is short, so calls meanwhile can wait.
    std::this_thread::sleep_until(pace_.next_at(queue_.size()));
    const std::size_t room = kBatchBytes - batch_overhead(parts_.settles);
    auto taken = queue_.take(kMaxEntries, room, std::chrono::steady_clock::now() + kLong);
    std::optional<Stand> stand;
    bool gave_up = false;
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) return;
      gave_up = gave_up_;
      stand = std::exchange(to_say_, std::nullopt);
      // Removes messages that were seen and answered.
      std::erase_if(open_, [](const auto& each) { return each.second.seen && each.second.done.empty(); });
    }
    if (gave_up) {
      refuse(taken);
      refuse_all();
      answer_open();
      continue;
    }
    if (taken.empty() && !stand) continue;
    pace_.sent(std::chrono::steady_clock::now(), taken.size());
    if (!stand) stand = parts_.stand();
    std::vector<store::Bytes> entries;
    std::vector<EditLog::Callback> done;
    for (Queue::Item& each : taken) {
      entries.push_back(std::move(each.entry.bytes));
      done.push_back(std::move(each.done));
    }
    send(*stand, entries, std::move(done));
  }
}

void Publisher::send(const Stand& stand, std::span<const store::Bytes> entries,
                     std::vector<EditLog::Callback> done) {
  bool gave_up = false;
  {
    const std::lock_guard lock{mutex_};
    if (stopping_) return;
    gave_up = gave_up_;
  }
  if (gave_up) return answer(done, cut_off());
  const BatchHead head{parts_.identity, id_, ++number_, time_ms(), stand.revision, stand.hash};
  const store::Bytes message = encode_batch(head, parts_.settles, entries);
  {
    OpenMessage open{std::move(done), {}};
    open.seal.assign(seal_of(message).begin(), seal_of(message).end());
    const std::lock_guard lock{mutex_};
    open_.emplace(head.number, std::move(open));
  }
  const auto not_stored = publish(head.number, message, !entries.empty());
  if (!not_stored) return;
  {
    const std::lock_guard lock{mutex_};
    done = std::move(open_.extract(head.number).mapped().done);
  }
  if (not_stored->may_be_stored) return answer_unknown(done, not_stored->reason);
  if (not_stored->kind == StreamFailure::Kind::rejected) {
    answer(done, cut_off());
    return send(stand, {}, {});
  }
  if (entries.size() > 1) {
    const std::size_t half = entries.size() / 2;
    std::vector<EditLog::Callback> rest{std::move_iterator{done.begin() + static_cast<std::ptrdiff_t>(half)},
                                        std::move_iterator{done.end()}};
    done.resize(half);
    send(stand, entries.first(half), std::move(done));
    return send(stand, entries.subspan(half), std::move(rest));
  }
  answer(done,
         {EditErrorCode::out_of_range,
          fmt::format("the edit takes {} bytes of the log that this world's servers share, more than it "
                      "accepts ({}); split it",
                      message.size(), not_stored->reason)});
}

std::optional<Publisher::NotStored> Publisher::publish(std::uint64_t number,
                                                       std::span<const std::byte> message, bool may_give_up) {
  const auto began = std::chrono::steady_clock::now();
  bool may_be_stored = false;
  for (bool first = true;; first = false) {
    if (!first) republished_.add();
    const auto acked = parts_.stream.publish(message);
    if (acked) break;
    using Kind = StreamFailure::Kind;
    if (acked.error().kind == Kind::too_large) {
      set_takes(true);
      return NotStored{Kind::too_large, acked.error().reason, may_be_stored};
    }
    if (acked.error().kind == Kind::other || acked.error().kind == Kind::false_message) {
      give_up(acked.error().reason);
      return std::nullopt;
    }
    const bool rejected = acked.error().kind == Kind::rejected;
    may_be_stored = may_be_stored || !rejected;
    {
      const std::lock_guard lock{mutex_};
      if (stopping_ || gave_up_) return std::nullopt;
      trouble_ = acked.error().reason;
    }
    if (std::chrono::steady_clock::now() - began > kPatience) {
      set_takes(false);
      refuse_all();
      if (may_give_up && !may_be_stored) return NotStored{Kind::rejected, acked.error().reason};
    }
    if (wait_for_retry(number, rejected ? kRetryRejected : kRetry)) break;
  }
  const auto took = std::chrono::steady_clock::now() - began;
  pace_.acknowledged(took);
  latency_.add(took);
  {
    const std::lock_guard lock{mutex_};
    if (stopping_ || gave_up_) return std::nullopt;
    trouble_.clear();
  }
  set_takes(true);
  return std::nullopt;
}

bool Publisher::wait_for_retry(std::uint64_t number, std::chrono::milliseconds pause) {
  std::unique_lock lock{mutex_};
  const auto is_seen = [&] {
    const auto open = open_.find(number);
    return open == open_.end() || open->second.seen;
  };
  changed_.wait_for(lock, pause, [&] { return stopping_ || gave_up_ || is_seen(); });
  return stopping_ || gave_up_ || is_seen();
}

void Publisher::set_takes(bool takes) {
  bool changes = false;
  {
    const std::lock_guard lock{mutex_};
    takes = takes && !gave_up_;
    changes = takes_.exchange(takes, std::memory_order_acq_rel) != takes;
  }
  if (changes) parts_.on_change();
}

void Publisher::refuse(const std::vector<Queue::Item>& waiting) const {
  if (waiting.empty()) return;
  // They are in no message, so their outcome is known.
  const tl::expected<const edits::EntryResult*, EditError> failure = tl::unexpected{cut_off()};
  for (const Queue::Item& each : waiting) each.done(failure);
}

void Publisher::refuse_all() {
  for (;;) {
    const auto waiting = queue_.take(kMaxEntries, SIZE_MAX, Queue::TimePoint::min());
    if (waiting.empty()) return;
    refuse(waiting);
  }
}

void Publisher::answer_open() {
  std::map<std::uint64_t, OpenMessage> open;
  {
    const std::lock_guard lock{mutex_};
    open.swap(open_);
  }
  for (const auto& [number, each] : open) answer_unknown(each.done, trouble());
}

void Publisher::answer_unknown(const std::vector<EditLog::Callback>& done, std::string_view why) {
  answer(done, {EditErrorCode::unwritable,
                fmt::format(
                    "the edit's outcome is unknown; it may be in the log that this world's servers share: {}",
                    why)});
}

void Publisher::answer(const std::vector<EditLog::Callback>& done, EditError error) {
  const tl::expected<const edits::EntryResult*, EditError> failure = tl::unexpected{std::move(error)};
  for (const EditLog::Callback& each : done) each(failure);
}

}  // namespace talus::server::cluster
