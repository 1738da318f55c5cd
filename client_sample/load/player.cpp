#include "player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <asio/post.hpp>
#include <glm/geometric.hpp>

#include "tally.h"
#include "worker.h"

namespace talus::load {
namespace {

constexpr double kWalkingSpeed = 5;  // voxels a second
constexpr double kFlyingSpeed = 20;
constexpr double kTurned = 0.966;  // cosine of 15 degrees, the smallest turn that sends a View

MotionPlan motion_plan(const Plan& plan, const ClientProfile& profile) {
  const Options& options = plan.options;
  const bool walks = profile.role == Role::walk || profile.role == Role::slow;
  MotionPlan motion;
  motion.model = profile.role;
  motion.origin = plan.origins[profile.role == Role::swarm && options.groups == 0 ? 0 : profile.group];
  motion.heading = Random{options.seed ^ 0xC0FFEE, profile.group}.between(0, 6.283185307179586);
  motion.speed = options.speed.value_or(walks ? kWalkingSpeed : kFlyingSpeed);
  motion.dwell_seconds = options.dwell_seconds;
  motion.trace = plan.trace;
  return motion;
}

VoxelPos voxel_at(const glm::dvec3& place) {
  const auto whole = [](double at) { return static_cast<std::int64_t>(std::floor(at)); };
  return {whole(place.x), whole(place.y), whole(place.z)};
}

glm::i64vec3 chunk_at(const glm::dvec3& place) {
  const VoxelPos voxel = voxel_at(place);
  return {floor_div(voxel.x, kChunkSize), floor_div(voxel.y, kChunkSize), floor_div(voxel.z, kChunkSize)};
}

std::optional<ChunkKey> key_of(const wire::ChunkKey* key) {
  const auto lod = key == nullptr ? std::nullopt : std::optional{Lod::checked(key->lod())};
  if (!lod || !*lod) return std::nullopt;
  return ChunkKey{{key->x(), key->y(), key->z()}, **lod};
}

bool turned(const glm::dvec3& from, const glm::dvec3& to) {
  const double lengths = glm::length(from) * glm::length(to);
  return lengths > 0 && glm::dot(from, to) < kTurned * lengths;
}

}  // namespace

Player::Player(Worker& worker, const ClientProfile& profile)
    : SimulatedClient{worker, profile},
      motion_{make_motion(motion_plan(worker.plan(), profile),
                          Random{worker.plan().options.seed ^ 0xBEEF, profile.number})},
      tick_{std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double>(1 / worker.plan().options.tick_hz))},
      phase_{std::chrono::duration_cast<Clock::duration>(
          tick_ * Random{worker.plan().options.seed ^ 0x71C5, profile.number}.part())} {}

void Player::joined(Time now) {
  began_ = std::min(began_, join_due());
  pending_ = {};
  rings_ = {};
  proofs_.begin();
  ++connection_;
  revisions_ = {};
  near_.measure_from(worker().measure_from());
  first_to_come_ = true;
  move_view(now, now, true);
  // The phase of its ticks follows from the time when it should first have joined, however late the server
  // is.
  const Time first_tick = began_ + phase_;
  tick_due_ = motion_->moves() ? first_tick + tick_ * ((now - first_tick + tick_) / tick_) : Time::max();
}

void Player::disconnected(bool lost) {
  tick_due_ = Time::max();
  const Time now = Clock::now();
  near_.stop(now);
  record_near();
  if (lost && !lost_) lost_ = now;
  if (lost && !lost_all_) lost_all_ = lost_since().value_or(now);
  for (const PendingChunks::MissedChunk& missed : pending_.give_up()) {
    if (lost) record_missed(missed, now);
  }
}

void Player::act_joined(Time now) {
  for (; tick_due_ <= now; tick_due_ += tick_) {
    if (worker().finishing()) {
      tick_due_ = Time::max();
      return;
    }
    move_view(tick_due_, now, false);
  }
}

