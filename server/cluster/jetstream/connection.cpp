#include "cluster/jetstream/connection.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "cluster/jetstream/json_member.h"
#include "cluster/jetstream/stream_info.h"
#include "runtime/log/escape.h"
#include "runtime/signals.h"

namespace talus::server::jetstream {
namespace {

constexpr std::int64_t kConnectTimeoutMs = 500;
constexpr std::int64_t kWriteTimeoutMs = 500;
constexpr std::int64_t kReconnectWaitMs = 50;
constexpr std::int64_t kReconnectJitterMs = 20;
constexpr std::int64_t kPingIntervalMs = 1000;
constexpr int kMaxPingsOut = 2;

using Clock = std::chrono::steady_clock;

/// libnats' error without its place in the source, "(conn.c:2088): "; empty if there is none.
std::string_view without_place(const char* said) {
  std::string_view text{said == nullptr ? "" : said};
  constexpr std::string_view kAfterPlace{"): "};
  if (const auto end = text.find(kAfterPlace); text.starts_with('(') && end != std::string_view::npos) {
    text.remove_prefix(end + kAfterPlace.size());
  }
  return text;
}

/// Keeps the first error of several calls that set options.
class Setting {
 public:
  void operator()(natsStatus status) {
    if (status_ == NATS_OK && status != NATS_OK) {
      status_ = status;
      const std::string_view said = without_place(nats_GetLastError(nullptr));
      text_ = said.empty() ? natsStatus_GetText(status) : said;
    }
  }
  [[nodiscard]] bool failed() const { return status_ != NATS_OK; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  natsStatus status_ = NATS_OK;
  std::string text_;
};

StreamFailure unavailable(std::string reason) {
  return {StreamFailure::Kind::unavailable, std::move(reason)};
}

bool is_refusal(natsStatus status) {
  return status == NATS_CONNECTION_AUTH_FAILED || status == NATS_NOT_PERMITTED || status == NATS_SSL_ERROR ||
         status == NATS_SECURE_CONNECTION_WANTED;
}

/// Text of NATS or libnats on one line, with readable quotes.
std::string words_of(std::string_view text) {
  std::string plain{text.substr(0, 300)};
  std::ranges::replace(plain, '"', '\'');
  return escaped(plain, 300);
}

/// libnats' last error on this thread, or the meaning of the status.
std::string last_words(natsStatus status) {
  const std::string_view said = without_place(nats_GetLastError(nullptr));
  return words_of(said.empty() ? natsStatus_GetText(status) : said);
}

}  // namespace

std::span<const std::byte> ReceivedMessage::bytes() const {
  return std::as_bytes(
      std::span{natsMsg_GetData(message_), static_cast<std::size_t>(natsMsg_GetDataLength(message_))});
}

std::string_view ReceivedMessage::text() const {
  return {natsMsg_GetData(message_), static_cast<std::size_t>(natsMsg_GetDataLength(message_))};
}

std::string_view ReceivedMessage::header(const char* name) const {
  // NATS' own header follows headers of the same name set by a publisher.
  const char** values = nullptr;
  int count = 0;
  if (natsMsgHeader_Values(message_, name, &values, &count) != NATS_OK || count < 1) return {};
  const std::string_view last = values[count - 1];
  std::free(static_cast<void*>(values));  // frees the array; the message owns the texts
  return last;
}

std::uint64_t ReceivedMessage::sequence() const {
  const std::string_view text = header("Nats-Sequence");
  std::uint64_t sequence = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), sequence);
  return error == std::errc{} && stop == text.data() + text.size() ? sequence : 0;
}

int ReceivedMessage::status() const {
  // A message of a stream is not an answer of NATS, whatever its publisher set.
  if (!header("Nats-Stream").empty()) return 0;
  const std::string_view text = header("Status");
  int status = 0;
  std::from_chars(text.data(), text.data() + text.size(), status);
  return status;
}

/// Callbacks for libnats, a C library: exceptions such as bad_alloc must not leave them.
struct Connection::Callbacks {
  /// A subscription's handler, on its thread.
  struct HandlerData {
    Handler handler;
    DiscardedMessages discarded;
  };

  static Link& link(void* closure) { return **static_cast<std::shared_ptr<Link>*>(closure); }

  /// Returns true if `what` did not throw.
  template <typename Do>
  static bool guard(Do what) noexcept {
    try {
      what();
      return true;
    } catch (...) {
      return false;
    }
  }

