#include "cluster/jetstream/jetstream_log.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cluster/jetstream/inbox.h"
#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_settings.h"
#include "runtime/log/escape.h"

namespace talus::server::jetstream {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Kind = StreamFailure::Kind;

constexpr auto kBetweenConnections = 1s;  // after NATS rejected the credentials
// A connected server on which no leader answers may be cut off from the majority, or have come back without
// knowing it yet (nats-server 2.9: for some 10 s); or the connection has lost the subscription for answers.
constexpr auto kNoLeader = 1s;
constexpr auto kSureOfGap = 3s;    // a message that exists arrives before
constexpr auto kScouting = 500ms;  // maximum wait for a probe

}  // namespace

JetStreamLog::JetStreamLog(Settings settings, std::shared_ptr<const Credentials> credentials, Logger log)
    : settings_{std::move(settings)},
      credentials_{std::move(credentials)},
      log_{std::move(log)},
      inbox_{std::make_shared<Inbox>(settings_.names, log_)},
      scout_{settings_.urls, credentials_, settings_.names} {}

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
  auto connection = Connection::open(settings_.urls, credentials_, inbox_, Retry::forever, first_);
  if (!connection) return connection;
  if (auto listens = inbox_->listen(**connection); !listens) return tl::unexpected{listens.error()};
  return connection;
}