void Player::move_view(Time due, Time now, bool first) {
  const Pose pose = motion_->at(std::chrono::duration<double>(due - began_).count());
  const glm::i64vec3 centre = chunk_at(pose.place);
  const bool moved = first || centre != chunk_at(pose_.place);
  if (!moved && !turned(pose_.direction, pose.direction) && !worker().plan().options.every_tick) return;
  pose_ = pose;
  send_view(pose);
  if (!moved) return;
  const Options& options = worker().plan().options;
  const Time jumped_before = pending_.jumped();
  const Box before = pending_.box();
  for (const PendingChunks::MissedChunk& missed :
       pending_.move_to(box_around(centre, options.radius, options.vertical), centre, due, now)) {
    record_missed(missed, due);
  }
  revisions_.forget([&](const ChunkKey& key) {
    return key.lod == Lod{} ? !pending_.box().contains(to_vec(key.coord)) : !rings_.covers(key);
  });
  if (worker().plan().published != nullptr) {
    make_view();
  } else {
    near_.step(due, pending_);
    record_near();
  }
  count_new_patches(before, due);
  if (pending_.jumped() != jumped_before) {
    full_to_come_ = true;
    horizon_to_come_ = options.horizon != 0;
    full_since_ = first ? join_due() : due;
  }
}

void Player::record_near() {
  for (const NearWaits::Wait& wait : near_.take_done()) {
    if (worker().counts(wait.since)) tally().near.record(wait.time);
  }
  tally().longest_without = std::max(tally().longest_without, near_.longest_without());
}

// Counts at level 0, by the squares of terrain that a server generates at once.
void Player::count_new_patches(const Box& before, Time due) {
  const int tiles = worker().plan().options.patch_tiles;
  if (tiles == 0 || !worker().counts(due)) return;
  const auto squares = [tiles](std::int64_t from, std::int64_t to) {
    return from > to ? 0 : floor_div(to, tiles) - floor_div(from, tiles) + 1;
  };
  const Box& now = pending_.box();
  const std::int64_t all = squares(now.low.x, now.high.x) * squares(now.low.z, now.high.z);
  // Squares of both Views are not new.
  const auto common = [&](std::int64_t low, std::int64_t high, std::int64_t old_low, std::int64_t old_high) {
    if (old_low > old_high) return std::int64_t{0};
    const std::int64_t first = std::max(floor_div(low, tiles), floor_div(old_low, tiles));
    const std::int64_t last = std::min(floor_div(high, tiles), floor_div(old_high, tiles));
    return std::max<std::int64_t>(0, last - first + 1);
  };
  const std::int64_t held = common(now.low.x, now.high.x, before.low.x, before.high.x) *
                            common(now.low.z, now.high.z, before.low.z, before.high.z);
  tally().new_patches += static_cast<std::uint64_t>(all - held);
}

void Player::send_view(const Pose& pose) {
  const client::View view = worker().plan().view_at(voxel_at(pose.place), pose.direction);
  send(protocol::make_frame([&](auto& b) {
    const wire::Voxel centre{view.centre.x, view.centre.y, view.centre.z};
    const wire::Direction direction{view.direction.x, view.direction.y, view.direction.z};
    std::vector<wire::LodRing> rings;
    for (const client::LodRing& ring : view.rings)
      rings.emplace_back(static_cast<std::uint8_t>(ring.lod.value()), ring.radius);
    const auto list = rings.empty() ? 0 : b.CreateVectorOfStructs(rings);
    const bool makes = worker().plan().published != nullptr;
    if (makes && ++view_number_ == 0) ++view_number_;  // 0 is not a valid number
    return wire::CreateView(b, &centre, &direction, view.horizontal_radius, view.vertical_radius, list, 0,
                            makes ? view_number_ : 0, view.horizon, makes);
  }));
  if (!view.rings.empty()) rings_.move_to(client::ViewShape{view, worker().plan().world.heights()});
}

