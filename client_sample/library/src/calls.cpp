// Calls from the application.
#include <algorithm>

#include <asio/post.hpp>

#include <talus/protocol/limits.h>

#include "core.h"
#include "outgoing.h"

namespace talus::client {
namespace {

const ClientError kNotConnected{ErrorKind::not_connected, "call connect() first", {}};

ClientError beyond(const std::string& what, std::uint64_t asked, std::uint64_t limit) {
  return {
      ErrorKind::out_of_range,
      what + " " + std::to_string(asked) + " is more than this server allows (" + std::to_string(limit) + ")",
      {}};
}

Result<void> check_heights(const HeightsRequest& request, const WorldInfo& world) {
  const std::size_t most =
      std::min<std::size_t>(world.limits.heights_per_request, columns_per_frame(world.limits.frame_bytes));
  if (request.columns.size() > most) {
    return tl::unexpected{beyond("a request for heights of columns:", request.columns.size(), most)};
  }
  if (request.fields.size() > protocol::kMaxFieldsPerRequest) {
    return tl::unexpected{
        beyond("a request for fields:", request.fields.size(), protocol::kMaxFieldsPerRequest)};
  }
  if (request.looks && world.looks.empty()) {
    return tl::unexpected{ClientError{ErrorKind::out_of_range, "this server does not send looks", {}}};
  }
  for (const std::string& field : request.fields) {
    if (std::find(world.fields.begin(), world.fields.end(), field) == world.fields.end()) {
      return tl::unexpected{
          ClientError{ErrorKind::out_of_range, "this world has no field '" + field + "'", {}}};
    }
  }
  return {};
}

}  // namespace

Result<void> check_view(const View& view, const WorldInfo& world) {
  const ServerLimits& limits = world.limits;
  if (view.horizon && !limits.view_horizon) return tl::unexpected{kNoHorizon};
  if (view.horizontal_radius > limits.view_horizontal_radius) {
    return tl::unexpected{
        beyond("a View of horizontal radius", view.horizontal_radius, limits.view_horizontal_radius)};
  }
  if (view.vertical_radius > limits.view_vertical_radius) {
    return tl::unexpected{
        beyond("a View of vertical radius", view.vertical_radius, limits.view_vertical_radius)};
  }
  Lod level;
  std::uint16_t radius = view.horizontal_radius;
  for (const auto& ring : view.rings) {
    if (ring.lod <= level || ring.radius <= radius) {
      return tl::unexpected{ClientError{
          ErrorKind::out_of_range, "a View's rings must grow in level and in radius, from level 1 on", {}}};
    }
    level = ring.lod;
    radius = ring.radius;
    const std::uint32_t farthest = std::uint32_t{limits.view_horizontal_radius} << level.value();
    if (radius > farthest) {
      return tl::unexpected{beyond(
          "a View with a ring of level " + std::to_string(level.value()) + " and radius", radius, farthest)};
    }
  }
  const auto chunks = ViewShape{view, world.heights()}.uncut_count();
  if (chunks > limits.view_chunks) {
    return tl::unexpected{beyond("a View whose chunks number", chunks, limits.view_chunks)};
  }
  return {};
}

RequestId Core::get(ChunkKey key, std::optional<ContentHash> known,
                    std::function<void(Result<ReceivedChunk>)> handler) {
  const auto& [x, y, z] = key.coord;
  const auto checked = checked_chunk(x, y, z, key.lod);
  if (!checked || !running_ || !world_) {
    const ClientError error =
        checked ? kNotConnected : ClientError{ErrorKind::out_of_range, checked.error().message, {}};
    asio::post(executor_, [handler = std::move(handler), error] { handler(tl::unexpected{error}); });
    return RequestId{};
  }
  const auto id = requests_.add(ChunkRequest{key, known, std::move(handler)});
  wake();
  return RequestId{id};
}

void Core::cancel(RequestId request) {
  const auto id = static_cast<std::uint32_t>(request);
  switch (requests_.cancel(id)) {
    case Requests::CancelResult::unknown:
      return;
    case Requests::CancelResult::in_flight:
      cancels_to_send_.push_back(id);
      wake();
      return;
    case Requests::CancelResult::waiting:
      asio::post(executor_, [taken = requests_.take(id)] {
        fail(taken, ClientError{ErrorKind::cancelled, "cancelled", {}});
      });
  }
}

void Core::get_heights(std::vector<Column> columns,
                       std::function<void(Result<std::vector<std::int32_t>>)> handler) {
  add(HeightsRequest{
      std::move(columns), false, {}, [handler = std::move(handler)](auto found) {
        handler(std::move(found).map([](ColumnPlaces&& places) { return std::move(places.heights_fx); }));
      }});
}

void Core::get_places(std::vector<Column> columns, std::vector<std::string> fields,
                      std::function<void(Result<ColumnPlaces>)> handler) {
  add(HeightsRequest{std::move(columns), true, std::move(fields), std::move(handler)});
}

void Core::add(HeightsRequest request) {
  const Result<void> checked =
      running_ && world_ ? check_heights(request, *world_) : tl::unexpected{kNotConnected};
  if (!checked) {
    asio::post(executor_, [request = std::move(request), error = checked.error()] {
      request.handler(tl::unexpected{error});
    });
    return;
  }
  (void)requests_.add(std::move(request));
  wake();
}

Result<void> Core::set_view(const View& view) {
  if (!running_ || !world_) return tl::unexpected{kNotConnected};
  if (auto checked = check_view(view, *world_); !checked) return checked;
  if (tracker_.view() && *tracker_.view() == view) return {};
  const auto self = shared_from_this();
  const Generation mine = generation_;
  const auto left = tracker_.replace(view, world_->heights());
  view_to_send_ = true;
  if (view_sent_) left_since_view_sent_.insert(left.begin(), left.end());
  if (events_.on_left_view) left_to_tell_.insert(left.begin(), left.end());
  wake();
  tell_left(mine);
  if (mine == generation_) bring_back(mine);
  if (mine == generation_ && local_ != nullptr) local_->view_changed();
  return {};
}

// A callback may set another View: the nested call then reports all remaining chunks, and this loop ends.
void Core::tell_left(Generation mine) {
  while (mine == generation_ && !left_to_tell_.empty()) {
    events_.on_left_view(left_to_tell_.extract(left_to_tell_.begin()).value());
  }
}

// The server does not know that these chunks left, so it will not send them again.
void Core::bring_back(Generation mine) {
  std::vector<ChunkKey> back;
  for (const ChunkKey& key : left_since_view_sent_) {
    if (tracker_.shape().covers(key)) back.push_back(key);
  }
  for (const ChunkKey& key : back) {
    // The previous callback may have set another View, which restored or dropped this chunk.
    if (!tracker_.shape().covers(key) || left_since_view_sent_.erase(key) == 0) continue;
    if (const auto held = tracker_.held(key)) {
      ++stats_.kept_chunks;
      deliver(*held);
      if (mine != generation_) return;
    } else {
      refetch(key);
    }
  }
}

void Core::ping(PingHandler handler) {
  if (!joined_) {
    asio::post(executor_, [handler = std::move(handler)] { handler(tl::unexpected{kNotConnected}); });
    return;
  }
  const std::uint64_t nonce = ++last_nonce_;
  open_pings_.emplace(nonce, OpenPing{options_.clock->now(), std::move(handler)});
  pings_to_send_.push_back(nonce);
  wake();
}

}  // namespace talus::client
