// What each message of a client does.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>

#include <fmt/format.h>

#include "session/replies.h"
#include "session/session.h"

namespace talus::server {
namespace {

std::size_t tiles_of(const std::vector<terrain::BaseColumn>& columns) {
  std::set<std::pair<std::int64_t, std::int64_t>> tiles;
  for (const terrain::BaseColumn& column : columns) {
    tiles.emplace(floor_div(column.x, kChunkSize), floor_div(column.z, kChunkSize));
  }
  return tiles.size();
}

using wire::ErrorCode;

constexpr std::uint32_t kRetryAfterMs = 1000;

/// Base columns whose chunks are in the world.
bool in_world(const wire::Column2& column) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  return -limit <= column.x() && column.x() < limit && -limit <= column.z() && column.z() < limit;
}

/// The radius and level rules of View, and the limits; an error names the one that is broken.
tl::expected<View, Rejection> checked_view(const wire::View& view, const Limits& limits) {
  const auto too_large = [](std::string text) {
    return tl::make_unexpected(Rejection{ErrorCode::too_large, std::move(text)});
  };
  if (view.centre() == nullptr) {
    return tl::make_unexpected(Rejection{ErrorCode::malformed, "View.centre is missing"});
  }
  if (view.horizontal_radius() > limits.view_horizontal_radius) {
    return too_large(fmt::format("View.horizontal_radius {} is over the limit view_horizontal_radius {}",
                                 view.horizontal_radius(), limits.view_horizontal_radius));
  }
  if (view.vertical_radius() > limits.view_vertical_radius) {
    return too_large(fmt::format("View.vertical_radius {} is over the limit view_vertical_radius {}",
                                 view.vertical_radius(), limits.view_vertical_radius));
  }
  View checked;
  const wire::Voxel& centre = *view.centre();
  checked.centre = {floor_div(centre.x(), kChunkSize), floor_div(centre.y(), kChunkSize),
                    floor_div(centre.z(), kChunkSize)};
  if (view.direction() != nullptr) {
    checked.direction = {view.direction()->x(), view.direction()->y(), view.direction()->z()};
  }
  checked.horizontal_radius = view.horizontal_radius();
  checked.vertical_radius = view.vertical_radius();
  if (view.rings() != nullptr && view.rings()->size() > Lod::kMax) {
    return too_large(
        fmt::format("View.rings has {} rings; levels 1 to {} are allowed", view.rings()->size(), Lod::kMax));
  }
  int level = 0;
  int radius = checked.horizontal_radius;
  for (flatbuffers::uoffset_t i = 0; view.rings() != nullptr && i < view.rings()->size(); ++i) {
    const wire::LodRing& ring = *view.rings()->Get(i);
    if (ring.lod() <= level || ring.lod() > Lod::kMax || ring.radius() <= radius) {
      return tl::make_unexpected(Rejection{
          ErrorCode::out_of_range,
          fmt::format(
              "View.rings: level {} with radius {} after level {} with radius {}; levels are 1 to {}, "
              "and both grow from ring to ring",
              ring.lod(), ring.radius(), level, radius, Lod::kMax)});
    }
    level = ring.lod();
    radius = ring.radius();
    const std::uint64_t farthest = limits.view_horizontal_radius << level;
    if (static_cast<std::uint64_t>(radius) > farthest) {
      return too_large(
          fmt::format("View.rings: radius {} of level {} is over the limit {}", radius, level, farthest));
    }
    checked.rings.push_back({Lod::of(level), radius});
  }
  if (const std::uint64_t chunks = count_chunks(checked); chunks > limits.view_chunks) {
    return too_large(
        fmt::format("the View has {} chunks, over the limit view_chunks {}", chunks, limits.view_chunks));
  }
  return checked;
}

}  // namespace