  static void set_connected(Link& link, bool now) {
    link.connected.store(now, std::memory_order_relaxed);
    if (now) link.was_connected.store(true, std::memory_order_relaxed);
    if (link.events) link.events->connected(now);
  }
  static void connected(natsConnection* /*connection*/, void* closure) {
    guard([&] { set_connected(link(closure), true); });
  }
  static void disconnected(natsConnection* /*connection*/, void* closure) {
    guard([&] { set_connected(link(closure), false); });
  }
  /// The last callback of a connection.
  static void closed(natsConnection* connection, void* closure) {
    const std::unique_ptr<std::shared_ptr<Link>> owned{static_cast<std::shared_ptr<Link>*>(closure)};
    if (guard([&] { tell_closed(**owned, connection); })) return;
    // Otherwise the connection would never be recreated. The text is short enough to need no memory.
    guard([&] { (*owned)->events->closed(unavailable("NATS: closed")); });
  }
  static void tell_closed(Link& link, natsConnection* connection) {
    const char* text = nullptr;
    const natsStatus status = natsConnection_GetLastError(connection, &text);
    link.connected.store(false, std::memory_order_relaxed);
    if (!link.events) return;
    link.events->connected(false);
    // libnats retries for ever, except with servers that reject it twice, and with a first server that
    // accepts the connection and then stays silent; in that case it has lost the reason.
    const bool forgotten = status == NATS_NO_SERVER;
    const bool was_there = link.was_connected.load(std::memory_order_relaxed);
    if (is_refusal(status) || (forgotten && (was_there || is_refusal(link.at_first)))) {
      link.events->closed({StreamFailure::Kind::refused,
                           "no server of cluster.nats accepts this one: the credentials are wrong "
                           "(Authorization Violation), or cluster.ca, certificate or key is, or the peer is "
                           "not a NATS server; \"talusd cluster check\" says which"});
    } else {
      const char* const said = forgotten ? natsStatus_GetText(link.at_first) : text;
      link.events->closed(
          unavailable(fmt::format("{}: {}", forgotten ? "no server of cluster.nats greets this one" : "NATS",
                                  words_of(said == nullptr ? "closed" : said))));
    }
  }
  static void error(natsConnection* /*connection*/, natsSubscription* /*subscription*/, natsStatus status,
                    void* closure) {
    if (status == NATS_NOT_PERMITTED) guard([&] { tell_denied(link(closure)); });
  }
  static void tell_denied(Link& of) {
    // libnats has set this thread's last error to the denial. The connection's last error may be a newer one,
    // if several arrive at once.
    const std::string what = last_words(NATS_NOT_PERMITTED);
    {
      const std::lock_guard lock{of.mutex};
      of.denied = what;
      of.denied_at = Clock::now();
    }
    of.was_denied.notify_all();
    if (of.events) of.events->denied(what);
  }
  static natsStatus sign(char** error_text, unsigned char** signature, int* signature_length,
                         const char* nonce, void* closure) {
    *error_text = nullptr;
    natsStatus status = NATS_NO_MEMORY;
    guard([&] {
      const std::string seed{link(closure).credentials->seed->bytes()};
      status = nats_Sign(seed.c_str(), nonce, signature, signature_length);
    });
    return status;
  }
  /// If memory runs out, the message counts as lost.
  static void message(natsConnection* /*connection*/, natsSubscription* /*subscription*/, natsMsg* message,
                      void* closure) {
    NatsMessage owned{message};
    auto& handled = *static_cast<HandlerData*>(closure);
    guard([&] {
      handled.handler(ReceivedMessage{message});
      handled.discarded.add(std::move(owned));
    });
  }
  static void subscription_ended(void* closure) { delete static_cast<HandlerData*>(closure); }
};

