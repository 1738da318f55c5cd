// What the server says, message by message. Everything is checked before it reaches a caller.
#include <algorithm>

#include "core.h"
#include "incoming.h"

namespace talus::client {

Result<void> Core::handle(std::span<const std::byte> frame) {
  const auto message = protocol::read_message(frame);
  if (!message) return tl::unexpected{broken_protocol(std::string{protocol::describe(message.error())})};
  const wire::Message& m = **message;
  close_reason_.reset();  // it went on talking
  switch (m.body_type()) {
    case wire::Body::Chunk:
      return handle_chunk(*m.body_as_Chunk(), frame.size());
    case wire::Body::Unchanged:
      return handle_unchanged(*m.body_as_Unchanged());
    case wire::Body::UniformColumn:
      return handle_column(*m.body_as_UniformColumn());
    case wire::Body::Heights:
      return handle_heights(*m.body_as_Heights());
    case wire::Body::Error:
      return handle_error(*m.body_as_Error());
    case wire::Body::EditBroadcast:
      return handle_edit(*m.body_as_EditBroadcast());
    case wire::Body::Pong:
      return handle_pong(*m.body_as_Pong());
    case wire::Body::GoAway:
      return handle_go_away(*m.body_as_GoAway());
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

  const auto* request = chunk.id() == 0 ? nullptr : requests_.in_flight(chunk.id());
  if (chunk.id() != 0) {
    const auto* asked = request == nullptr ? nullptr : std::get_if<ChunkRequest>(request);
    if (asked == nullptr || asked->key != *key) {
      return tl::unexpected{broken_protocol("chunk " + to_string(*key) + " as the answer to request " +
                                            std::to_string(chunk.id()) + ", which did not ask for it")};
    }
  }
  // A chunk of a View that has since moved on counts as taken all the same.
  const bool wanted = request != nullptr || tracker_.shape().covers(*key);
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
  if (unchanged.id() == 0) return confirm(*key, read_hash(unchanged.hash()));
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

// A chunk of the View that this client said it holds. It may have let go of it since.
Result<void> Core::confirm(ChunkKey key, ContentHash hash) {
  if (!tracker_.shape().covers(key)) return {};
  useful_ = true;
  const auto held = tracker_.held(key);
  if (!held || held->hash != hash) {
    refetch(key);
    return {};
  }
  ++stats_.kept_chunks;
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
  // A run may claim 2^32 chunks: only the rows of the View are looked at.
  for (const auto* run : *column.runs()) {
    const ChunkRange rows = tracker_.shape().rows(column.x(), column.z(), *lod);
    const std::int64_t first = std::max<std::int64_t>(rows.first, run->first_y());
    const std::int64_t last = std::min<std::int64_t>(rows.last, run->last_y());
    for (std::int64_t y = first; y <= last; ++y) {
      const ChunkKey key{{column.x(), static_cast<std::int32_t>(y), column.z()}, *lod};
      const auto chunk = uniform(key, MaterialId{run->material()}, column.revision());
      if (!chunk) return tl::unexpected{chunk.error()};
      useful_ = true;
      ++stats_.uniform_chunks;
      deliver(*chunk);
      if (!joined_) return {};  // the callback closed the client, and the message with it
    }
  }
  return {};
}

Result<void> Core::handle_heights(const wire::Heights& heights) {
  const auto* request = requests_.in_flight(heights.id());
  const auto* asked = request == nullptr ? nullptr : std::get_if<HeightsRequest>(request);
  const std::size_t count = heights.heights_fx() == nullptr ? 0 : heights.heights_fx()->size();
  if (asked == nullptr || asked->columns.size() != count) {
    return tl::unexpected{broken_protocol(std::to_string(count) + " heights as the answer to request " +
                                          std::to_string(heights.id()) + ", which did not ask for them")};
  }
  useful_ = true;
  std::vector<std::int32_t> values;
  if (count > 0) values.assign(heights.heights_fx()->begin(), heights.heights_fx()->end());
  std::get<HeightsRequest>(requests_.take(heights.id())).handler(std::move(values));
  wake();
  return {};
}

Result<void> Core::handle_error(const wire::Error& error) {
  const ClientError why = read_error(error);
  if (error.request_id() == 0) {
    close_reason_ = why;
    report(why);
    return {};
  }
  if (requests_.in_flight(error.request_id()) == nullptr) {
    return tl::unexpected{broken_protocol("an Error about request " + std::to_string(error.request_id()) +
                                          ", which is not in flight")};
  }
  fail(requests_.take(error.request_id()), why);
  wake();
  return {};
}

// The edits themselves are not applied: the chunk is fetched anew, which is always right.
Result<void> Core::handle_edit(const wire::EditBroadcast& edit) {
  const auto key = read_key(edit.key());
  if (!key) return tl::unexpected{key.error()};
  if (!tracker_.was_delivered(*key)) return {};
  refetch(*key);
  return {};
}

void Core::refetch(ChunkKey key) {
  const auto [entry, fresh] = refetching_.try_emplace(key, false);
  if (!fresh) {  // edited again while it is on its way: once more when it has come, however many edits
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
    if (!self->joined_ || !self->tracker_.shape().covers(key)) return;
    if (chunk) {
      self->deliver(*chunk);
    } else {
      self->report(chunk.error());
    }
    if (again && self->joined_) self->refetch(key);
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
  close_reason_ = ClientError{ErrorKind::disconnected, "the server goes away: " + read_text(away.reason()),
                              std::chrono::milliseconds{away.retry_after_ms()}};
  return {};
}

void Core::deliver(const ReceivedChunk& chunk) {
  // An answer may overtake a chunk of the View, or be overtaken by one.
  if (!tracker_.deliver(chunk)) return;
  if (events_.on_chunk) events_.on_chunk(chunk);
}

}  // namespace talus::client
