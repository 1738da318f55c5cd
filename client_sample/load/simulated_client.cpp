#include "simulated_client.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <talus/protocol/limits.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "tally.h"
#include "worker.h"

namespace talus::load {
namespace {

using std::chrono::milliseconds;

constexpr std::chrono::seconds kConnectTimeout{10};  // to connect, and again until Welcome
constexpr std::chrono::seconds kPingInterval{20};
constexpr milliseconds kBetweenReads{50};  // for a slow reader

protocol::Frame hello_frame(const std::string& token) {
  return protocol::make_frame([&](auto& b) {
    const auto codec_list = b.CreateVector(std::vector{kCodecVersion});
    const auto token_text = b.CreateString(token);
    const auto name = b.CreateString("talus-load " TALUS_VERSION);
    return wire::CreateHello(b, protocol::kOldestProtocol, protocol::kProtocolVersion, codec_list, token_text,
                             name, 0);
  });
}

Clock::duration seconds(double count) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(count));
}

}  // namespace

SimulatedClient::SimulatedClient(Worker& worker, const ClientProfile& profile)
    : worker_{worker},
      profile_{profile},
      random_{worker.plan().options.seed, profile.number},
      link_{worker.io(), worker.scratch(), *this},
      server_{worker.plan().options.groups_together
                  ? profile.group
                  : Random{worker.plan().options.seed ^ 0x5E4, profile.number}.next()} {}

Tally& SimulatedClient::tally() {
  return worker_.tally(profile_.role);
}

void SimulatedClient::start(Time from) {
  reconnect_at(from + profile_.joins_after);
}

void SimulatedClient::reconnect_at(Time when) {
  state_ = finished_ && !unfinished() ? State::gone : State::away;
  join_due_ = when;
  worker_.reschedule(*this);
}

Time SimulatedClient::due() const {
  switch (state_) {
    case State::away:
      return join_due_;
    case State::connecting:
    case State::greeting:
      return std::min(deadline_, read_due_);
    case State::joined:
      return std::min({ping_due_, cut_due_, read_due_, own_due()});
    default:
      return Time::max();
  }
}

void SimulatedClient::act(Time now) {
  if (read_due_ <= now) {
    read_due_ += kBetweenReads;
    const double bytes = worker_.plan().options.slow_kbit * 1000 / 8 * 0.001 *
                         static_cast<double>(milliseconds{kBetweenReads}.count());
    link_.take(static_cast<std::size_t>(std::max(1.0, std::floor(bytes))));
  }
  if (state_ == State::away && join_due_ <= now) return connect(now);
  if ((state_ == State::connecting || state_ == State::greeting) && deadline_ <= now) {
    const bool connecting = state_ == State::connecting;
    link_.close(true);
    return ended(connecting ? "no connection in time" : "no Welcome in time", false);
  }
  if (state_ != State::joined) return;
  if (cut_due_ <= now) return cut(now);
  if (ping_due_ <= now) {
    send(protocol::make_frame([&](auto& b) { return wire::CreatePing(b, 1); }));
    ping_due_ = now + ping_interval_;
  }
  act_joined(now);
}

void SimulatedClient::connect(Time now) {
  state_ = State::connecting;
  deadline_ = now + kConnectTimeout;
  retry_after_ = {};
  close_reason_.clear();
  window_ = taken_ = credited_ = 0;
  const bool slow = profile_.role == Role::slow;
  read_due_ = slow ? now + kBetweenReads : Time::max();
  const Plan& plan = worker_.plan();
  link_.open({plan.servers[server()], profile_.from, slow, plan.tls, plan.options.connect.tls,
              plan.options.connect.websocket});
}

void SimulatedClient::opened() {
  state_ = State::greeting;
  deadline_ = Clock::now() + kConnectTimeout;
  send(hello_frame(worker_.plan().options.connect.token));
  worker_.reschedule(*this);
}