tl::expected<std::shared_ptr<Connection>, StreamFailure> Connection::open(
    const ServerUrls& urls, std::shared_ptr<const Credentials> credentials,
    std::shared_ptr<ConnectionEvents> events, Retry retry, const ServerUrls& first) {
  // Threads started by libnats leave signals to the main thread.
  const SignalBlocker blocked;
  auto link = std::make_shared<Link>();
  link->credentials = std::move(credentials);
  link->events = std::move(events);
  const Credentials& who = *link->credentials;
  auto closure = std::make_unique<std::shared_ptr<Link>>(link);

  natsOptions* made = nullptr;
  Setting set;
  set(natsOptions_Create(&made));
  const NatsOptions options{made};
  std::vector<const char*> servers;
  const std::vector<std::string> all{urls.begin(), urls.end()};
  for (const std::string& url : all) {
    if (first.empty() || url != *first.begin()) servers.push_back(url.c_str());
  }
  if (!servers.empty()) set(natsOptions_SetServers(made, servers.data(), static_cast<int>(servers.size())));
  if (!first.empty()) set(natsOptions_SetURL(made, first.begin()->c_str()));
  // Uses only the configured servers, not discovered ones.
  set(natsOptions_SetIgnoreDiscoveredServers(made, true));
  set(natsOptions_SetName(made, "talusd"));
  set(natsOptions_SetTimeout(made, kConnectTimeoutMs));
  set(natsOptions_SetWriteDeadline(made, kWriteTimeoutMs));
  set(natsOptions_SetPingInterval(made, kPingIntervalMs));
  set(natsOptions_SetMaxPingsOut(made, kMaxPingsOut));
  set(natsOptions_SetSendAsap(made, true));
  // Disables buffering while disconnected, so that senders see the failure.
  set(natsOptions_SetReconnectBufSize(made, 1));
  set(natsOptions_SetReconnectWait(made, kReconnectWaitMs));
  set(natsOptions_SetReconnectJitter(made, kReconnectJitterMs, kReconnectJitterMs));
  if (retry == Retry::forever) {
    set(natsOptions_SetMaxReconnect(made, -1));
  } else {
    set(natsOptions_SetAllowReconnect(made, false));
  }
  set(natsOptions_SetReconnectedCB(made, &Callbacks::connected, closure.get()));
  set(natsOptions_SetDisconnectedCB(made, &Callbacks::disconnected, closure.get()));
  set(natsOptions_SetClosedCB(made, &Callbacks::closed, closure.get()));
  set(natsOptions_SetErrorHandler(made, &Callbacks::error, closure.get()));
  if (who.password) {
    const std::string password{who.password->bytes()};
    set(natsOptions_SetUserInfo(made, who.user.c_str(), password.c_str()));
  }
  if (who.token) set(natsOptions_SetToken(made, std::string{who.token->bytes()}.c_str()));
  if (who.seed) set(natsOptions_SetNKey(made, who.public_key.c_str(), &Callbacks::sign, closure.get()));
  if (who.tls) {
    set(natsOptions_SetSecure(made, true));
    if (!who.ca.empty()) set(natsOptions_SetCATrustedCertificates(made, who.ca.c_str()));
    if (who.key) {
      const std::string key{who.key->bytes()};
      set(natsOptions_SetCertificatesChain(made, who.certificate.c_str(), key.c_str()));
    }
  }
  if (set.failed()) {
    return tl::unexpected{
        StreamFailure{StreamFailure::Kind::refused, fmt::format("NATS: {}", words_of(set.text()))}};
  }

  std::shared_ptr<Connection> connection{new Connection{link}};
  natsConnection* opened = nullptr;
  natsStatus status = natsConnection_Connect(&opened, made);
  if (status != NATS_OK && retry == Retry::forever) {
    link->at_first = status;  // libnats does not report it once it retries by itself
    natsOptions_SetRetryOnFailedConnect(made, true, &Callbacks::connected, closure.get());
    status = natsConnection_Connect(&opened, made);
  }
  connection->connection_.reset(opened);
  if (status != NATS_OK && status != NATS_NOT_YET_CONNECTED) {
    return tl::unexpected{
        StreamFailure{is_refusal(status) ? StreamFailure::Kind::refused : StreamFailure::Kind::unavailable,
                      fmt::format("{}: {}", urls.text(), last_words(status))}};
  }
  // From here on the close callback owns it.
  (void)closure.release();
  if (status == NATS_OK) Callbacks::set_connected(*link, true);
  jsCtx* context = nullptr;
  if (natsConnection_JetStream(&context, opened, nullptr) != NATS_OK) {
    return tl::unexpected{unavailable("NATS: no memory")};
  }
  connection->context_.reset(context);
  return connection;
}

Connection::~Connection() = default;

void Connection::close() {
  natsConnection_Close(connection_.get());
}

