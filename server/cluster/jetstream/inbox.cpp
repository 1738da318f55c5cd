#include "cluster/jetstream/inbox.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_settings.h"
#include "runtime/random_number.h"

namespace talus::server::jetstream {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Kind = StreamFailure::Kind;

constexpr auto kBetweenQuestions = 1s;  // requests to the leader
constexpr auto kBetweenUrgent = 100ms;  // if something is inconsistent
constexpr auto kSureOfLess = 15s;       // a deposed leader may report fewer messages for a while
constexpr auto kDenied = 3s;  // until replicas are asked again: NATS does not report restored permissions
/// Maximum delay until a reader that waits for the tail notices input of other threads.
constexpr auto kPollInterval = 20ms;
constexpr std::int64_t kNsInMs = 1'000'000;
constexpr int kPendingMessages = 4096;
constexpr int kPendingBytes = 32 << 20;
/// Answers contain messages as base64 in JSON.
constexpr int kPendingAnswerBytes =
    static_cast<int>(MessageReassembler::kMaxRequests * (kStreamMessageBytes / 3 * 4 + 4096));

std::string new_reply_subject() {
  natsInbox* made = nullptr;
  if (natsInbox_Create(&made) != NATS_OK) return {};
  const NatsInbox inbox{made};
  return inbox.get();
}

/// The number at the end of a subject; 0 if missing.
std::uint64_t number_at_end(std::string_view subject) {
  const std::size_t dot = subject.rfind('.');
  const std::string_view digits = subject.substr(dot == std::string_view::npos ? subject.size() : dot + 1);
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

Inbox::Inbox(StreamNames names, Logger log)
    : names_{std::move(names)},
      log_{std::move(log)},
      reply_{new_reply_subject()},
      reassembler_{Clock::now(), random_number()} {}

tl::expected<void, StreamFailure> Inbox::listen(Connection& connection) {
  auto tail = connection.open_source(names_.tail, kPendingMessages, kPendingBytes);
  if (!tail) return tl::unexpected{tail.error()};
  {
    const std::lock_guard lock{mutex_};
    tail_ = *std::move(tail);
  }
  const auto come = [inbox = shared_from_this(), kind = reply_.size() + 1](const ReceivedMessage& arrived) {
    switch (arrived.subject()[kind]) {
      case 'i':
        return inbox->info(number_at_end(arrived.subject()), arrived.text());
      case 'r':
        return inbox->message_of_replica(arrived);
      default:
        return inbox->message(arrived);
    }
  };
  return connection.subscribe(reply_ + ".*.*", come, kPendingMessages, kPendingAnswerBytes);
}

bool Inbox::renew(Connection& connection) {
  using Due = RefusedSubscription::Due;
  Due tail = Due::nothing;
  Due answers = Due::nothing;
  {
    const std::lock_guard lock{mutex_};
    if (!connected_) return false;
    const auto now = Clock::now();
    tail = refused_tail_.due(now);
    answers = refused_answers_.due(now);
  }
  if (tail == Due::restored) log_->info("NATS: {} may be subscribed to again", names_.tail);
  if (tail == Due::try_again) {
    if (auto again = connection.open_source(names_.tail, kPendingMessages, kPendingBytes); again && *again) {
      const std::lock_guard lock{mutex_};
      tail_ = *std::move(again);
    }
  }
  if (answers == Due::try_again) {
    if (auto probe = connection.open_source(reply_ + ".probe", 1, 1)) probe_ = *std::move(probe);
  }
  if (answers != Due::restored) return false;
  probe_.reset();
  return true;
}

RefusedSubscription* Inbox::subscription_of(std::string_view denial) {
  if (denial.find("for Subscription to") == std::string_view::npos) return nullptr;
  return denial.find(names_.tail) == std::string_view::npos ? &refused_answers_ : &refused_tail_;
}

std::string Inbox::without_answers() const {
  const std::lock_guard lock{mutex_};
  return refused_answers_.why();
}

void Inbox::connected(bool now) {
  {
    const std::lock_guard lock{mutex_};
    if (stopped_ || connected_ == now) return;
    connected_ = now;
    refused_tail_.disconnected();
    refused_answers_.disconnected();
    replicas_denied_at_.reset();
    question_due_ = Clock::now();  // unanswered_since_ stays: another server may deny it too
  }
  changed_.notify_all();
  if (now) {
    log_->info("NATS: connected");
  } else {
    log_->warn("NATS: the connection broke; trying all servers of cluster.nats");
  }
}

void Inbox::closed(const StreamFailure& why) {
  bool is_told = false;
  {
    const std::lock_guard lock{mutex_};
    if (stopped_) return;
    closed_ = why;
    is_told = std::exchange(leaves_, false) || closing_told_.is_told(why.reason, Clock::now());
  }
  changed_.notify_all();
  if (!is_told) log_->error("{}; trying again", why.reason);
}

void Inbox::leaves(std::string_view why) {
  {
    const std::lock_guard lock{mutex_};
    leaves_ = true;
  }
  log_->warn("NATS: {}", why);
}

void Inbox::denied(std::string_view what) {
  bool is_news = false;
  {
    const std::lock_guard lock{mutex_};
    const auto now = Clock::now();
    std::string reason = fmt::format("NATS: {}", what);
    if (auto* const subscription = subscription_of(what)) {
      is_news = subscription->refused(std::move(reason), now);
    } else {
      // Direct Get is optional.
      const bool of_replicas = what.find(names_.direct_get()) != std::string_view::npos;
      if (of_replicas) replicas_denied_at_ = now;
      is_news = !denial_told_.is_told(reason, now);
      if (!of_replicas) trouble_ = StreamFailure{Kind::refused, std::move(reason)};
    }
  }
  changed_.notify_all();
  // Requests for messages are repeated many times per second.
  if (is_news)
    log_->error("NATS: {}; see \"Credentials and permissions\" in CLUSTER.md for what talusd must be allowed",
                what);
}

void Inbox::tail(const ReceivedMessage& arrived) {
  if (arrived.bytes().empty()) return;  // from "talusd cluster check"
  if (arrived.header("Nats-Stream") != names_.stream) return count_false();
  if (arrived.bytes().size() > kStreamMessageBytes) return count_false();
  {
    const std::lock_guard lock{mutex_};
    reassembler_.heard(arrived.sequence(), arrived.bytes(), Clock::now());
  }
}

void Inbox::message(const ReceivedMessage& arrived) {
  const std::uint64_t sequence = number_at_end(arrived.subject());
  // Keeps one byte more than the largest message, so that the truncated bytes are invalid too.
  constexpr std::size_t kMaxKeptBytes = kStreamMessageBytes + 1;
  const bool too_long = arrived.bytes().size() > kMaxApiAnswerBytes;
  auto stored =
      too_long
          ? StoredMessage{sequence, {arrived.bytes().begin(), arrived.bytes().begin() + kMaxKeptBytes}, 0}
          : parse_stored_message(arrived.text());
  {
    const std::lock_guard lock{mutex_};
    const auto now = Clock::now();
    if (too_long || is_of_messages(stored)) unanswered_since_.reset();
    if (!stored || stored->sequence != sequence) {
      reassembler_.not_found(sequence, now);
      question_due_ = std::min(question_due_, asked_at_ + kBetweenUrgent);
    } else {
      if (stored->bytes.size() > kMaxKeptBytes) stored->bytes.resize(kMaxKeptBytes);
      reassembler_.answered(sequence, stored->bytes, now, stored->time_ns / kNsInMs);
    }
  }
  changed_.notify_all();
}

void Inbox::message_of_replica(const ReceivedMessage& arrived) {
  const std::uint64_t sequence = number_at_end(arrived.subject());
  const auto time_ns = nanoseconds_of(std::string{arrived.header("Nats-Time-Stamp")});
  const bool is_stored =
      time_ns && arrived.header("Nats-Stream") == names_.stream && arrived.sequence() == sequence;
  {
    const std::lock_guard lock{mutex_};
    if (led_) return;
    // No talusd publishes longer messages, and it could not be confirmed.
    if (is_stored && arrived.bytes().size() <= kStreamMessageBytes) {
      reassembler_.answered_by_replica(sequence, arrived.bytes(), Clock::now(), *time_ns / kNsInMs);
    } else {
      reassembler_.not_found(sequence, Clock::now());
    }
  }
  changed_.notify_all();
}

void Inbox::leader_answers(bool does) {
  {
    const std::lock_guard lock{mutex_};
    if (led_ == does) return;
    led_ = does;
    if (!does) lacks_since_.reset();  // the next answer may come from another leader
    reassembler_.leader_answers(does);
  }
  changed_.notify_all();
}

bool Inbox::awaits_confirmation() const {
  const std::lock_guard lock{mutex_};
  return reassembler_.unconfirmed().has_value();
}

std::optional<StreamFailure> Inbox::unconfirmed(const Connect& connect, std::uint64_t last) {
  std::unique_lock lock{mutex_};
  const auto now = Clock::now();
  (void)ask(connect, lock, now);
  find_forged();
  if (fault_) return fault_;
  const auto sequence = reassembler_.unconfirmed();
  if (!sequence || *sequence <= last) lacks_since_.reset();
  if (!sequence) return std::nullopt;
  if (*sequence <= last) {
    return StreamFailure{
        Kind::unavailable,
        fmt::format("messages up to {} are replicas', and the log's leader has not confirmed all",
                    *sequence)};
  }
  // Here the stream has lost its end; the applier detects that in time.
  if (!reassembler_.is_unconfirmed_after(last)) return std::nullopt;
  if (!lacks_since_) lacks_since_ = now;
  if (now - *lacks_since_ < kSureOfLess) {
    return StreamFailure{Kind::unavailable,
                         fmt::format("a replica has message {}, and the log's leader not yet", *sequence)};
  }
  fault_ =
      StreamFailure{Kind::false_message,
                    fmt::format("a replica had message {} of {}, which was applied, and the leader lacks it",
                                *sequence, names_.stream)};
  return fault_;
}

void Inbox::find_forged() {
  const auto sequence = reassembler_.forged();
  if (!sequence || fault_) return;
  fault_ = StreamFailure{
      Kind::false_message,
      fmt::format(
          "message {} of {} that was applied is not the stream's: another program publishes to {}; forbid it "
          "in NATS' permissions; or a replica has other messages, which \"talusd cluster check\" finds",
          *sequence, names_.stream, names_.tail)};
}

void Inbox::asks() {
  const std::lock_guard lock{mutex_};
  if (!unanswered_since_) unanswered_since_ = Clock::now();
}

void Inbox::answers() {
  const std::lock_guard lock{mutex_};
  unanswered_since_.reset();
}

bool Inbox::is_unanswered() const {
  const std::lock_guard lock{mutex_};
  return unanswered_since_ && Clock::now() - *unanswered_since_ >= kAnswerPatience;
}

void Inbox::info(std::uint64_t after, std::string_view text) {
  const auto parsed = parse_stream_info(text);
  {
    const std::lock_guard lock{mutex_};
    if (parsed) {
      (void)judge(parsed->state, after);
    } else {
      trouble_ = failure_of(parsed.error(), names_.stream);
    }
  }
  changed_.notify_all();
}

tl::expected<void, StreamFailure> Inbox::told(std::uint64_t after, const StreamState& state) {
  const std::lock_guard lock{mutex_};
  if (fault_) return tl::unexpected{*fault_};
  return judge(state, after);
}

std::optional<StreamFailure> Inbox::fault() const {
  const std::lock_guard lock{mutex_};
  return fault_;
}

tl::expected<std::optional<StreamMessage>, StreamFailure> Inbox::next(const Connect& connect,
                                                                      std::uint64_t after, TimePoint until) {
  std::unique_lock lock{mutex_};
  reassembler_.move_to(after, Clock::now());
  for (;;) {
    if (waits_for_answers()) read_tail(lock);
    if (stopped_) return stream_failure(Kind::unavailable, "stopped");
    find_forged();
    if (fault_) return tl::unexpected{*fault_};
    if (auto message = reassembler_.take()) return message;
    if (const auto gone = check_kept()) return tl::unexpected{*gone};
    const auto now = Clock::now();
    if (trouble_ && trouble_->kind == Kind::refused) return tl::unexpected{*std::exchange(trouble_, {})};
    if (std::exchange(woken_, false)) return std::optional<StreamMessage>{};
    if (now >= until) {
      if (connected_) return std::optional<StreamMessage>{};
      return stream_failure(Kind::unavailable, kNoConnection);
    }
    if (closed_) {
      lock.unlock();
      const auto again = connect();
      lock.lock();
      if (!again) {
        if (!stopped_) changed_.wait_until(lock, std::min(until, now + kAnswerPatience));
        if (Clock::now() >= until) return tl::unexpected{again.error()};
      }
      continue;
    }
    if (connected_ && ask(connect, lock, now)) continue;  // something may have arrived meanwhile
    TimePoint wake = until;
    if (connected_) wake = std::min({wake, question_due_, reassembler_.next_poll()});
    wait(lock, wake);
  }
}

void Inbox::ask_again() {
  const std::lock_guard lock{mutex_};
  reassembler_.ask_again(Clock::now());
}

StreamFailure Inbox::failed_for_good(std::string reason) {
  StreamFailure failure{Kind::other, std::move(reason)};
  {
    const std::lock_guard lock{mutex_};
    if (!fault_) fault_ = failure;
    failure = *fault_;
  }
  changed_.notify_all();
  return failure;
}

void Inbox::learned(std::uint64_t sequence) {
  {
    const std::lock_guard lock{mutex_};
    if (!reassembler_.learned(sequence, Clock::now())) return;
  }
  changed_.notify_all();
}

std::optional<std::uint64_t> Inbox::missing() const {
  const std::lock_guard lock{mutex_};
  return reassembler_.missing();
}

std::uint64_t Inbox::pass_over(std::uint64_t first, std::uint64_t count) {
  count = std::min(count, MessageReassembler::kWindow);
  {
    const std::lock_guard lock{mutex_};
    for (std::uint64_t i = 0; i < count; ++i) reassembler_.answered(first + i, {}, Clock::now());
  }
  changed_.notify_all();
  return count;
}

void Inbox::lost(std::string reason) {
  {
    const std::lock_guard lock{mutex_};
    trouble_ = StreamFailure{Kind::refused, std::move(reason)};
  }
  changed_.notify_all();
}

std::uint64_t Inbox::after() const {
  const std::lock_guard lock{mutex_};
  return reassembler_.after();
}

LeaderScout::Requirement Inbox::wanted_stream() const {
  const std::lock_guard lock{mutex_};
  return {created_ns_, reassembler_.unconfirmed() ? 0 : reassembler_.after()};
}

bool Inbox::asks_replicas(TimePoint now) const {
  const bool denied = replicas_denied_at_ && now - *replicas_denied_at_ < kDenied;
  return !led_ && !denied && created_ns_ != 0;
}

std::optional<StreamFailure> Inbox::why_closed() const {
  const std::lock_guard lock{mutex_};
  return closed_;
}

void Inbox::reopened() {
  const std::lock_guard lock{mutex_};
  closed_.reset();
}

void Inbox::wake() {
  {
    const std::lock_guard lock{mutex_};
    woken_ = true;
  }
  changed_.notify_all();
}

void Inbox::stop() {
  {
    const std::lock_guard lock{mutex_};
    stopped_ = true;
  }
  changed_.notify_all();
}

bool Inbox::stopped() const {
  const std::lock_guard lock{mutex_};
  return stopped_;
}

StreamFigures Inbox::figures() const {
  const std::lock_guard lock{mutex_};
  return {connected_, reassembler_.gaps(), false_messages_ + reassembler_.false_messages(),
          refused_tail_.why()};
}

void Inbox::count_false() {
  const std::lock_guard lock{mutex_};
  ++false_messages_;
}

tl::expected<void, StreamFailure> Inbox::judge(const StreamState& state, std::uint64_t after) {
  if (created_ns_ == 0) created_ns_ = state.created_ns;
  if (state.created_ns != created_ns_) {
    fault_ = StreamFailure{Kind::other, fmt::format("{} was deleted and made anew", names_.stream)};
    return tl::unexpected{*fault_};
  }
  first_ = state.first;
  reassembler_.starts_at(state.first);
  // A deposed leader, or the stream lost its end; the applier detects that in time.
  if (state.last < after) return {};
  (void)reassembler_.learned(state.last, Clock::now());
  if (after > 0) reassembler_.ends_at(state.last);
  return {};
}

std::optional<StreamFailure> Inbox::check_kept() const {
  if (first_ <= reassembler_.after() + 1) return std::nullopt;
  return StreamFailure{Kind::gone, fmt::format("{} keeps messages from {} on, and message {} is needed",
                                               names_.stream, first_, reassembler_.after() + 1)};
}

void Inbox::read_tail(std::unique_lock<std::mutex>& lock) {
  const auto source = tail_;
  if (source == nullptr) return;
  lock.unlock();
  while (source->take(0ms, [this](const ReceivedMessage& arrived) { tail(arrived); }) ==
         Connection::Source::TakeResult::message) {
  }
  lock.lock();
}

void Inbox::wait(std::unique_lock<std::mutex>& lock, TimePoint until) {
  const auto source = tail_;
  if (source != nullptr && connected_) {
    until = std::min(until, Clock::now() + kPollInterval);
    if (!waits_for_answers()) {
      lock.unlock();
      const auto patience = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
      const auto taken =
          source->take(std::max(patience, 0ms), [this](const ReceivedMessage& arrived) { tail(arrived); });
      lock.lock();
      if (taken != Connection::Source::TakeResult::closed) return;
    }
  }
  changed_.wait_until(lock, until);
}

bool Inbox::ask(const Connect& connect, std::unique_lock<std::mutex>& lock, TimePoint now) {
  const std::vector<std::uint64_t> messages = reassembler_.wanted(now);
  if (reassembler_.claims_more()) question_due_ = std::min(question_due_, asked_at_ + kBetweenUrgent);
  const bool question = now >= question_due_;
  if (question) {
    asked_at_ = now;
    question_due_ = now + kBetweenQuestions;
  }
  const bool of_replicas = asks_replicas(now);
  if (!messages.empty() && !of_replicas && !unanswered_since_) unanswered_since_ = now;
  if (messages.empty() && !question) return false;
  const std::uint64_t after = reassembler_.after();
  lock.unlock();
  if (const auto connection = connect()) {
    if (question) (void)(*connection)->send(names_.info(), fmt::format("{}.i.{}", reply_, after), "");
    const std::string subject = of_replicas ? names_.direct_get() : names_.message_get();
    for (const std::uint64_t sequence : messages) {
      (void)(*connection)
          ->send(subject, fmt::format("{}.{}.{}", reply_, of_replicas ? 'r' : 'm', sequence),
                 StreamNames::by_number(sequence));
    }
  }
  lock.lock();
  return true;
}

}  // namespace talus::server::jetstream
