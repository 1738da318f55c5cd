#include "jetstream/jetstream_log.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "jetstream/reading.h"
#include "jetstream/stored_message.h"
#include "jetstream/stream_info.h"
#include "jetstream/stream_settings.h"
#include "log/escape.h"
#include "random/random_number.h"

namespace talus::server::jetstream {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using TimePoint = LogStream::TimePoint;
using Kind = StreamFailure::Kind;

constexpr auto kPatience = 500ms;
constexpr auto kBetweenQuestions = 1s;    // to the leader
constexpr auto kBetweenUrgent = 100ms;    // where something does not fit
constexpr auto kBetweenDenials = 60s;     // of one kind, in the log
constexpr auto kBetweenConnections = 1s;  // after NATS refused the credentials
// A server that is connected, and by which no leader answers, may be cut off from those that have one. An
// election takes less.
constexpr auto kNoLeader = 10s;
constexpr auto kLongestNoLeader = 80s;
/// Who waits for one of the tail and of the other threads sees so late what comes by the others.
constexpr auto kBetweenLooks = 20ms;
constexpr int kPendingMessages = 4096;
constexpr int kPendingBytes = 32 << 20;
/// Answers have messages as base64 in JSON.
constexpr int kPendingAnswerBytes =
    static_cast<int>(Reading::kMostRequests * (kStreamMessageBytes / 3 * 4 + 4096));

std::string new_reply_subject() {
  natsInbox* made = nullptr;
  if (natsInbox_Create(&made) != NATS_OK) return {};
  const NatsInbox inbox{made};
  return inbox.get();
}

tl::unexpected<StreamFailure> failure(Kind kind, std::string reason) {
  return tl::unexpected{StreamFailure{kind, std::move(reason)}};
}

/// Whether it is what a leader says of a message, though it may have none of the number.
bool is_of_messages(const tl::expected<StoredMessage, ApiError>& answer) {
  return answer || answer.error().code == kMessageNotFound;
}

/// The number at the end of a subject; 0 where there is none.
std::uint64_t number_at_end(std::string_view subject) {
  const std::size_t dot = subject.rfind('.');
  const std::string_view digits = subject.substr(dot == std::string_view::npos ? subject.size() : dot + 1);
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

/// Everything that libnats' threads, the reader and the others share.
class JetStreamLog::Inbox final : public ConnectionEvents {
 public:
  Inbox(const Settings& settings, Logger log)
      : names_{settings.names}, log_{std::move(log)}, reading_{Clock::now(), random_number()} {}

  // Of the connection.
  void connected(bool now) override {
    {
      const std::lock_guard lock{mutex_};
      if (connected_ == now) return;
      connected_ = now;
      question_due_ = Clock::now();  // unanswered_since_ stays: another server may forbid it as well
    }
    changed_.notify_all();
    if (now) {
      log_->info("NATS: connected");
    } else {
      log_->warn("NATS: the connection broke; trying all servers of cluster.nats");
    }
  }
  void closed(const StreamFailure& why) override {
    bool wanted = false;
    {
      const std::lock_guard lock{mutex_};
      if (stopped_) return;
      closed_ = why;
      wanted = std::exchange(leaves_, false);
    }
    changed_.notify_all();
    if (!wanted) log_->error("{}; trying again", why.reason);
  }
  /// The connection is closed next, to make it anew.
  void leaves() {
    {
      const std::lock_guard lock{mutex_};
      leaves_ = true;
    }
    log_->warn("NATS: no leader of the log answers by this server; trying any of cluster.nats");
  }
  void denied(std::string_view what) override {
    bool is_news = false;
    {
      const std::lock_guard lock{mutex_};
      trouble_ = StreamFailure{Kind::refused, fmt::format("NATS: {}", what)};
      const auto now = Clock::now();
      is_news = denial_told_ != trouble_->reason || now > denial_told_at_ + kBetweenDenials;
      if (is_news) {
        denial_told_ = trouble_->reason;
        denial_told_at_ = now;
      }
    }
    changed_.notify_all();
    // Questions for messages are asked again many times a second.
    if (is_news)
      log_->error("NATS: {}; see \"Many machines\" in OPERATIONS.md for what talusd must be allowed", what);
  }

  void tail(const Arrived& arrived) {
    if (arrived.bytes().empty()) return;  // of "talusd cluster check"
    if (arrived.header("Nats-Stream") != names_.stream) return count_false();
    if (arrived.bytes().size() > kStreamMessageBytes) return count_false();
    {
      const std::lock_guard lock{mutex_};
      reading_.heard(arrived.sequence(), arrived.bytes(), Clock::now());
    }
  }
  /// Of a connection that was made: where the reader finds the tail. Null: it was refused.
  void hears(std::shared_ptr<Connection::Source> tail) {
    const std::lock_guard lock{mutex_};
    tail_ = std::move(tail);
  }

  /// The leader's answer to a question for one.
  void message(const Arrived& arrived) {
    const std::uint64_t sequence = number_at_end(arrived.subject());
    // More than a message has nobody need keep: cut it is no message either.
    constexpr std::size_t kMost = kStreamMessageBytes + 1;
    const bool too_long = arrived.bytes().size() > kMostAnswerBytes;
    auto stored = too_long
                      ? StoredMessage{sequence, {arrived.bytes().begin(), arrived.bytes().begin() + kMost}, 0}
                      : parse_stored_message(arrived.text());
    {
      const std::lock_guard lock{mutex_};
      const auto now = Clock::now();
      if (too_long || is_of_messages(stored)) unanswered_since_.reset();
      if (!stored || stored->sequence != sequence) {
        reading_.not_found(sequence, now);
        question_due_ = std::min(question_due_, asked_at_ + kBetweenUrgent);
      } else {
        if (stored->bytes.size() > kMost) stored->bytes.resize(kMost);
        reading_.answered(sequence, stored->bytes, now);
      }
    }
    changed_.notify_all();
  }

  /// A message was asked for, or one is about to be. Any thread.
  void asks() {
    const std::lock_guard lock{mutex_};
    if (!unanswered_since_) unanswered_since_ = Clock::now();
  }
  /// The leader gave a message, or said that it has none of the number. Any thread.
  void answers() {
    const std::lock_guard lock{mutex_};
    unanswered_since_.reset();
  }
  /// Whether a message was asked for, and nothing was said of any since then for as long as answers take.
  [[nodiscard]] bool is_unanswered() const {
    const std::lock_guard lock{mutex_};
    return unanswered_since_ && Clock::now() - *unanswered_since_ >= kPatience;
  }

  /// What the leader says; `after`: how far the stream had been read when it was asked.
  void info(std::uint64_t after, std::string_view text) {
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

  /// Of another question to the leader.
  tl::expected<void, StreamFailure> told(std::uint64_t after, const StreamState& state) {
    const std::lock_guard lock{mutex_};
    if (fault_) return tl::unexpected{*fault_};
    return judge(state, after);
  }
  /// Why nothing may be read or published any more.
  [[nodiscard]] std::optional<StreamFailure> fault() const {
    const std::lock_guard lock{mutex_};
    return fault_;
  }

  // Of the reader.
  tl::expected<std::optional<StreamMessage>, StreamFailure> next(JetStreamLog& log, std::uint64_t after,
                                                                 TimePoint until) {
    std::unique_lock lock{mutex_};
    reading_.move_to(after, Clock::now());
    for (;;) {
      if (waits_for_answers()) read_tail(lock);
      if (stopped_) return failure(Kind::unavailable, "stopped");
      if (const auto sequence = reading_.forged()) {
        fault_ =
            StreamFailure{Kind::false_message,
                          fmt::format("message {} of {} that was applied is not the stream's: somebody else "
                                      "publishes to {}; forbid it in NATS' permissions",
                                      *sequence, names_.stream, names_.tail)};
      }
      if (fault_) return tl::unexpected{*fault_};
      if (auto message = reading_.take()) return message;
      if (const auto gone = check_kept()) return tl::unexpected{*gone};
      const auto now = Clock::now();
      if (trouble_ && trouble_->kind == Kind::refused) return tl::unexpected{*std::exchange(trouble_, {})};
      if (std::exchange(woken_, false)) return std::optional<StreamMessage>{};
      if (now >= until) {
        if (connected_) return std::optional<StreamMessage>{};
        return failure(Kind::unavailable, "no connection to NATS");
      }
      if (closed_) {
        lock.unlock();
        const auto again = log.connection();
        lock.lock();
        if (!again) {
          if (!stopped_) changed_.wait_until(lock, std::min(until, now + kPatience));
          if (Clock::now() >= until) return tl::unexpected{again.error()};
        }
        continue;
      }
      if (connected_ && ask(log, lock, now)) continue;  // something may have come meanwhile
      TimePoint wake = until;
      if (connected_) wake = std::min({wake, question_due_, reading_.next_look()});
      wait(lock, wake);
    }
  }

  /// It is not the stream that was read.
  StreamFailure failed_for_good(std::string reason) {
    StreamFailure failure{Kind::other, std::move(reason)};
    {
      const std::lock_guard lock{mutex_};
      if (!fault_) fault_ = failure;
      failure = *fault_;
    }
    changed_.notify_all();
    return failure;
  }
  void learned(std::uint64_t sequence) {
    {
      const std::lock_guard lock{mutex_};
      if (!reading_.learned(sequence, Clock::now())) return;
    }
    changed_.notify_all();
  }
  [[nodiscard]] std::uint64_t after() const {
    const std::lock_guard lock{mutex_};
    return reading_.after();
  }

  [[nodiscard]] std::optional<StreamFailure> why_closed() const {
    const std::lock_guard lock{mutex_};
    return closed_;
  }
  void reopened() {
    const std::lock_guard lock{mutex_};
    closed_.reset();
  }
  void wake() {
    {
      const std::lock_guard lock{mutex_};
      woken_ = true;
    }
    changed_.notify_all();
  }
  void stop() {
    {
      const std::lock_guard lock{mutex_};
      stopped_ = true;
    }
    changed_.notify_all();
  }
  [[nodiscard]] bool stopped() const {
    const std::lock_guard lock{mutex_};
    return stopped_;
  }
  [[nodiscard]] StreamFigures figures() const {
    const std::lock_guard lock{mutex_};
    return {connected_, reading_.gaps(), false_messages_ + reading_.false_messages()};
  }

 private:
  void count_false() {
    const std::lock_guard lock{mutex_};
    ++false_messages_;
  }

  tl::expected<void, StreamFailure> judge(const StreamState& state, std::uint64_t after) {
    if (created_ns_ == 0) created_ns_ = state.created_ns;
    if (state.created_ns != created_ns_) {
      fault_ = StreamFailure{Kind::other, fmt::format("{} was deleted and made anew", names_.stream)};
      return tl::unexpected{*fault_};
    }
    first_ = state.first;
    reading_.starts_at(state.first);
    // Who says less was deposed; or the stream has lost its end, which whoever applies it finds out in time.
    if (state.last < after) return {};
    (void)reading_.learned(state.last, Clock::now());
    if (after > 0) reading_.ends_at(state.last);
    return {};
  }

  [[nodiscard]] std::optional<StreamFailure> check_kept() const {
    if (first_ <= reading_.after() + 1) return std::nullopt;
    return StreamFailure{Kind::gone, fmt::format("{} keeps messages from {} on, and message {} is wanted",
                                                 names_.stream, first_, reading_.after() + 1)};
  }

  [[nodiscard]] bool waits_for_answers() const { return created_ns_ == 0 || reading_.asks(); }
  /// Takes what waits there.
  void read_tail(std::unique_lock<std::mutex>& lock) {
    const auto source = tail_;
    if (source == nullptr) return;
    lock.unlock();
    while (source->take(0ms, [this](const Arrived& arrived) { tail(arrived); }) ==
           Connection::Source::Taken::message) {
    }
    lock.lock();
  }
  /// Until something comes, or `until`. The reader takes the tail itself: a thread in between would be one
  /// more to wake for each message. All else comes by other threads: answers, where there are any on their
  /// way, are waited for, and the rest can wait a little.
  void wait(std::unique_lock<std::mutex>& lock, TimePoint until) {
    const auto source = tail_;
    if (source != nullptr && connected_) {
      until = std::min(until, Clock::now() + kBetweenLooks);
      if (!waits_for_answers()) {
        lock.unlock();
        const auto patience = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
        const auto taken =
            source->take(std::max(patience, 0ms), [this](const Arrived& arrived) { tail(arrived); });
        lock.lock();
        if (taken != Connection::Source::Taken::closed) return;
      }
    }
    changed_.wait_until(lock, until);
  }

  /// Sends the questions that are due; whether there were any.
  bool ask(JetStreamLog& log, std::unique_lock<std::mutex>& lock, TimePoint now) {
    const std::vector<std::uint64_t> messages = reading_.wanted(now);
    const bool question = now >= question_due_;
    if (question) {
      asked_at_ = now;
      question_due_ = now + kBetweenQuestions;
    }
    if (!messages.empty() && !unanswered_since_) unanswered_since_ = now;
    if (messages.empty() && !question) return false;
    const std::uint64_t after = reading_.after();
    lock.unlock();
    if (const auto connection = log.connection()) {
      if (question) (void)(*connection)->send(names_.info(), fmt::format("{}.i.{}", log.reply_, after), "");
      for (const std::uint64_t sequence : messages) {
        (void)(*connection)
            ->send(names_.message_get(), fmt::format("{}.m.{}", log.reply_, sequence),
                   StreamNames::by_number(sequence));
      }
    }
    lock.lock();
    return true;
  }

  const StreamNames names_;
  const Logger log_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Reading reading_;
  std::shared_ptr<Connection::Source> tail_;
  bool connected_ = false;
  bool woken_ = false;
  bool stopped_ = false;
  bool leaves_ = false;
  std::optional<StreamFailure> closed_;   // the connection, for good
  std::optional<StreamFailure> trouble_;  // told once
  std::optional<StreamFailure> fault_;    // told from now on
  std::string denial_told_;               // in the log
  TimePoint denial_told_at_{};
  std::int64_t created_ns_ = 0;  // of the stream that was seen first
  std::uint64_t first_ = 0;
  TimePoint question_due_{};
  TimePoint asked_at_{};
  std::optional<TimePoint> unanswered_since_;  // of questions for messages
  std::uint64_t false_messages_ = 0;
};

JetStreamLog::JetStreamLog(Settings settings, std::shared_ptr<const Credentials> credentials, Logger log)
    : settings_{std::move(settings)},
      credentials_{std::move(credentials)},
      log_{std::move(log)},
      reply_{new_reply_subject()},
      inbox_{std::make_shared<Inbox>(settings_, log_)},
      patience_{kNoLeader} {}

JetStreamLog::~JetStreamLog() {
  stop();
}

tl::expected<std::unique_ptr<JetStreamLog>, StreamFailure> JetStreamLog::open(
    Settings settings, std::shared_ptr<const Credentials> credentials, Logger log) {
  std::unique_ptr<JetStreamLog> made{
      new JetStreamLog{std::move(settings), std::move(credentials), std::move(log)}};
  auto connection = made->connect();
  if (!connection) return tl::unexpected{connection.error()};
  made->connection_ = *std::move(connection);
  made->connected_at_ = Clock::now();
  return made;
}

tl::expected<std::shared_ptr<Connection>, StreamFailure> JetStreamLog::connect() {
  auto connection = Connection::open(settings_.urls, credentials_, inbox_, Retry::forever);
  if (!connection) return connection;
  const auto inbox = inbox_;
  auto tail = (*connection)->open_source(settings_.names.tail, kPendingMessages, kPendingBytes);
  if (!tail) return tl::unexpected{tail.error()};
  inbox->hears(*std::move(tail));
  const auto answers = (*connection)
                           ->subscribe(
                               reply_ + ".*.*",
                               [inbox, kind = reply_.size() + 1](const Arrived& arrived) {
                                 if (arrived.subject()[kind] == 'i') {
                                   inbox->info(number_at_end(arrived.subject()), arrived.text());
                                 } else {
                                   inbox->message(arrived);
                                 }
                               },
                               kPendingMessages, kPendingAnswerBytes);
  if (!answers) return tl::unexpected{answers.error()};
  return connection;
}

tl::expected<std::shared_ptr<Connection>, StreamFailure> JetStreamLog::connection() {
  if (inbox_->stopped()) return failure(Kind::unavailable, "stopped");
  const std::lock_guard lock{connection_mutex_};
  const auto closed = inbox_->why_closed();
  if (!closed) return connection_;
  const auto now = Clock::now();
  if (now - connected_at_ < kBetweenConnections) return tl::unexpected{*closed};
  connected_at_ = now;
  inbox_->reopened();
  auto again = connect();
  if (!again) {
    inbox_->closed(again.error());
    return again;
  }
  connection_ = *std::move(again);
  return connection_;
}

tl::expected<std::uint64_t, StreamFailure> JetStreamLog::publish(std::span<const std::byte> message) {
  if (auto fault = inbox_->fault()) return tl::unexpected{*std::move(fault)};
  if (message.size() > kStreamMessageBytes) {
    return failure(Kind::refused, fmt::format("a message of {} bytes is over the {} that the stream takes",
                                              message.size(), kStreamMessageBytes));
  }
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  const std::uint64_t read_before = inbox_->after();
  const auto ack = (*connection)->publish(settings_.names.log, message, kPatience);
  if (!ack) return tl::unexpected{ack.error()};
  if (ack->stream != settings_.names.stream) {
    return failure(Kind::refused,
                   fmt::format("{} is a subject of the stream {}, not of {}; delete that stream",
                               settings_.names.log, escaped(ack->stream), settings_.names.stream));
  }
  if (ack->sequence <= read_before) {
    return tl::unexpected{inbox_->failed_for_good(fmt::format(
        "{} gave a message the number {}, which was read before: it was made anew, has lost its end, or "
        "somebody else publishes to {}",
        settings_.names.stream, ack->sequence, settings_.names.tail))};
  }
  inbox_->learned(ack->sequence);
  return ack->sequence;
}

tl::expected<std::optional<StreamMessage>, StreamFailure> JetStreamLog::next(std::uint64_t after,
                                                                             TimePoint until) {
  return inbox_->next(*this, after, until);
}

tl::expected<StreamState, StreamFailure> JetStreamLog::state() {
  auto stream = ask_leader();
  if (stream && inbox_->is_unanswered()) {
    if (const auto message = ask_for(std::max<std::uint64_t>(stream->last, 1)); !message) {
      stream = tl::unexpected{StreamFailure{
          Kind::unavailable,
          fmt::format("messages of {} cannot be read: {}", settings_.names.stream, message.error().reason)}};
    }
  }
  leader_answers(stream || stream.error().kind != Kind::unavailable);
  return stream;
}

void JetStreamLog::leader_answers(bool does) {
  const std::lock_guard lock{connection_mutex_};
  const auto now = Clock::now();
  if (does) patience_ = kNoLeader;
  // What is not connected is tried at all servers by libnats.
  if (does || settings_.urls.size() < 2 || !connection_ || !connection_->connected()) {
    silent_since_.reset();
    return;
  }
  if (!silent_since_) silent_since_ = now;
  if (now - *silent_since_ < patience_) return;
  silent_since_.reset();
  patience_ = std::min<Clock::duration>(2 * patience_, kLongestNoLeader);
  inbox_->leaves();
  connection_->close();  // connection() makes another
}

tl::expected<StreamState, StreamFailure> JetStreamLog::ask_leader() {
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  const std::uint64_t read_before = inbox_->after();
  const auto reply = (*connection)->request(settings_.names.info(), "", kPatience);
  if (!reply) return tl::unexpected{reply.error()};
  const auto info = parse_stream_info(Arrived{reply->get()}.text());
  if (!info) return tl::unexpected{failure_of(info.error(), settings_.names.stream)};
  if (settings_.replicas != 0 && !has_settings_) {
    if (const auto other = other_settings(info->settings, settings_.names, settings_.replicas)) {
      return failure(Kind::refused, *other);
    }
    has_settings_ = true;
  }
  if (!has_majority(*info)) {
    return tl::unexpected{StreamFailure{
        StreamFailure::Kind::unavailable,
        fmt::format("NATS: the leader of {} hears no majority of its servers", settings_.names.stream)}};
  }
  if (const auto same = inbox_->told(read_before, info->state); !same) return tl::unexpected{same.error()};
  return info->state;
}

tl::expected<std::optional<StoredMessage>, StreamFailure> JetStreamLog::ask_for(std::uint64_t sequence) {
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  inbox_->asks();
  const auto reply =
      (*connection)->request(settings_.names.message_get(), StreamNames::by_number(sequence), kPatience);
  if (!reply) return tl::unexpected{reply.error()};
  auto message = parse_stored_message(Arrived{reply->get()}.text());
  if (!is_of_messages(message)) return tl::unexpected{failure_of(message.error(), settings_.names.stream)};
  inbox_->answers();
  if (!message || message->sequence != sequence) return std::optional<StoredMessage>{};
  return *std::move(message);
}

tl::expected<std::int64_t, StreamFailure> JetStreamLog::time_of(std::uint64_t sequence) {
  const auto message = ask_for(sequence);
  if (!message) return tl::unexpected{message.error()};
  if (*message) return (*message)->time_ns / 1'000'000;
  // An old leader has answered, unless nobody has it any more.
  const auto state = this->state();
  if (!state) return tl::unexpected{state.error()};
  if (state->first <= sequence) {
    return failure(Kind::unavailable, fmt::format("NATS: message {} does not come", sequence));
  }
  return failure(Kind::gone, fmt::format("{} keeps messages from {} on, and the time of message {} is wanted",
                                         settings_.names.stream, state->first, sequence));
}

StreamFigures JetStreamLog::figures() const {
  return inbox_->figures();
}

void JetStreamLog::wake() {
  inbox_->wake();
}

void JetStreamLog::stop() {
  inbox_->stop();
  const std::lock_guard lock{connection_mutex_};
  if (connection_) connection_->close();
}

}  // namespace talus::server::jetstream