tl::expected<void, StreamFailure> Connection::subscribe(const std::string& subject, Handler handler,
                                                        int pending_messages, int pending_bytes) {
  const SignalBlocker blocked;
  auto owned = std::make_unique<Callbacks::HandlerData>(Callbacks::HandlerData{std::move(handler), {}});
  natsSubscription* made = nullptr;
  const natsStatus status =
      natsConnection_Subscribe(&made, connection_.get(), subject.c_str(), &Callbacks::message, owned.get());
  if (status == NATS_CONNECTION_CLOSED) return {};  // rejected meanwhile; the events report it
  if (status != NATS_OK) return tl::unexpected{unavailable(fmt::format("NATS: {}", last_words(status)))};
  NatsSubscription subscription{made};
  // If the connection was closed meanwhile, nothing signals the end of the last handler; the handler is then
  // leaked.
  (void)natsSubscription_SetOnCompleteCB(made, &Callbacks::subscription_ended, owned.get());
  (void)owned.release();
  natsSubscription_SetPendingLimits(made, pending_messages, pending_bytes);
  const std::lock_guard lock{mutex_};
  subscriptions_.push_back(std::move(subscription));
  return {};
}

tl::expected<std::shared_ptr<Connection::Source>, StreamFailure> Connection::open_source(
    const std::string& subject, int pending_messages, int pending_bytes) {
  natsSubscription* made = nullptr;
  const natsStatus status = natsConnection_SubscribeSync(&made, connection_.get(), subject.c_str());
  NatsSubscription subscription{made};
  if (status == NATS_CONNECTION_CLOSED) return nullptr;  // rejected meanwhile; the events report it
  if (status != NATS_OK) return tl::unexpected{unavailable(fmt::format("NATS: {}", last_words(status)))};
  natsSubscription_SetPendingLimits(made, pending_messages, pending_bytes);
  return std::make_shared<Source>(std::move(subscription));
}

Connection::Source::TakeResult Connection::Source::take(std::chrono::milliseconds patience,
                                                        const Handler& handler) {
  natsMsg* come = nullptr;
  const natsStatus status = natsSubscription_NextMsg(&come, subscription_.get(), patience.count());
  if (status == NATS_OK) {
    NatsMessage owned{come};
    handler(ReceivedMessage{come});
    discarded_.add(std::move(owned));
    return TakeResult::message;
  }
  // A slow reader has lost messages, and continues with the rest.
  return status == NATS_TIMEOUT || status == NATS_SLOW_CONSUMER ? TakeResult::none : TakeResult::closed;
}

StreamFailure Connection::failure_of(natsStatus status, Clock::time_point since,
                                     std::string_view doing) const {
  const std::string missing = denied_since(since);
  if (!missing.empty()) return {StreamFailure::Kind::refused, fmt::format("NATS: {}", missing)};
  if (status == NATS_TIMEOUT) return unavailable(fmt::format("NATS: no answer to {}", doing));
  if (status == NATS_NO_RESPONDERS) return unavailable(fmt::format("NATS: no responder for {}", doing));
  return unavailable(fmt::format("NATS: {}", last_words(status)));
}

tl::expected<void, StreamFailure> Connection::send(const std::string& subject, const std::string& reply,
                                                   std::string_view text) {
  if (!connected()) return tl::unexpected{unavailable(kNoConnection)};
  const auto began = Clock::now();
  const natsStatus status = natsConnection_PublishRequest(connection_.get(), subject.c_str(), reply.c_str(),
                                                          text.data(), static_cast<int>(text.size()));
  if (status != NATS_OK) return tl::unexpected{failure_of(status, began, subject)};
  return {};
}

tl::expected<NatsMessage, StreamFailure> Connection::request(const std::string& subject,
                                                             std::string_view text,
                                                             std::chrono::milliseconds patience) {
  if (!connected()) return tl::unexpected{unavailable(kNoConnection)};
  const SignalBlocker blocked;
  const auto began = Clock::now();
  natsMsg* reply = nullptr;
  const natsStatus status = natsConnection_Request(&reply, connection_.get(), subject.c_str(), text.data(),
                                                   static_cast<int>(text.size()), patience.count());
  if (status != NATS_OK) return tl::unexpected{failure_of(status, began, subject)};
  return NatsMessage{reply};
}