void SimulatedClient::received(const wire::Message& message, std::size_t frame_bytes) {
  switch (message.body_type()) {
    case wire::Body::Chunk:
      taken_ += frame_bytes;
      ++tally().chunks;
      tally().chunk_bytes += frame_bytes;
      Live::add(worker_.live().chunks, 1);
      return take(*message.body_as_Chunk());
    case wire::Body::UniformColumn:
      return take(*message.body_as_UniformColumn());
    case wire::Body::Unchanged:
      ++tally().unchanged;
      return take(*message.body_as_Unchanged());
    case wire::Body::Error:
      return note_error(*message.body_as_Error());
    case wire::Body::Welcome:
      return welcome(*message.body_as_Welcome());
    case wire::Body::GoAway: {
      const auto& away = *message.body_as_GoAway();
      close_reason_ = "GoAway";
      if (!lost_) lost_ = Clock::now();  // after this it gets nothing new
      retry_after_ = milliseconds{away.retry_after_ms()};
      return;
    }
    case wire::Body::Attached:
      return take(*message.body_as_Attached());
    case wire::Body::EditResult:
      return take(*message.body_as_EditResult());
    case wire::Body::EditBroadcast:
      return take(*message.body_as_EditBroadcast());
    case wire::Body::ViewComplete:
      return take(*message.body_as_ViewComplete());
    case wire::Body::Pong:
      if (awaits_pong_) is_back(*std::exchange(awaits_pong_, std::nullopt));
      return;
    default:
      wrong(tally().bad_messages, fmt::format("an unexpected {}", wire::EnumNameBody(message.body_type())));
  }
}

void SimulatedClient::welcome(const wire::Welcome& welcome) {
  if (state_ != State::greeting || welcome.limits() == nullptr) {
    return wrong(tally().bad_messages, "a Welcome that should not be, or without limits");
  }
  state_ = State::joined;
  codec_ = welcome.codec();
  frame_bytes_ = welcome.limits()->frame_bytes();
  window_ = welcome.limits()->window_bytes();
  const milliseconds idle{welcome.limits()->idle_timeout_ms()};
  ping_interval_ =
      idle.count() == 0 ? Clock::duration{kPingInterval} : std::min<Clock::duration>(kPingInterval, idle / 3);
  const Time now = Clock::now();
  // Randomly early at first, so that clients that joined together do not ping together.
  ping_due_ = now + seconds(random_.part() * std::chrono::duration<double>(ping_interval_).count());
  const double stay = worker_.plan().options.churn_seconds;
  const bool churns = stay > 0 && is_player(profile_.role) && profile_.role != Role::idle && !finished_;
  cut_due_ = churns ? now + seconds(-stay * std::log(1 - random_.part())) : Time::max();
  ++tally().joins;
  if (lost_) {
    ++tally().reconnects;
    ping_due_ = now;
    awaits_pong_ = std::exchange(lost_, std::nullopt);
  }
  if (backoff_) backoff_->reset();
  Live::add(worker_.live().joined, 1);
  joined(now);
}

void SimulatedClient::note_error(const wire::Error& error) {
  ++tally().errors[wire::EnumNameErrorCode(error.code())];
  if (is_player(profile_.role)) Live::add(worker_.live().troubles, 1);
  if (error.request_id() == 0) close_reason_ = std::string{"Error "} + wire::EnumNameErrorCode(error.code());
  if (error.request_id() == 0) retry_after_ = milliseconds{error.retry_after_ms()};
  take(error);
}

void SimulatedClient::is_back(Time lost) {
  tally().back.record(Clock::now() - lost);
}

void SimulatedClient::read_done() {
  Live::add(worker_.live().bytes, link_.received_bytes() - counted_bytes_);
  counted_bytes_ = link_.received_bytes();
  if (state_ == State::joined) taken_all();
  if (state_ == State::joined && taken_ - credited_ >= std::max<std::uint64_t>(1, window_ / 2)) {
    credited_ = taken_;
    send(protocol::make_frame([&](auto& b) { return wire::CreateCredit(b, taken_); }));
  }
  worker_.reschedule(*this);
}