tl::expected<std::shared_ptr<Connection>, StreamFailure> JetStreamLog::connection() {
  if (inbox_->stopped()) return stream_failure(Kind::unavailable, "stopped");
  const std::lock_guard lock{connection_mutex_};
  const auto closed = inbox_->why_closed();
  if (!closed) {
    if (inbox_->renew(*connection_)) {
      inbox_->leaves("answers may be subscribed to again; connects anew");
      connection_->close();
    }
    return connection_;
  }
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

StreamFailure JetStreamLog::explained(StreamFailure failure) const {
  if (failure.kind != Kind::unavailable) return failure;
  if (const std::string why = inbox_->without_answers(); !why.empty()) {
    failure.reason = fmt::format("{}: no answer reaches this server", why);
  }
  return failure;
}

tl::expected<std::uint64_t, StreamFailure> JetStreamLog::publish(std::span<const std::byte> message) {
  if (auto fault = inbox_->fault()) return tl::unexpected{*std::move(fault)};
  if (message.size() > kStreamMessageBytes) {
    return stream_failure(Kind::too_large,
                          fmt::format("a message of {} bytes is over the {} that the stream takes",
                                      message.size(), kStreamMessageBytes));
  }
  if (inbox_->awaits_confirmation()) {
    return stream_failure(Kind::unavailable,
                          "NATS: the log's leader has not confirmed the replicas' messages");
  }
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  const std::uint64_t read_before = inbox_->after();
  const auto ack = (*connection)->publish(settings_.names.log, message, kAnswerPatience);
  if (!ack) return tl::unexpected{explained(ack.error())};
  if (ack->stream != settings_.names.stream) {
    return stream_failure(Kind::refused,
                          fmt::format("{} is a subject of the stream {}, not of {}; delete that stream",
                                      settings_.names.log, escaped(ack->stream), settings_.names.stream));
  }
  if (ack->sequence <= read_before) {
    return tl::unexpected{
        inbox_->failed_for_good(fmt::format("{} gave a message the number {}, which was read before: it was "
                                            "made anew, has lost its end, or another program publishes to {}",
                                            settings_.names.stream, ack->sequence, settings_.names.tail))};
  }
  inbox_->learned(ack->sequence);
  return ack->sequence;
}

tl::expected<std::optional<StreamMessage>, StreamFailure> JetStreamLog::next(std::uint64_t after,
                                                                             TimePoint until) {
  return inbox_->next([this] { return connection(); }, after, until);
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
  if (!stream && stream.error().kind == Kind::unavailable) {
    find_leader();
    return stream;
  }
  {
    const std::lock_guard lock{connection_mutex_};
    silent_since_.reset();
  }
  if (!stream) return stream;
  if (const std::unique_lock scouting{scouting_, std::try_to_lock}; scouting) scout_.rest();
  inbox_->leader_answers(true);
  if (auto why = inbox_->unconfirmed([this] { return connection(); }, stream->last)) {
    return tl::unexpected{*std::move(why)};
  }
  look_for_gap(*stream);
  return stream;
}

void JetStreamLog::tell_settings(std::string other) {
  {
    const std::lock_guard lock{telling_};
    if (other == other_settings_) return;
    other_settings_ = other;
  }
  if (other.empty()) {
    log_->info("cluster: the settings of {} are as they should be again", settings_.names.stream);
  } else {
    log_->error("cluster: {}; this server goes on, and does not start again until then", other);
  }
}

void JetStreamLog::look_for_gap(const StreamState& stream) {
  const std::unique_lock looking{looking_, std::try_to_lock};
  if (!looking) return;
  const auto missing = inbox_->missing();
  if (!missing || *missing < stream.first || *missing > stream.last) return;
  if (missing_.sequence != *missing) missing_ = {*missing, Clock::now()};
  if (Clock::now() - missing_.since < kSureOfGap) return;
  const auto message = ask_for(*missing);
  const auto connection = this->connection();
  if (!message || *message || !connection) return;
  const auto unused = ask_unused(**connection, settings_.names, *missing);
  if (!unused) return inbox_->lost(unused.error().reason);
  if (*unused == 0) {
    std::string reason = fmt::format(
        "message {} of {} is lost: NATS' leader of the stream has messages up to {} and not that one, as if "
        "its "
        "disk were damaged; restart that nats-server, so that another replica leads",
        *missing, settings_.names.stream, stream.last);
    if (!std::exchange(missing_.is_told, true)) log_->error("cluster: {}", reason);
    return inbox_->lost(std::move(reason));
  }
  const std::uint64_t passed = inbox_->pass_over(*missing, *unused);
  log_->warn("cluster: NATS gave the numbers {} to {} of {} to no message; they are passed over", *missing,
             *missing + passed - 1, settings_.names.stream);
  missing_.sequence = *missing + passed;  // more may follow
}

void JetStreamLog::find_leader() {
  std::shared_ptr<Connection> silent;
  {
    const std::lock_guard lock{connection_mutex_};
    // libnats itself tries all servers while disconnected.
    if (!connection_ || !connection_->connected()) {
      silent_since_.reset();
      return;
    }
    const auto now = Clock::now();
    if (!silent_since_) silent_since_ = now;
    if (now - *silent_since_ < kNoLeader) return;
    silent = connection_;
  }
  inbox_->leader_answers(false);
  const std::unique_lock scouting{scouting_, std::try_to_lock};
  if (!scouting) return;
  const auto found = scout_.probe(kScouting, inbox_->wanted_stream());
  // It may answer on this connection again.
  if (!found || ask_leader()) return;
  const std::lock_guard lock{connection_mutex_};
  if (inbox_->stopped() || connection_ != silent) return;
  silent_since_.reset();
  first_ = *found;
  inbox_->leaves(fmt::format("no leader of the log answers by this connection; trying {}", found->text()));
  connection_->close();  // connection() creates another
}

tl::expected<StreamState, StreamFailure> JetStreamLog::ask_leader() {
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  // At every answer, because it may change with the connection and while connected.
  if (const std::int64_t bytes = (*connection)->max_payload(); bytes > 0) {  // 0: not known yet
    if (auto small = small_payload(bytes)) return stream_failure(Kind::refused, *std::move(small));
  }
  const std::uint64_t read_before = inbox_->after();
  const auto info = ask_info(**connection, settings_.names);
  if (!info) return tl::unexpected{explained(info.error())};
  if (settings_.replicas != 0) {
    auto other = other_settings(info->settings, settings_.names, settings_.replicas);
    if (other && !has_settings_) return stream_failure(Kind::refused, *std::move(other));
    has_settings_ = true;
    tell_settings(std::move(other).value_or(""));
  }
  if (!has_majority(*info)) {
    return stream_failure(Kind::unavailable,
                          fmt::format("NATS: the leader of {} does not reach a majority of its servers",
                                      settings_.names.stream));
  }
  if (const auto same = inbox_->told(read_before, info->state); !same) return tl::unexpected{same.error()};
  return info->state;
}

tl::expected<std::optional<StoredMessage>, StreamFailure> JetStreamLog::ask_for(std::uint64_t sequence) {
  const auto connection = this->connection();
  if (!connection) return tl::unexpected{connection.error()};
  inbox_->asks();
  auto message = ask_message(**connection, settings_.names, sequence);
  if (!message) return tl::unexpected{explained(message.error())};
  inbox_->answers();
  return message;
}

tl::expected<std::int64_t, StreamFailure> JetStreamLog::time_of(std::uint64_t sequence) {
  const auto message = ask_for(sequence);
  if (!message) return tl::unexpected{message.error()};
  if (*message) return (*message)->time_ns / 1'000'000;
  // Either a deposed leader answered, or the message is gone everywhere.
  const auto state = this->state();
  if (!state) return tl::unexpected{state.error()};
  if (state->first <= sequence) {
    return stream_failure(Kind::unavailable, fmt::format("NATS: message {} does not arrive", sequence));
  }
  return stream_failure(Kind::gone,
                        fmt::format("{} keeps messages from {} on, and the time of message {} is needed",
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