natsStatus Connection::await_acks() {
  if (acks_ != nullptr) return NATS_OK;
  natsInbox* inbox = nullptr;
  if (const natsStatus status = natsInbox_Create(&inbox); status != NATS_OK) return status;
  const NatsInbox owned{inbox};
  natsSubscription* acks = nullptr;
  const natsStatus status =
      natsConnection_SubscribeSync(&acks, connection_.get(), fmt::format("{}.*", inbox).c_str());
  acks_.reset(acks);
  acks_to_ = inbox;
  return status;
}

tl::expected<Connection::Ack, StreamFailure> Connection::ack_of(const ReceivedMessage& answer) {
  const auto said = parse_answer(answer.text());
  if (!said) {
    return tl::unexpected{
        StreamFailure{kind_of_refusal(said.error()), fmt::format("NATS: {}", words_of(said.error().what))}};
  }
  return Ack{json_member<std::string>(*said, "stream"), json_member<std::uint64_t>(*said, "seq")};
}

tl::expected<Connection::Ack, StreamFailure> Connection::publish(const std::string& subject,
                                                                 std::span<const std::byte> bytes,
                                                                 std::chrono::milliseconds patience) {
  if (!connected()) return tl::unexpected{unavailable(kNoConnection)};
  const std::lock_guard lock{publishing_};
  const auto began = Clock::now();
  if (const natsStatus status = await_acks(); status != NATS_OK) {
    return tl::unexpected{failure_of(status, began, subject)};
  }
  const std::string reply = fmt::format("{}.{}", acks_to_, ++published_);
  natsStatus status = natsConnection_PublishRequest(connection_.get(), subject.c_str(), reply.c_str(),
                                                    bytes.data(), static_cast<int>(bytes.size()));
  if (status == NATS_MAX_PAYLOAD) {
    return tl::unexpected{StreamFailure{StreamFailure::Kind::too_large,
                                        fmt::format("max_payload of nats-server is {}", max_payload())}};
  }
  while (status == NATS_OK) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(began + patience - Clock::now());
    natsMsg* come = nullptr;
    status = natsSubscription_NextMsg(&come, acks_.get(), std::max<std::int64_t>(left.count(), 0));
    if (status != NATS_OK) break;
    NatsMessage owned{come};
    const bool is_late = ReceivedMessage{come}.subject() != reply;
    const auto ack = is_late ? tl::expected<Ack, StreamFailure>{} : ack_of(ReceivedMessage{come});
    discarded_.add(std::move(owned));
    if (!is_late) return ack;
  }
  return tl::unexpected{failure_of(status, began, subject)};
}

tl::expected<void, StreamFailure> Connection::try_publish(const std::string& subject,
                                                          std::chrono::milliseconds patience) {
  if (!connected()) return tl::unexpected{unavailable(kNoConnection)};
  const SignalBlocker blocked;
  const auto began = Clock::now();
  jsPubOptions options{};
  jsPubOptions_Init(&options);
  options.MaxWait = patience.count();
  options.ExpectStream = "none";  // a wrong stream name: the leader rejects the message before replicating it
  jsErrCode code{};
  const natsStatus status = js_Publish(nullptr, context_.get(), subject.c_str(), nullptr, 0, &options, &code);
  if (status == NATS_ERR && code == JSStreamNotMatchErr) return {};
  if (status == NATS_OK)
    return tl::unexpected{StreamFailure{StreamFailure::Kind::refused, "it was stored nevertheless"}};
  return tl::unexpected{failure_of(status, began, subject)};
}

tl::expected<void, StreamFailure> Connection::flush(std::chrono::milliseconds patience) {
  const natsStatus status = natsConnection_FlushTimeout(connection_.get(), patience.count());
  if (status != NATS_OK) return tl::unexpected{unavailable(fmt::format("NATS: {}", last_words(status)))};
  return {};
}

std::int64_t Connection::max_payload() const {
  return natsConnection_GetMaxPayload(connection_.get());
}

std::string Connection::denied_since(Clock::time_point since) const {
  const std::lock_guard lock{link_->mutex};
  return link_->denied_at >= since ? link_->denied : std::string{};
}

std::string Connection::await_denial(Clock::time_point since, std::chrono::milliseconds patience) const {
  std::unique_lock lock{link_->mutex};
  const bool denied = link_->was_denied.wait_for(lock, patience, [&] { return link_->denied_at >= since; });
  return denied ? link_->denied : std::string{};
}

}  // namespace talus::server::jetstream