void SimulatedClient::ended(const std::string& reason, bool broken) {
  const bool was_joined = state_ == State::joined;
  if (was_joined) Live::add(worker_.live().joined, std::uint64_t{0} - 1);
  if (broken) wrong(tally().bad_messages, reason);
  const std::string words = close_reason_.empty() ? reason : fmt::format("{} ({})", close_reason_, reason);
  ++tally().disconnects[was_joined ? words : "before Welcome: " + words];
  if (is_player(profile_.role)) Live::add(worker_.live().troubles, 1);
  read_due_ = Time::max();
  if (was_joined) {
    if (!lost_) lost_ = Clock::now();
    disconnected(true);
  }
  awaits_pong_.reset();
  // A wait requested by a server applies to this server, not to the next one.
  ++server_;
  if (worker_.plan().servers.size() > 1) retry_after_ = {};
  reconnect_at(Clock::now() + back_off());
}

std::size_t SimulatedClient::server() const {
  return server_ % worker_.plan().servers.size();
}

// As in the client library, but without a limit of attempts.
Clock::duration SimulatedClient::back_off() {
  if (!backoff_) {
    client::ReconnectPolicy policy;
    policy.max_attempts = std::numeric_limits<int>::max();
    policy.seed = Random{worker_.plan().options.seed ^ 0xBACC, profile_.number}.next();
    backoff_.emplace(policy);
  }
  return *backoff_->next(retry_after_);
}

void SimulatedClient::cut(Time now) {
  ++tally().cuts;
  Live::add(worker_.live().joined, std::uint64_t{0} - 1);
  link_.close(random_.part() < 0.5);
  disconnected(false);
  reconnect_at(now + seconds(random_.part()));
}

void SimulatedClient::finish() {
  finished_ = true;
  cut_due_ = Time::max();
  if (state_ == State::away && !unfinished()) state_ = State::gone;
  worker_.reschedule(*this);
}

void SimulatedClient::leave() {
  if (state_ == State::joined || unfinished()) give_up();
  state_ = State::gone;
  link_.close(false);
}

bool SimulatedClient::verify(const wire::Chunk& chunk) {
  if (chunk.codec() != codec_ || chunk.hash() == nullptr || chunk.payload() == nullptr) {
    wrong(tally().bad_chunks, "a chunk of another codec, or without hash or payload");
    return false;
  }
  if (!worker_.picks_to_verify()) return true;
  ++tally().verified;
  const auto key = [&] {
    return fmt::format("({}, {}, {})", chunk.key()->x(), chunk.key()->y(), chunk.key()->z());
  };
  const auto decoded = decode(std::as_bytes(std::span{chunk.payload()->data(), chunk.payload()->size()}));
  if (!decoded) {
    wrong(tally().bad_chunks,
          fmt::format("chunk {} cannot be decoded: {}", key(), describe(decoded.error())));
    return false;
  }
  if (content_hash(*decoded) == ContentHash{chunk.hash()->low(), chunk.hash()->high()}) return true;
  wrong(tally().bad_chunks, fmt::format("chunk {} is not what its hash says", key()));
  return false;
}

void SimulatedClient::wrong(std::uint64_t& counter, const std::string& what) {
  Live::add(worker_.live().troubles, 1);
  tally().wrong(counter, fmt::format("{} {}: {}", name_of(profile_.role), profile_.number, what));
}

void SimulatedClient::never_came(const std::string& what) {
  Live::add(worker_.live().troubles, 1);
  tally().never_came(fmt::format("{} {}: {}", name_of(profile_.role), profile_.number, what));
}

void SimulatedClient::take(const wire::Chunk&) {
  wrong(tally().outside, "a chunk that was not requested");
}

void SimulatedClient::take(const wire::UniformColumn&) {
  wrong(tally().outside, "a UniformColumn without a View");
}

void SimulatedClient::take(const wire::Attached&) {
  wrong(tally().outside, "an Attached for a client that does not edit");
}

void SimulatedClient::take(const wire::EditResult&) {
  wrong(tally().outside, "an EditResult for a client that does not edit");
}

void SimulatedClient::take(const wire::Unchanged&) {
  wrong(tally().outside, "an Unchanged that was not requested");
}

}  // namespace talus::load