void Player::make_view() {
  const std::size_t made = pending_.make_all() + rings_.make_all();
  tally().made += made;
  Random patches{worker().plan().options.seed ^ 0xF00F, profile().number * 100'003ULL + tally().made};
  for (std::size_t due = proofs_.made(made); due > 0; due -= std::min(due, client::kProofsTogether)) {
    const std::size_t wanted = std::min(due, client::kProofsTogether);
    const Box& box = pending_.box();
    const auto somewhere = [&](std::int64_t low, std::int64_t high) {
      return low + static_cast<std::int64_t>(patches.below(static_cast<std::uint64_t>(high - low + 1)));
    };
    const std::int64_t x = somewhere(box.low.x, box.high.x);
    const std::int64_t z = somewhere(box.low.z, box.high.z);
    std::vector<ChunkKey> keys;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(wanted); ++i) {  // columns of one patch
      for (std::int64_t y = box.low.y; y <= box.high.y; ++y) {
        const glm::i64vec3 at{(x & ~3) + ((x + i) & 3), y, z};
        if (!box.contains(at)) continue;
        keys.push_back(
            {{static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)},
             Lod{}});
      }
    }
    worker().plan().published->make_mixed(
        std::move(keys), [this, wanted, &io = worker().io(), here = std::weak_ptr<bool>{is_here_},
                          connection = connection_](std::vector<client::MadeChunk> mixed) {
          asio::post(io, [this, wanted, here, connection, mixed = std::move(mixed)] {
            if (!here.expired()) prove(connection, mixed, wanted);
          });
        });
  }
}

void Player::prove(std::uint64_t connection, std::span<const client::MadeChunk> mixed, std::size_t wanted) {
  if (connection != connection_ || !is_joined() || mixed.empty()) return;
  std::vector<wire::ChunkRequest> requests;
  for (const client::MadeChunk& chunk : mixed.first(std::min(wanted, mixed.size()))) {
    ++tally().proofs;
    const wire::ChunkKey key{chunk.key.coord.x, chunk.key.coord.y, chunk.key.coord.z, 0};
    requests.emplace_back(proofs_.sent({chunk.key, chunk.hash}), key, true,
                          wire::Hash128{chunk.hash.low, chunk.hash.high});
  }
  send(protocol::make_frame(
      [&](auto& b) { return wire::CreateGetChunks(b, b.CreateVectorOfStructs(requests)); }));
}

void Player::judge(const Proofs::Proof& proof, std::optional<ContentHash> found) {
  if (!found || *found == proof.hash) return;
  ++tally().failed_proofs;
  wrong(tally().bad_chunks, fmt::format("chunk {} differs from the one made here", to_string(proof.key)));
}

void Player::take(const wire::ViewComplete& complete) {
  if (complete.number() != view_number_) return;
  const Time now = Clock::now();
  if (std::exchange(first_to_come_, false)) tally().first_chunk.record(now - join_due());
  if (lost_) tally().returns.record(now - *std::exchange(lost_, std::nullopt));
  record_if_full(now);
}

void Player::record_missed(const PendingChunks::MissedChunk& missed, Time now) {
  if (missed.returned) {
    ++tally().unconfirmed;
    return;
  }
  ++tally().missed;
  if (worker().counts(missed.since)) (missed.join ? tally().join : tally().travel).record(now - missed.since);
}

void Player::take(const wire::Chunk& chunk) {
  if (const auto proof = proofs_.answered(chunk.id())) {
    const bool as_generated = chunk.revision() == 0 && chunk.hash() != nullptr;
    return judge(*proof, as_generated ? std::optional{ContentHash{chunk.hash()->low(), chunk.hash()->high()}}
                                      : std::nullopt);
  }
  const auto key = chunk.id() == 0 ? key_of(chunk.key()) : std::nullopt;
  if (!key) return wrong(tally().outside, "a chunk for a request, or without a key");
  (void)verify(chunk);
  arrive(*key, Clock::now(), {true, chunk.revision()});
}

void Player::take(const wire::Unchanged& unchanged) {
  if (proofs_.answered(unchanged.id())) return;
  const auto key = unchanged.id() == 0 ? key_of(unchanged.key()) : std::nullopt;
  if (!key) return wrong(tally().outside, "an Unchanged for a request, or without a key");
  arrive(*key, Clock::now(), {true, unchanged.revision()});
}

void Player::take(const wire::EditBroadcast& broadcast) {
  const auto key = key_of(broadcast.key());
  if (!key) return wrong(tally().outside, "an EditBroadcast without a key");
  revisions_.raise(*key, broadcast.revision());
}