void Session::on(const wire::Hello& hello) {
  if (greeted()) return fail(ErrorCode::unexpected, "a second Hello");
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  auto greeting = greet(hello, context_.limits, context_.access, now);
  if (!greeting) {
    const Rejection& rejection = greeting.error();
    if (rejection.denial) context_.metrics.denied(*rejection.denial).add();
    return fail(rejection.code, rejection.text, 0, rejection.why);
  }
  greeting_ = *std::move(greeting);
  credit_ = Credit{greeting_->window_bytes};
  outbox_.push_control(welcome_frame(*greeting_, context_.world, context_.limits));
}

void Session::on(const wire::View& view) {
  if (!within_rates(0)) return;
  auto checked = checked_view(view, context_.limits);
  if (!checked && checked.error().code == ErrorCode::malformed) {
    return fail(ErrorCode::malformed, checked.error().text);
  }
  if (!checked) return refuse(0, checked.error().code, checked.error().text);
  if (going_away_) return;
  if (next_view_ && !same_chunks(*next_view_, *checked)) pass_over(*next_view_);
  next_view_ = *std::move(checked);
  if (view.known() == nullptr) return;
  for (const wire::KnownChunk* chunk : *view.known()) note_known(*chunk);
}

// What left in it has left, though nobody looked: the client has dropped it.
void Session::pass_over(const View& view) {
  if (unseen_views_.size() == kUnseenViews) unseen_views_ = {AreaOfInterest{}};
  unseen_views_.emplace_back(view);
}

void Session::note_known(const wire::KnownChunk& chunk) {
  const wire::ChunkKey& at = chunk.key();
  const auto lod = Lod::checked(at.lod());
  if (!lod || known_.size() >= kKnownChunks) return;
  known_[{{at.x(), at.y(), at.z()}, *lod}] = {chunk.hash().low(), chunk.hash().high()};
}

void Session::on(const wire::GetChunks& get) {
  if (get.requests() == nullptr) return;
  for (const wire::ChunkRequest* request : *get.requests()) {
    if (closing()) return;
    on(*request);
  }
}

void Session::on(const wire::ChunkRequest& request) {
  if (request.id() == 0) return fail(ErrorCode::malformed, "ChunkRequest.id is 0; ids begin at 1");
  if (!admit(request.id())) return;
  const wire::ChunkKey& at = request.key();
  const auto lod = Lod::checked(at.lod());
  if (!lod) return refuse(request.id(), ErrorCode::out_of_range, lod.error().message);
  const auto key = checked_chunk(at.x(), at.y(), at.z(), *lod);
  if (!key) return refuse(request.id(), ErrorCode::out_of_range, key.error().message);
  std::optional<ContentHash> known;
  if (request.has_known()) known = ContentHash{request.known().low(), request.known().high()};
  requests_.add_chunk(request.id(), {*key, known});
}

void Session::on(const wire::Cancel& cancel) {
  if (cancel.ids() == nullptr) return;
  std::unordered_set<std::uint32_t> cancelled;
  for (const std::uint32_t id : *cancel.ids()) {
    if (!requests_.contains(id)) continue;  // answered already, or never asked
    if (const auto* request = requests_.chunk(id)) {
      if (const auto found = awaited_.find(request->key); found != awaited_.end()) {
        std::erase(found->second.requests, id);
        stop_awaiting(found->first, found->second);
      }
    } else if (const auto ticket = requests_.heights_ticket(id)) {
      context_.chunks.cancel_heights(*client_, *ticket);
    }
    requests_.erase(id);
    cancelled.insert(id);
    refuse(id, ErrorCode::cancelled, "cancelled");
  }
  if (cancelled.empty()) return;
  outbox_.drop_chunks([&](const Outbox::Entry& entry) { return cancelled.contains(entry.request_id); });
}

