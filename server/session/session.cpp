#include "session/session.h"

#include <utility>

#include <fmt/format.h>

#include "session/replies.h"

namespace talus::server {
namespace {

/// Puts a service's answers into a mailbox.
class MailboxClient final : public ChunkClient {
 public:
  explicit MailboxClient(MailboxPtr mailbox) : mailbox_{std::move(mailbox)} {}
  void chunks_ready(std::vector<ReadyChunk> chunks) override {
    for (ReadyChunk& chunk : chunks) mailbox_->put(ChunkReady{chunk.key, std::move(chunk.answer)});
    mailbox_->wake();
  }
  void heights_ready(std::uint64_t ticket, HeightsAnswer answer) override {
    mailbox_->put(HeightsReady{ticket, std::move(answer)});
    mailbox_->wake();
  }

 private:
  MailboxPtr mailbox_;
};

}  // namespace

Session::Session(const SessionContext& context, const MailboxPtr& mailbox, AddressBucketsPtr address)
    : Session{context, std::move(address)} {
  mailbox_ = mailbox;
  client_ = std::make_shared<MailboxClient>(mailbox);
}

void Session::take_mail() {
  for (const Mail& mail : mailbox_->take()) {
    if (const auto* chunk = std::get_if<ChunkReady>(&mail)) chunk_ready(chunk->key, chunk->answer);
    if (const auto* heights = std::get_if<HeightsReady>(&mail)) heights_ready(heights->ticket, heights->answer);
  }
}

void Session::receive(std::span<const std::byte> frame, Clock::time_point now) {
  if (closing()) return;
  received_at_ = now;
  const auto message = protocol::read_message(frame);
  if (!message) return fail(wire::ErrorCode::malformed, protocol::describe(message.error()));

  const wire::Message& verified = **message;
  const wire::Body kind = verified.body_type();
  if (!greeted() && kind != wire::Body::Hello) {
    return fail(wire::ErrorCode::unexpected,
                fmt::format("the first message must be Hello, not {}", wire::EnumNameBody(kind)));
  }
  switch (kind) {
    case wire::Body::Hello:
      return on(*verified.body_as_Hello());
    case wire::Body::View:
      return on(*verified.body_as_View());
    case wire::Body::GetChunks:
      return on(*verified.body_as_GetChunks());
    case wire::Body::Cancel:
      return on(*verified.body_as_Cancel());
    case wire::Body::GetHeights:
      return on(*verified.body_as_GetHeights());
    case wire::Body::Credit:
      return on(*verified.body_as_Credit());
    case wire::Body::Edit:
      return on(*verified.body_as_Edit());
    case wire::Body::Ping:
      return on(*verified.body_as_Ping());
    default:
      return fail(wire::ErrorCode::unexpected,
                  fmt::format("{} is a message of servers", wire::EnumNameBody(kind)));
  }
}

void Session::broken_frame(const protocol::FrameError& error) {
  const bool huge = error.claimed_bytes > error.limit_bytes;
  fail(huge ? wire::ErrorCode::too_large : wire::ErrorCode::malformed, error.message());
}

void Session::timed_out(std::string_view text) {
  fail(wire::ErrorCode::timeout, text);
}

void Session::token_expired() {
  context_.metrics.denied(Denial::expired).add();
  fail(wire::ErrorCode::unauthorized, describe(Denial::expired));
}

void Session::go_away(std::string_view reason, std::uint32_t retry_after_ms) {
  if (closing() || going_away_) return;
  outbox_.push_control(go_away_frame(reason, retry_after_ms));
  going_away_ = true;
  next_view_.reset();
  unseen_views_.clear();
  known_.clear();
  drop_from_view(view_.replace({}));
}

void Session::fail(wire::ErrorCode code, std::string_view text, std::uint32_t retry_after_ms,
                   std::string_view why) {
  if (closing_) return;
  context_.metrics.error(code).add();
  outbox_.push_control(error_frame(code, text, 0, retry_after_ms));
  failure_ = fmt::format("{}: {}", wire::EnumNameErrorCode(code), text);
  if (!why.empty()) failure_ += fmt::format(" ({})", why);
  closing_ = true;
  abandon();
}

void Session::abandon() {
  closing_ = true;
  for (const auto& [key, awaited] : awaited_) context_.chunks.cancel(*client_, key);
  awaited_.clear();
  for (const std::uint32_t id : requests_.ids()) {
    if (const auto ticket = requests_.heights_ticket(id)) context_.chunks.cancel_heights(*client_, *ticket);
  }
  requests_.clear();
  next_view_.reset();
  unseen_views_.clear();
  known_.clear();
  outbox_.drop_chunks([](const Outbox::Entry&) { return true; });
}

void Session::note_memory() {
  constexpr std::size_t kPerRequest = 128;  // in the book and in the queue of generators
  constexpr std::size_t kPerKnown = 64;
  memory_.hold(kIdleBytes + writing_bytes_ + queued_bytes() + outbox_.chunk_bytes() + view_.bytes() +
               (requests_.size() + awaited_.size()) * kPerRequest + known_.size() * kPerKnown);
}

}  // namespace talus::server
