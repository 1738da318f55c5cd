// Edits: sending them, the server's answers, and broadcasts of other clients' edits.
#include <algorithm>
#include <utility>

#include <asio/post.hpp>

#include "core.h"
#include "incoming.h"
#include "outgoing.h"

namespace talus::client {
void Core::edit(Edit edit, std::function<void(Result<EditDone>)> handler) {
  std::optional<ClientError> error;
  if (!running_ || !world_) {
    error = ClientError{ErrorKind::not_connected, "call connect() first", {}};
  } else if (world_->store_id == ContentHash{}) {
    error = ClientError{ErrorKind::refused, "this server stores no edits", {}};
  }
  if (error) {
    asio::post(executor_, [handler = std::move(handler), why = *error] { handler(tl::unexpected{why}); });
    return;
  }
  edits_.add({std::move(edit), std::move(handler)});
  wake();
}

void Core::compose_edits(std::vector<std::byte>& out) {
  const auto now = options_.clock->now();
  const auto append = [&](const protocol::Frame& frame) {
    out.insert(out.end(), frame.begin(), frame.end());
  };
  if (edits_.must_attach() && pace_.take(now)) {
    append(attach_frame(edits_.editor(), edits_.seen_revision()));
    edits_.attach_sent();
  }
  while (edits_.has_next() && pace_.take(now)) {
    const std::uint32_t id = edits_.send_next();
    const protocol::Frame frame = edit_frame(id, *edits_.in_flight(id));
    if (frame.size() <= world_->limits.frame_bytes) {
      append(frame);
      continue;
    }
    const ClientError too_large{ErrorKind::out_of_range,
                                "an edit of " + std::to_string(frame.size()) +
                                    " bytes is more than this server takes in a frame (" +
                                    std::to_string(world_->limits.frame_bytes) + "); divide it",
                                {}};
    std::vector<OpenEdit> refused;
    refused.push_back(edits_.take(id));
    fail_edits(std::move(refused), too_large);
  }
}

Result<void> Core::handle_attached(const wire::Attached& attached) {
  if (!edits_.attaching() || attached.editor() == nullptr || attached.limits() == nullptr) {
    return tl::unexpected{broken_protocol("an Attached that no Attach asked for, or without its fields")};
  }
  useful_ = true;
  edits_wait_for_.clear();
  auto lost = edits_.attached({attached.editor()->low(), attached.editor()->high()}, attached.known(),
                              attached.last_sequence(), attached.revision(), attached.limits()->unanswered());
  fail_edits(std::move(lost), kOutcomeUnknown);
  wake();
  return {};
}

Result<void> Core::handle_edit_result(const wire::EditResult& result) {
  if (edits_.in_flight(result.id()) == nullptr) {
    return tl::unexpected{broken_protocol("an EditResult for request " + std::to_string(result.id()) +
                                          ", which is not an edit in flight")};
  }
  useful_ = true;
  edits_.saw(result.revision());
  edits_wait_for_.clear();
  const OpenEdit edit = edits_.take(result.id());
  edit.handler(EditDone{result.revision(), result.changed()});
  wake();
  return {};
}

Result<void> Core::edit_refused(const wire::Error& error, bool comes_back) {
  const std::uint32_t id = error.request_id();
  if (edits_.in_flight(id) == nullptr) {
    return tl::unexpected{
        broken_protocol("an Error about request " + std::to_string(id) + ", which is not an edit in flight")};
  }
  if (comes_back) {
    edits_wait_for_ = read_error(error).message;
    edits_.put_back(id);
  } else if (error.code() == wire::ErrorCode::expired) {
    edits_.put_back(id);
    edits_.editor_expired();
  } else if (error.code() == wire::ErrorCode::not_applied) {
    edits_.send_as_new(id);
  } else {
    const OpenEdit edit = edits_.take(id);
    // For an edit that was also sent before, only a conflict proves that it was not applied.
    const bool decided = !edit.sent_before || error.code() == wire::ErrorCode::conflict;
    edit.handler(tl::unexpected{decided ? read_error(error) : unknown_outcome(read_error(error))});
  }
  wake();
  return {};
}

// Edits need an editor: if the server asks to retry, they wait; otherwise they fail.
void Core::attach_refused(const ClientError& why, bool comes_back) {
  if (!edits_.attaching()) return;
  edits_.attach_again();
  if (comes_back) {
    edits_wait_for_ = why.message;
  } else {
    fail_all_edits(why);
  }
  wake();
}

void Core::fail_edits(std::vector<OpenEdit> edits, const ClientError& why) {
  if (edits.empty()) return;
  asio::post(executor_, [edits = std::move(edits), why] {
    for (const OpenEdit& edit : edits) edit.handler(tl::unexpected{why});
  });
}

void Core::fail_all_edits(const ClientError& why) {
  auto [sent, unsent] = edits_.take_all();
  fail_edits(std::move(sent), unknown_outcome(why));
  fail_edits(std::move(unsent), why);
}

// The revision shows whether the broadcast is new, and whether it applies to the held chunk. If it does not
// apply, or the chunk is no longer held, the chunk is requested: that is always correct.
Result<void> Core::handle_broadcast(const wire::EditBroadcast& edit) {
  const auto key = read_key(edit.key());
  if (!key) return tl::unexpected{key.error()};
  edits_.saw(edit.revision());
  if (!tracker_.shape().covers(*key)) {
    pass_by(*key);
    tracker_.forget_left(*key);
    return {};
  }
  const auto made = add_to_made(*key, edit);
  if (!made) return tl::unexpected{made.error()};
  if (*made || !tracker_.was_delivered(*key)) return {};
  const auto held = tracker_.held(*key);
  if (held && edit.revision() <= held->revision) return {};
  if (!held || edit.runs() == nullptr || edit.previous_revision() > held->revision) {
    refetch(*key);
    return {};
  }
  const auto edited = read_broadcast(*held, edit);
  if (!edited) return tl::unexpected{edited.error()};
  deliver(*edited);
  return {};
}

}  // namespace talus::client
