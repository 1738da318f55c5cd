// Handles the server's messages. Everything is checked before it reaches a caller.
#include <algorithm>

#include "core.h"
#include "incoming.h"

namespace talus::client {

Result<void> Core::handle(std::span<const std::byte> frame) {
  const auto message = protocol::read_message(frame);
  if (!message) return tl::unexpected{broken_protocol(std::string{protocol::describe(message.error())})};
  const wire::Message& m = **message;
  if (!leaving_) close_reason_.reset();  // it did not end the connection; after GoAway it only finishes
  switch (m.body_type()) {
    case wire::Body::Chunk:
      return handle_chunk(*m.body_as_Chunk(), frame.size());
    case wire::Body::Unchanged:
      return handle_unchanged(*m.body_as_Unchanged());
    case wire::Body::UniformColumn:
      return handle_column(*m.body_as_UniformColumn());
    case wire::Body::Heights:
      return handle_heights(*m.body_as_Heights());
    case wire::Body::FilePart:
      return handle_file_part(*m.body_as_FilePart());
    case wire::Body::Error:
      return handle_error(*m.body_as_Error());
    case wire::Body::EditBroadcast:
      return handle_broadcast(*m.body_as_EditBroadcast());
    case wire::Body::Attached:
      return handle_attached(*m.body_as_Attached());
    case wire::Body::EditResult:
      return handle_edit_result(*m.body_as_EditResult());
    case wire::Body::Pong:
      return handle_pong(*m.body_as_Pong());
    case wire::Body::GoAway:
      return handle_go_away(*m.body_as_GoAway());
    case wire::Body::ViewComplete:
      return handle_complete(*m.body_as_ViewComplete());
    default:
      return tl::unexpected{
          broken_protocol(std::string{"an unexpected "} + wire::EnumNameBody(m.body_type()))};
  }
}

Result<void> Core::handle_chunk(const wire::Chunk& chunk, std::size_t frame_bytes) {
  ++stats_.chunk_frames;
  stats_.chunk_bytes += frame_bytes;
  const auto key = read_key(chunk.key());
  if (!key) return tl::unexpected{key.error()};
  edits_.saw(chunk.revision());

  const auto* request = chunk.id() == 0 ? nullptr : requests_.in_flight(chunk.id());
  if (chunk.id() != 0) {
    const auto* asked = request == nullptr ? nullptr : std::get_if<ChunkRequest>(request);
    if (asked == nullptr || asked->key != *key) {
      return tl::unexpected{broken_protocol("chunk " + to_string(*key) + " as the answer to request " +
                                            std::to_string(chunk.id()) + ", which did not ask for it")};
    }
  }
  // A chunk of a View replaced meanwhile still counts as received.
  const bool wanted = request != nullptr || tracker_.shape().covers(*key);
  if (!wanted) pass_by(*key);
  if (wanted) {
    const auto received = read_chunk(*key, chunk);
    if (received) {
      useful_ = true;
    } else {
      ++stats_.bad_chunks;
    }
    if (request != nullptr) {
      std::get<ChunkRequest>(requests_.take(chunk.id())).handler(received);
    } else if (received) {
      deliver(*received);
    } else {
      report(received.error());
    }
  }
  taken_bytes_ += frame_bytes;
  wake();
  return {};
}

Result<void> Core::handle_unchanged(const wire::Unchanged& unchanged) {
  const auto key = read_key(unchanged.key());
  if (!key) return tl::unexpected{key.error()};
  edits_.saw(unchanged.revision());
  if (unchanged.id() == 0) return confirm(*key, read_hash(unchanged.hash()), unchanged.revision());
  const auto* request = requests_.in_flight(unchanged.id());
  const auto* asked = request == nullptr ? nullptr : std::get_if<ChunkRequest>(request);
  const ContentHash hash = read_hash(unchanged.hash());
  if (asked == nullptr || asked->key != *key || asked->known != hash) {
    return tl::unexpected{broken_protocol("Unchanged for chunk " + to_string(*key) +
                                          ", which no request asked for with that hash")};
  }
  useful_ = true;
  std::get<ChunkRequest>(requests_.take(unchanged.id()))
      .handler(ReceivedChunk{*key, unchanged.revision(), hash, nullptr});
  wake();
  return {};
}

// Handles a chunk of the View that this client announced as held. It may have been released since.
Result<void> Core::confirm(ChunkKey key, ContentHash hash, std::uint64_t revision) {
  if (!tracker_.shape().covers(key)) {
    pass_by(key);
    return {};
  }
  useful_ = true;
  auto held = tracker_.held(key);
  if (!held || held->hash != hash) {
    refetch(key);
    return {};
  }
  ++stats_.kept_chunks;
  held->revision = std::max(held->revision, revision);
  deliver(*held);
  return {};
}

Result<ReceivedChunk> Core::uniform(ChunkKey key, MaterialId material, std::uint64_t revision) {
  auto known = uniform_chunks_.find(material);
  if (known == uniform_chunks_.end()) {
    const bool of_this_world = std::any_of(world_->materials.begin(), world_->materials.end(),
                                           [&](const Material& m) { return m.id == material; });
    if (!of_this_world) {
      return tl::unexpected{broken_protocol("a UniformColumn of material " +
                                            std::to_string(to_integer(material)) +
                                            ", which is not in Welcome")};
    }
    auto chunk = std::make_shared<const Chunk>(Chunk::uniform(material));
    const ContentHash hash = content_hash(*chunk);
    known = uniform_chunks_.emplace(material, UniformChunk{std::move(chunk), hash}).first;
  }
  return ReceivedChunk{key, revision, known->second.hash, known->second.chunk};
}

Result<void> Core::handle_column(const wire::UniformColumn& column) {
  const auto lod = Lod::checked(column.lod());
  if (!lod) return tl::unexpected{broken_protocol(lod.error().message)};
  if (column.runs() == nullptr) return {};
  // A run may claim 2^32 chunks: only the rows of a View are visited.
  for (const auto* run : *column.runs()) {
    const ChunkRange named{run->first_y(), run->last_y()};
    const ChunkRange now = overlap(tracker_.shape().rows(column.x(), column.z(), *lod), named);
    for (std::int64_t y = now.first; y <= now.last; ++y) {
      const ChunkKey key{{column.x(), static_cast<std::int32_t>(y), column.z()}, *lod};
      if (!tracker_.shape().covers(key)) continue;  // the previous callback set another View
      const auto chunk = uniform(key, MaterialId{run->material()}, column.revision());
      if (!chunk) return tl::unexpected{chunk.error()};
      useful_ = true;
      ++stats_.uniform_chunks;
      deliver(*chunk);
      if (!joined_) return {};  // the callback closed the client, which freed the message
    }
    const ChunkRange sent = overlap(sent_shape_.rows(column.x(), column.z(), *lod), named);
    for (std::int64_t y = sent.first; view_to_send_ && y <= sent.last; ++y) {
      const ChunkKey key{{column.x(), static_cast<std::int32_t>(y), column.z()}, *lod};
      if (!tracker_.shape().covers(key)) pass_by(key);
    }
  }
  return {};
}

// Handles a chunk of the server's View that the newest View does not cover. If the newest View is still to be
// sent, a later one may bring the chunk back, and the server would never know that it was dropped.
void Core::pass_by(const ChunkKey& key) {
  if (view_to_send_ && sent_shape_.covers(key)) left_since_view_sent_.insert(key);
}

Result<void> Core::handle_heights(const wire::Heights& heights) {
  const auto* request = requests_.in_flight(heights.id());
  const auto* asked = request == nullptr ? nullptr : std::get_if<HeightsRequest>(request);
  const std::size_t count = heights.heights_fx() == nullptr ? 0 : heights.heights_fx()->size();
  if (asked == nullptr || asked->columns.size() != count) {
    return tl::unexpected{broken_protocol(std::to_string(count) + " heights as the answer to request " +
                                          std::to_string(heights.id()) + ", which did not ask for them")};
  }
  const std::size_t looks = heights.looks() == nullptr ? 0 : heights.looks()->size();
  const std::size_t values = heights.values() == nullptr ? 0 : heights.values()->size();
  if (looks != (asked->looks ? count : 0) || values != count * asked->fields.size()) {
    return tl::unexpected{broken_protocol("Heights of " + std::to_string(count) + " columns with " +
                                          std::to_string(looks) + " looks and " + std::to_string(values) +
                                          " values for request " + std::to_string(heights.id()))};
  }
  ColumnPlaces places;
  if (count > 0) places.heights_fx.assign(heights.heights_fx()->begin(), heights.heights_fx()->end());
  if (looks > 0) places.looks.assign(heights.looks()->begin(), heights.looks()->end());
  if (values > 0) places.values.assign(heights.values()->begin(), heights.values()->end());
  for (const std::uint8_t look : places.looks) {
    if (look < world_->looks.size()) continue;
    return tl::unexpected{broken_protocol("look " + std::to_string(look) + ", which is not in Welcome")};
  }
  useful_ = true;
  std::get<HeightsRequest>(requests_.take(heights.id())).handler(std::move(places));
  wake();
  return {};
}

Result<void> Core::handle_error(const wire::Error& error) {
  const ClientError why = read_error(error);
  const bool is_request = error.about() == wire::ErrorAbout::request;
  const bool comes_back = error.code() == wire::ErrorCode::overloaded && why.retry_after.count() > 0;
  if (comes_back) pace_.refused(options_.clock->now(), why.retry_after);
  if (is_request && (error.request_id() & OpenEdits::kIdBit) != 0) return edit_refused(error, comes_back);
  if (error.about() == wire::ErrorAbout::attach) {
    attach_refused(why, comes_back);
    return {};
  }
  if (is_request) {
    if (requests_.in_flight(error.request_id()) == nullptr) {
      return tl::unexpected{broken_protocol("an Error about request " + std::to_string(error.request_id()) +
                                            ", which is not in flight")};
    }
    if (!comes_back || !requests_.put_back(error.request_id())) fail(requests_.take(error.request_id()), why);
    wake();
    return {};
  }
  close_reason_ = why;
  if (error.about() == wire::ErrorAbout::view_chunk) {
    const auto key = read_key(error.chunk());
    if (!key) return tl::unexpected{key.error()};
    if (tracker_.shape().covers(*key)) refetch(*key);
  } else if (error.about() == wire::ErrorAbout::ping) {
    ping_refused(why);
  } else if (error.about() == wire::ErrorAbout::view && comes_back) {
    view_to_send_ = view_to_send_ || error.view_number() == view_number_;
    wake();
  } else {
    report(why);
  }
  return {};
}

// Pings are answered in order, so this refusal is for the oldest.
void Core::ping_refused(const ClientError& why) {
  const auto open = open_pings_.begin();
  if (open == open_pings_.end() || !open->second.is_sent) return;
  const OpenPing ping = std::move(open->second);
  open_pings_.erase(open);
  if (ping.handler) ping.handler(tl::unexpected{why});
}

void Core::refetch(ChunkKey key) {
  const auto [entry, fresh] = refetching_.try_emplace(key, false);
  if (!fresh) {  // edited again during the request: request once more afterwards, however many edits
    entry->second = true;
    return;
  }
  const auto weak = weak_from_this();
  get(key, std::nullopt, [weak, key](const Result<ReceivedChunk>& chunk) {
    const auto self = weak.lock();
    if (!self) return;
    const auto done = self->refetching_.find(key);
    const bool again = done->second;
    self->refetching_.erase(done);
    if (!self->joined_) return;
    if (self->tracker_.shape().covers(key)) {
      if (chunk) {
        self->deliver(*chunk);
      } else {
        self->report(chunk.error());
      }
      if (again && self->joined_) self->refetch(key);
    }
    self->tell_complete();
  });
}

Result<void> Core::handle_pong(const wire::Pong& pong) {
  const auto open = open_pings_.find(pong.nonce());
  if (open == open_pings_.end()) return tl::unexpected{broken_protocol("a Pong that no Ping asked for")};
  const OpenPing ping = std::move(open->second);
  open_pings_.erase(open);
  if (ping.handler) {
    ping.handler(std::chrono::duration_cast<std::chrono::nanoseconds>(options_.clock->now() - ping.sent));
  }
  return {};
}

Result<void> Core::handle_go_away(const wire::GoAway& away) {
  leaving_ = true;
  close_reason_ = ClientError{ErrorKind::disconnected, "the server goes away: " + read_text(away.reason()),
                              std::chrono::milliseconds{away.retry_after_ms()}};
  return {};
}

Result<void> Core::handle_complete(const wire::ViewComplete& complete) {
  // This may have crossed a View that replaces the one it is about.
  if (!view_sent_ || view_to_send_ || complete.number() != view_number_) return {};
  if (std::exchange(completed_number_, view_number_) == view_number_) return {};
  complete_to_tell_ = true;
  if (sent_base_ && generates()) {
    local_->all_edits_came();
    return {};
  }
  // Sent but missing: it was bad, or arrived while a View, refused later, did not cover it.
  for (const ChunkKey& key : tracker_.missing()) {
    if (!refetching_.contains(key)) refetch(key);
  }
  tell_complete();
  return {};
}

// Chunks requested again are still missing: the View is complete only after them.
void Core::tell_complete() {
  if (!complete_to_tell_ || view_to_send_ || !refetching_.empty() || !joined_) return;
  if (sent_base_ && generates() && !local_->done()) return;
  complete_to_tell_ = false;
  if (events_.on_view_complete) events_.on_view_complete(View{*tracker_.view()});
}

void Core::deliver(const ReceivedChunk& chunk) {
  const auto local = generates() ? local_ : nullptr;
  const auto made = local && chunk.revision == 0 ? tracker_.generated_hash(chunk.key) : std::nullopt;
  if (made == chunk.hash) return;  // sent before the View that has its base here
  // An answer and a chunk of the View may overtake each other.
  if (!tracker_.deliver(chunk)) return;
  if (local) local->came(chunk.key, chunk.revision);
  if (events_.on_chunk) events_.on_chunk(chunk);
  if (made && local->active()) local->differs(chunk.key);
}

}  // namespace talus::client