void Session::on(const wire::GetHeights& get) {
  if (get.id() == 0) return fail(ErrorCode::malformed, "GetHeights.id is 0; ids begin at 1");
  if (!admit(get.id())) return;
  if (!context_.chunks.memory().takes_work()) {
    return refuse(get.id(), ErrorCode::overloaded, kNoMemory, kRetryAfterMs);
  }
  const std::size_t count = get.columns() == nullptr ? 0 : get.columns()->size();
  if (count > context_.limits.heights_per_request) {
    return refuse(get.id(), ErrorCode::too_large,
                  fmt::format("GetHeights has {} columns, over the limit heights_per_request {}", count,
                              context_.limits.heights_per_request));
  }
  const std::uint64_t ticket = (++heights_asked_ << 32) | get.id();
  HeightsTask task{client_, ticket, {}};
  task.columns.reserve(count);
  for (flatbuffers::uoffset_t i = 0; i < count; ++i) {
    const wire::Column2& column = *get.columns()->Get(i);
    if (!in_world(column)) {
      return refuse(get.id(), ErrorCode::out_of_range,
                    fmt::format("column ({}, {}) is outside the world; x and z are -2^36 to 2^36 - 1",
                                column.x(), column.z()));
    }
    task.columns.push_back({column.x(), column.z()});
  }
  if (const std::size_t tiles = tiles_of(task.columns); tiles > context_.limits.height_tiles_per_request) {
    return refuse(get.id(), ErrorCode::too_large,
                  fmt::format("GetHeights reaches into {} tiles of 32 x 32 columns; in this world at most {}",
                              tiles, context_.limits.height_tiles_per_request));
  }
  constexpr std::size_t kTaskBytes = 256;
  requests_.add_heights(get.id(), ticket,
                        kTaskBytes + count * (sizeof(terrain::BaseColumn) + sizeof(std::int32_t)));
  context_.chunks.submit_heights(std::move(task));
}

void Session::on(const wire::Credit& credit) {
  if (auto taken = credit_.taken(credit.total_bytes()); !taken) {
    fail(ErrorCode::malformed, taken.error().message);
  }
}

void Session::on(const wire::Edit& edit) {
  if (!within_rates(edit.id())) return;
  if (!greeting_->grant.rights.has(Right::edit)) {
    return refuse(edit.id(), ErrorCode::forbidden, "this session has no right to edit; its token gives none");
  }
  refuse(edit.id(), ErrorCode::unsupported, "this server does not take edits yet");
}

void Session::on(const wire::Ping& ping) {
  if (!within_rates(0)) return;
  outbox_.push_control(pong_frame(ping.nonce()));
}

bool Session::within_rates(std::uint32_t id) {
  const auto refusal = rates_.refuse_request(received_at_);
  if (!refusal) return true;
  const auto retry_after_ms =
      static_cast<std::uint32_t>(std::chrono::ceil<std::chrono::milliseconds>(refusal->wait).count());
  const std::string_view rate = kRateNames[static_cast<std::size_t>(refusal->kind)];
  if (refusal->flooding) {
    fail(ErrorCode::overloaded, fmt::format("flooding: refused by rates.{} and still asking", rate),
         retry_after_ms);
  } else {
    refuse(id, ErrorCode::overloaded, fmt::format("over rates.{}", rate), retry_after_ms);
  }
  return false;
}

bool Session::admit(std::uint32_t id) {
  const bool open = requests_.contains(id);
  if (!within_rates(open ? 0 : id)) return false;
  if (open) {
    refuse(id, ErrorCode::duplicate_id, fmt::format("request {} is still in flight", id));
    return false;
  }
  if (going_away_) {
    refuse(id, ErrorCode::overloaded, "this server is about to end", kRetryAfterMs);
    return false;
  }
  if (requests_.size() >= context_.limits.requests_in_flight) {
    refuse(id, ErrorCode::too_many_requests,
           fmt::format("{} requests are in flight, the limit requests_in_flight", requests_.size()),
           kRetryAfterMs);
    return false;
  }
  return true;
}

void Session::refuse(std::uint32_t request_id, ErrorCode code, std::string_view text,
                     std::uint32_t retry_after_ms) {
  context_.metrics.error(code).add();
  outbox_.push_control(error_frame(code, text, request_id, retry_after_ms));
}

}  // namespace talus::server
