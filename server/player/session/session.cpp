#include "player/session/session.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <talus/protocol/limits.h>

#include "player/session/heights_check.h"
#include "player/session/view_check.h"

namespace talus::server {

using wire::ErrorCode;

namespace {

/// Returns the rates that apply to a session of the address.
RateLimits rates_of(const SessionContext& context, const AddressBucketsPtr& address) {
  RateLimits limits = context.rates.get();
  limits.address = address == nullptr ? RateSet{} : address->rates;
  return limits;
}

}  // namespace

Session::Session(const SessionContext& context, MailboxPtr mailbox, const AddressBucketsPtr& address)
    : context_{context},
      delivery_{context_, mailbox},
      edits_{context.edits, std::move(mailbox), replies_},
      edit_admission_{{context.limits.edits, context.chunks, context.memory, context.edits}},
      rates_{rates_of(context, address), address, context.limits.requests_in_flight},
      memory_{context.memory, MemoryUse::sessions} {}

// ---- events

void Session::receive(std::span<const std::byte> frame) {
  if (closing()) return;
  received_at_ = context_.clock.now();
  const auto message = protocol::read_message(frame);
  if (!message) return fail(ErrorCode::malformed, protocol::describe(message.error()));

  const wire::Message& verified = **message;
  const wire::Body kind = verified.body_type();
  if (state_ == State::connected && kind != wire::Body::Hello) {
    return fail(ErrorCode::unexpected,
                fmt::format("the first message must be Hello, not {}", wire::EnumNameBody(kind)));
  }
  switch (kind) {
    case wire::Body::Hello:
      on(*verified.body_as_Hello());
      break;
    case wire::Body::View:
      on(*verified.body_as_View());
      break;
    case wire::Body::GetChunks:
      on(*verified.body_as_GetChunks());
      break;
    case wire::Body::Cancel:
      on(*verified.body_as_Cancel());
      break;
    case wire::Body::GetHeights:
      on(*verified.body_as_GetHeights());
      break;
    case wire::Body::GetFile:
      on(*verified.body_as_GetFile());
      break;
    case wire::Body::Credit:
      on(*verified.body_as_Credit());
      break;
    case wire::Body::Attach:
      on(*verified.body_as_Attach());
      break;
    case wire::Body::Edit:
      on(*verified.body_as_Edit());
      break;
    case wire::Body::Ping:
      on(*verified.body_as_Ping());
      break;
    default:
      fail(ErrorCode::unexpected,
           fmt::format("{} is a message that only servers send", wire::EnumNameBody(kind)));
  }
  close_if_served();
}

void Session::broken_frame(const protocol::FrameError& error) {
  const bool huge = error.claimed_bytes > error.limit_bytes;
  fail(huge ? ErrorCode::too_large : ErrorCode::malformed, error.message());
}

void Session::refuse_foreign(std::vector<std::byte> answer, std::string_view protocol) {
  if (closing()) return;
  std::string why = fmt::format("the client speaks another protocol: {}", protocol);
  // An Error is not TLS, so that a TLS client reports that the server does not speak it.
  if (answer.empty()) return fail(ErrorCode::malformed, why);
  replies_.foreign(std::move(answer));
  failure_ = std::move(why);
  abandon();
}

void Session::holds_input(std::size_t bytes) {
  const bool grew = bytes > input_bytes_;
  input_bytes_ = bytes;
  if (!grew || bytes <= kMaxFrameBytesAnyway) return;
  note_memory();
  if (takes_work(bytes)) return;
  fail(ErrorCode::overloaded, "this server has no memory for so large a frame", retry_after::kBusy);
}

void Session::timed_out(std::string_view text) {
  fail(ErrorCode::timeout, text);
}

void Session::token_expired() {
  if (closing()) return;
  context_.metrics.denied(AuthFailure::expired).add();
  fail(ErrorCode::unauthorized, describe(AuthFailure::expired));
}

void Session::access_changed(bool address_blocked) {
  if (closing()) return;
  std::optional<AuthFailure> failure;
  if (address_blocked) {
    failure = AuthFailure::blocked;
  } else if (greeting_) {
    failure = context_.access.withdrawn(greeting_->grant);
  }
  if (!failure) return;
  context_.metrics.denied(*failure).add();
  fail(ErrorCode::unauthorized, describe(*failure));
}

void Session::rates_changed(const AddressBucketsPtr& address) {
  RateLimits limits = rates_of(context_, address);
  if (greeting_ && greeting_->grant.rights.has(Right::gateway)) limits = limits.of_gateway();
  rates_.change(limits, address, context_.clock.now());
}

void Session::take_mail() {
  delivery_.take_mail(edits_);
  // The number of voxels that slid is known only now.
  if (const std::uint64_t slid = edits_.take_slid_voxels(); slid > 0) {
    rates_.spend_voxels(context_.clock.now(), slid);
  }
  close_if_served();
}

void Session::input_ended() {
  if (state_ == State::connected) return abandon();
  delivery_.credit().lift();
  edits_.input_ended();
  if (state_ == State::joined) state_ = State::finishing;
  close_if_served();
}

void Session::ask_whether_gone() {
  if (greeting_ && !closing()) replies_.view_complete(0);
}

void Session::go_away(std::string_view reason, std::chrono::milliseconds retry_after) {
  if (state_ == State::leaving || state_ == State::closed) return;
  if (state_ == State::connected) {  // as to a client that finds the server full
    // An Error without a time means that retrying is useless.
    replies_.error({}, ErrorCode::overloaded, reason, std::max(retry_after, std::chrono::milliseconds{1}));
    return abandon();
  }
  replies_.go_away(reason, retry_after);
  state_ = State::leaving;
  delivery_.end_view();
  close_if_served();
}

void Session::give_way(std::string_view text) {
  fail(ErrorCode::overloaded, text, retry_after::kServerFull, "it gave way to others");
}

void Session::abandon() {
  state_ = State::closed;
  delivery_.abandon();
  edits_.abandon();
  rates_.give_back();
}

void Session::fail(ErrorCode code, std::string_view text, std::chrono::milliseconds retry_after,
                   std::string_view why) {
  if (closing()) return;
  replies_.error({}, code, text, retry_after);
  failure_ = fmt::format("{}: {}", wire::EnumNameErrorCode(code), text);
  if (!why.empty()) failure_ += fmt::format(" ({})", why);
  abandon();
}

void Session::close_if_served() {
  const bool served = state_ == State::leaving ? delivery_.requests().empty()
                                               : state_ == State::finishing && delivery_.served();
  if (served && edits_.served()) {
    state_ = State::closed;
  }
}

std::size_t Session::pump() {
  if (!closing() && delivery_.has_lost_mail()) {
    fail(ErrorCode::internal, "an answer was lost: out of memory", retry_after::kBusy);
  }
  const Clock::time_point began = context_.clock.now();
  const std::size_t found = closing() ? 0 : delivery_.start_work();
  if (found > 0) context_.metrics.hot_latency.add(context_.clock.now() - began, found);
  close_if_served();
  note_memory();
  note_client();
  if (const std::uint64_t refusals = replies_.take_refusals(); refusals > 0) {
    flow().add(FlowMeasure::refusals, refusals);
  }
  return found;
}

// ---- messages

void Session::on(const wire::Hello& hello) {
  if (state_ != State::connected) return fail(ErrorCode::unexpected, "a second Hello");
  auto greeting = greet(hello, context_.limits, context_.access, context_.clock.wall());
  if (!greeting) {
    const Rejection& rejection = greeting.error();
    if (rejection.auth_failure) context_.metrics.denied(*rejection.auth_failure).add();
    failure_is_known_ = rejection.repeated;
    return fail(rejection.code, rejection.text, retry_after::kNever, rejection.why);
  }
  greeting_ = *std::move(greeting);
  const std::string& subject = greeting_->grant.subject;
  if (!subject.empty()) {
    delivery_.join(context_.flows.of_subject(subject));
    memory_.move_to(flow().id());
  }
  delivery_.credit() = Credit{greeting_->window_bytes};
  if (greeting_->grant.rights.has(Right::gateway)) rates_.become_gateway(received_at_);
  replies_.welcome(*greeting_, context_.world, context_.limits, rates_.limits());
  state_ = State::joined;
}

void Session::on(const wire::View& view) {
  if (!within_rates(about_view(view.number()))) return;
  auto checked = check_view(view, context_.limits, context_.world.heights);
  if (!checked) {
    const Rejection& rejection = checked.error();
    if (rejection.code == ErrorCode::malformed) return fail(rejection.code, rejection.text);
    return replies_.error(about_view(view.number()), rejection.code, rejection.text);
  }
  if (state_ == State::leaving) return;
  // Near the memory limit a View may move but not grow. Chunks that the client holds are then resent.
  const bool takes_work = context_.memory.takes_work();
  const std::uint64_t chunks = count_chunks(*checked);
  if (chunks > view_chunks_ && !this->takes_work(chunks * kViewBytesPerChunk)) {
    return replies_.error(about_view(view.number()), ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
  }
  view_chunks_ = chunks;
  delivery_.view().request(*std::move(checked));
  if (view.known() == nullptr || !takes_work) return;
  for (const wire::KnownChunk* chunk : *view.known()) {
    const wire::ChunkKey& at = chunk->key();
    const auto lod = Lod::checked(at.lod());
    if (!lod) continue;
    delivery_.view().add_known({{at.x(), at.y(), at.z()}, *lod}, {chunk->hash().low(), chunk->hash().high()});
  }
}

void Session::on(const wire::GetChunks& get) {
  if (get.requests() == nullptr) return;
  (void)takes_work(0);  // makes room for their chunks
  AnsweredIds answered;
  for (const wire::ChunkRequest* request : *get.requests()) {
    const bool pending = on(*request, answered);
    if (closing()) return;
    if (pending) continue;
    if (!answered) answered.emplace();
    if (answered->find(request->id()) == nullptr) answered->insert(request->id(), {});
  }
}

bool Session::on(const wire::ChunkRequest& request, const AnsweredIds& answered) {
  const std::uint32_t id = request.id();
  if (id == 0) {
    fail(ErrorCode::malformed, "ChunkRequest.id is 0; ids begin at 1");
    return false;
  }
  if (!admit_id(id, answered && answered->find(id) != nullptr) || !admit_pending(id)) return false;
  const auto out_of_range = [&](const std::string& text) {
    replies_.error(about_request(id), ErrorCode::out_of_range, text);
    return false;
  };
  const wire::ChunkKey& at = request.key();
  const auto lod = Lod::checked(at.lod());
  if (!lod) return out_of_range(lod.error().message);
  const auto key = checked_chunk(at.x(), at.y(), at.z(), *lod);
  if (!key) return out_of_range(key.error().message);
  std::optional<ContentHash> known;
  if (request.has_known()) known = ContentHash{request.known().low(), request.known().high()};
  delivery_.request_chunk(id, {*key, known});
  return true;
}

void Session::on(const wire::Cancel& cancel) {
  if (cancel.ids() == nullptr) return;
  delivery_.cancel({cancel.ids()->begin(), cancel.ids()->end()});
}

void Session::on(const wire::GetHeights& get) {
  if (get.id() == 0) return fail(ErrorCode::malformed, "GetHeights.id is 0; ids begin at 1");
  if (!admit_id(get.id()) || !admit_pending(get.id())) return;
  if (!takes_work(input_bytes_)) {
    return replies_.error(about_request(get.id()), ErrorCode::overloaded, kNoMemory, retry_after::kBusy);
  }
  auto query = check_heights(get, context_.limits, context_.world.fields.size());
  if (!query) return replies_.error(about_request(get.id()), query.error().code, query.error().text);
  delivery_.request_heights(get.id(), *std::move(query));
}

void Session::on(const wire::GetFile& get) {
  if (get.id() == 0) return fail(ErrorCode::malformed, "GetFile.id is 0; ids begin at 1");
  if (!admit_id(get.id()) || !admit_pending(get.id())) return;
  const PublishedWorld* const published = context_.world.published.get();
  if (published == nullptr) {
    return replies_.error(about_request(get.id()), ErrorCode::unsupported, kNotPublished);
  }
  const std::string* const file =
      published->find(get.name() == nullptr ? std::string_view{} : get.name()->string_view());
  if (file == nullptr) {
    return replies_.error(about_request(get.id()), ErrorCode::out_of_range,
                          "the world's file names no such file");
  }
  if (get.offset() > file->size()) {
    return replies_.error(about_request(get.id()), ErrorCode::out_of_range,
                          fmt::format("offset {} is beyond the file's end, {}", get.offset(), file->size()));
  }
  const std::string_view rest = std::string_view{*file}.substr(static_cast<std::size_t>(get.offset()));
  delivery_.request_file(get.id(), {rest.substr(0, protocol::kMaxFilePartBytes), file->size()});
}

void Session::on(const wire::Credit& credit) {
  if (auto taken = delivery_.credit().taken(credit.total_bytes()); !taken) {
    fail(ErrorCode::malformed, taken.error().message);
  }
}

EditingSession Session::editing_session() const {
  return edits_.session(greeting_->grant, flow().id(), received_at_, state_ == State::leaving);
}

void Session::on(const wire::Edit& edit) {
  if (edit.id() == 0) return fail(ErrorCode::malformed, "Edit.id is 0; ids begin at 1");
  if (!admit_id(edit.id())) return;
  const Subject subject = about_request(edit.id());
  auto admitted = edit_admission_.admit(edit, editing_session());
  if (!admitted) {
    const EditError& error = admitted.error();
    if (error.code == EditErrorCode::malformed) return fail(ErrorCode::malformed, error.message);
    return replies_.error(subject, error);
  }
  // The last check: a refused edit must not use up the rates shared with others at the address.
  if (const auto refusal = edit_admission_.charge(*admitted, rates_, received_at_)) {
    return say_refusal(subject, *refusal);
  }
  edits_.edit(edit.id(), edit.sequence(), *std::move(admitted));
}

void Session::on(const wire::Attach& attach) {
  const Subject subject = about_attach();
  if (!within_rates(subject)) return;
  if (edits_.attaching()) return fail(ErrorCode::unexpected, "an Attach before the last was answered");
  auto admitted = edit_admission_.admit(attach, editing_session());
  if (!admitted) return replies_.error(subject, admitted.error());
  if (admitted->makes_editor) {
    if (const auto refusal = rates_.refuse_editor(received_at_)) return say_refusal(subject, *refusal);
  }
  edits_.attach(std::move(admitted->request), rates_.limits().session.voxels.per_second);
}

void Session::on(const wire::Ping& ping) {
  if (within_rates(about_ping())) replies_.pong(ping.nonce());
}

void Session::say_refusal(const Subject& subject, const SessionRates::Refusal& refusal) {
  context_.metrics.throttled(refusal.kind).add();
  using std::chrono::milliseconds;
  const auto retry_after = std::max(milliseconds{1}, std::chrono::ceil<milliseconds>(refusal.wait));
  if (refusal.abusive) {
    fail(ErrorCode::overloaded,
         fmt::format("abusive: refused by rates.{} and still sending requests", name(refusal.kind)),
         retry_after);
  } else {
    replies_.error(subject, ErrorCode::overloaded, fmt::format("over rates.{}", name(refusal.kind)),
                   retry_after);
  }
}

bool Session::admit_id(std::uint32_t id, bool repeated) {
  repeated = repeated || delivery_.requests().contains(id) || edits_.contains(id);
  const Subject subject = repeated ? about_repeated(id) : about_request(id);
  if (!within_rates(subject)) return false;
  if (repeated) {
    replies_.error(subject, ErrorCode::duplicate_id, fmt::format("the id {} is another request's", id));
  }
  return !repeated;
}

void Session::refuse_pending(std::uint32_t id) {
  if (state_ == State::leaving) {
    replies_.error(about_request(id), ErrorCode::overloaded, "this server is shutting down",
                   retry_after::kLeaving);
  } else {
    replies_.error(
        about_request(id), ErrorCode::too_many_requests,
        fmt::format("{} requests are in flight, the limit requests_in_flight", delivery_.requests().size()),
        retry_after::kBusy);
  }
}

// ---- output

Clock::time_point Session::sendable_at() {
  constexpr Clock::time_point kAtOnce{};
  constexpr Clock::time_point kNever = Clock::time_point::max();
  if (delivery_.outbox().has_control()) return kAtOnce;
  const bool waits = delivery_.sendable();
  // No further output follows in a closed session.
  const bool pauses = !waits && !closing() && delivery_.credit().may_send();
  const Clock::time_point from = waits ? kAtOnce : pauses ? delivery_.updates_resume() : kNever;
  if (from == kNever) return kNever;
  const Clock::time_point now = context_.clock.now();
  if (from > now) return from;
  const SessionRates::Due due = rates_.chunks_due(now);
  if (due.throttled) context_.metrics.throttled(*due.throttled).add();
  return due.at > now ? due.at : kAtOnce;
}

Output Session::take_output(std::size_t enough_bytes, std::size_t shared_from) {
  const Clock::time_point now = context_.clock.now();
  Output output{shared_from};
  output.reserve(std::min(enough_bytes, delivery_.outbox().bytes_to_copy(shared_from)));
  const SessionRates::Allowance allowance = rates_.allowance(now);
  const Delivery::WrittenChunks written =
      delivery_.write({enough_bytes, allowance.chunks, allowance.bytes}, output);
  rates_.sent(now, written.chunks, output.size());
  writing_bytes_ = output.held_bytes();
  context_.metrics.chunks_sent.add(written.chunks);
  context_.metrics.chunk_bytes_sent.add(written.chunk_bytes);
  close_if_served();
  note_client();
  return output;
}

void Session::written() {
  writing_bytes_ = 0;
  if (std::exchange(client_drains_, false)) memory_.drain_ends(context_.clock.now());
  note_client();
  note_memory();
}

void Session::note_client() {
  const bool drains =
      writing_bytes_ > 0 || (delivery_.outbox().chunk_bytes() > 0 && !delivery_.credit().may_send());
  if (drains == client_drains_) return;
  client_drains_ = drains;
  if (drains) {
    memory_.drain_begins(context_.clock.now(), writing_bytes_);
  } else {
    memory_.drain_ends(context_.clock.now());
  }
}

void Session::note_memory() {
  memory_.hold(kIdleBytes + writing_bytes_ + input_bytes_ + queued_bytes() + delivery_.bytes() +
               edits_.bytes() + edit_admission_.bytes() + view_bytes_to_come());
}

std::size_t Session::view_bytes_to_come() const {
  const ViewSubscription& view = delivery_.view();
  const std::size_t wanted = view.waits() ? view_chunks_ * kViewBytesPerChunk : 0;
  return wanted - std::min(wanted, view.bytes());
}

}  // namespace talus::server