void Player::take(const wire::UniformColumn& column) {
  const auto lod = Lod::checked(column.lod());
  if (!lod || column.runs() == nullptr) return;
  const Time now = Clock::now();
  const Box& box = pending_.box();
  const ChunkRange rows =
      *lod == Lod{} ? ChunkRange{box.low.y, box.high.y} : rings_.rows(column.x(), column.z(), *lod);
  const auto& materials = worker().plan().world.materials;
  for (const wire::UniformRun* run : *column.runs()) {
    const bool known = std::any_of(materials.begin(), materials.end(), [&](const client::Material& material) {
      return to_integer(material.id) == run->material();
    });
    if (!known)
      wrong(tally().bad_chunks, fmt::format("a UniformColumn of the unknown material {}", run->material()));
    const ChunkRange named = overlap(rows, {run->first_y(), run->last_y()});
    for (std::int64_t y = named.first; y <= named.last; ++y) {
      arrive({{column.x(), static_cast<std::int32_t>(y), column.z()}, *lod}, now, {});
    }
  }
}

bool Player::came(PendingChunks::Verdict verdict, ChunkKey chunk, const ArrivalForm& how) {
  const bool is_newer = revisions_.raise(chunk, how.revision);
  // A run may cover rows already held, without meaning that they were sent.
  switch (verdict) {
    case PendingChunks::Verdict::stale:
      ++tally().stale;
      return false;
    case PendingChunks::Verdict::repeated:
      if (how.alone) ++tally().repeated;
      return false;
    case PendingChunks::Verdict::duplicate:
      if (is_newer) {
        ++tally().updated;
      } else if (how.alone) {
        wrong(tally().duplicates,
              fmt::format("chunk {} came twice, of revision {}", to_string(chunk), how.revision));
      }
      return false;
    case PendingChunks::Verdict::outside:
      if (how.alone) wrong(tally().outside, fmt::format("chunk {} is in no View of it", to_string(chunk)));
      return false;
    case PendingChunks::Verdict::came:
      break;
  }
  if (!how.alone) {
    ++tally().uniform;
    Live::add(worker().live().uniform, 1);
  }
  return true;
}

void Player::arrive(ChunkKey chunk, Time now, const ArrivalForm& how) {
  if (chunk.lod == Lod{}) {
    arrive_near(chunk.coord, now, how);
  } else if (came(rings_.arrive(chunk), chunk, how)) {
    record_if_full(now);
  }
}

void Player::arrive_near(ChunkCoord chunk, Time now, const ArrivalForm& how) {
  const PendingChunks::Arrival arrival = pending_.arrive(chunk);
  if (!came(arrival.verdict, {chunk, Lod{}}, how)) return;
  if (how.alone && arrival.ring_gap >= 0) {
    ++tally().ordered;
    tally().worst_ring_gap = std::max(tally().worst_ring_gap, arrival.ring_gap);
    if (arrival.ring_gap > worker().plan().options.ring_tolerance) ++tally().disordered;
  }
  if (worker().counts(arrival.since)) {
    (arrival.join ? tally().join : tally().travel).record(now - arrival.since);
    ++tally().late_steps[std::min<std::size_t>(arrival.steps_late, tally().late_steps.size() - 1)];
  }
  near_.came(now, pending_);
  record_near();
  if (lost_ && pending_.near_waiting() == 0)
    tally().returns.record(now - *std::exchange(lost_, std::nullopt));
  if (std::exchange(first_to_come_, false)) tally().first_chunk.record(now - join_due());
  record_if_full(now);
}

void Player::record_if_full(Time now) {
  if (pending_.waiting() > 0) return;
  if (std::exchange(full_to_come_, false)) tally().full_view.record(now - full_since_);
  if (lost_all_) tally().full_again.record(now - *std::exchange(lost_all_, std::nullopt));
  if (rings_.waiting() > 0) return;
  if (std::exchange(horizon_to_come_, false)) tally().horizon.record(now - full_since_);
}

bool Player::satisfied() const {
  return !is_joined() || pending_.waiting() + rings_.waiting() == 0 ||
         role() == Role::slow;  // may take hours
}

void Player::give_up() {
  const Time now = Clock::now();
  near_.stop(now);
  record_near();
  for (const PendingChunks::MissedChunk& missed : pending_.give_up()) {
    record_missed(missed, now);
    if (missed.returned || role() == Role::slow) continue;
    --tally().missed;
    never_came("a chunk of its View");
  }
  if (role() == Role::slow) return;
  for (std::size_t i = 0; i < rings_.waiting(); ++i) never_came("a chunk of its View's rings");
}

}  // namespace talus::load
