#include "requester.h"

#include <algorithm>

#include <fmt/format.h>

#include "tally.h"
#include "worker.h"

namespace talus::load {
namespace {

constexpr std::size_t kEnvelopeBytes = 128;

}  // namespace

Requester::Requester(Worker& worker, const ClientProfile& profile) : SimulatedClient{worker, profile} {
  const Plan& plan = worker.plan();
  slots_.resize(profile.role == Role::greedy ? plan.world.limits.requests_in_flight : plan.options.in_flight);
}

void Requester::joined(Time /*now*/) {
  to_ask_.clear();
  ask_due_ = Time::max();
  for (std::uint32_t id = 1; id <= slots_.size(); ++id) to_ask_.push_back(id);
  ask();
}

void Requester::disconnected(bool /*lost*/) {
  for (Slot& slot : slots_) slot.open = false;
  open_ = 0;
}

ChunkKey Requester::next_key() {
  const Plan& plan = worker().plan();
  if (role() == Role::requests) return plan.fixed_set[random().below(plan.fixed_set.size())];
  // Fresh ground, row by row, far from other groups.
  constexpr std::int64_t kRow = 256;
  const glm::dvec3& origin = plan.origins[profile().group];
  const auto chunk = [](double voxel) { return static_cast<std::int64_t>(voxel) / kChunkSize; };
  const std::int64_t at = swept_++;
  return {{static_cast<std::int32_t>(chunk(origin.x) + at % kRow), static_cast<std::int32_t>(chunk(origin.y)),
           static_cast<std::int32_t>(chunk(origin.z) + 4096 + at / kRow)},
          Lod{}};
}

void Requester::ask() {
  if (worker().finishing() || to_ask_.empty()) return;
  const std::size_t most = (server_frame_bytes() - kEnvelopeBytes) / sizeof(wire::ChunkRequest);
  const Time now = Clock::now();
  for (std::size_t from = 0; from < to_ask_.size(); from += most) {
    std::vector<wire::ChunkRequest> requests;
    for (std::size_t i = from; i < std::min(to_ask_.size(), from + most); ++i) {
      const ChunkKey key = next_key();
      slots_[to_ask_[i] - 1] = {key, now, true};
      requests.emplace_back(to_ask_[i], wire::ChunkKey{key.coord.x, key.coord.y, key.coord.z, 0}, false,
                            wire::Hash128{});
    }
    open_ += requests.size();
    send(protocol::make_frame(
        [&](auto& b) { return wire::CreateGetChunks(b, b.CreateVectorOfStructs(requests)); }));
  }
  to_ask_.clear();
}

Requester::Slot* Requester::close(std::uint32_t id) {
  if (id == 0 || id > slots_.size() || !slots_[id - 1].open) return nullptr;
  slots_[id - 1].open = false;
  --open_;
  to_ask_.push_back(id);
  return &slots_[id - 1];
}

void Requester::take(const wire::Chunk& chunk) {
  const Slot* const slot = close(chunk.id());
  if (slot == nullptr)
    return wrong(tally().outside, fmt::format("an answer to {}, which is not open", chunk.id()));
  const auto* key = chunk.key();
  if (key == nullptr || ChunkCoord{key->x(), key->y(), key->z()} != slot->key.coord || key->lod() != 0) {
    return wrong(tally().outside, fmt::format("request {} for {} was answered with another chunk", chunk.id(),
                                              to_string(slot->key)));
  }
  (void)verify(chunk);
  if (worker().counts(slot->asked)) tally().requests.record(Clock::now() - slot->asked);
}

void Requester::take(const wire::Error& error) {
  (void)close(error.request_id());
  const std::chrono::milliseconds wait{error.retry_after_ms()};
  if (role() == Role::greedy || wait.count() == 0) return;
  const Time due = Clock::now() + wait;
  ask_due_ = ask_due_ == Time::max() ? due : std::max(ask_due_, due);
}

void Requester::taken_all() {
  if (ask_due_ == Time::max()) ask();
}

void Requester::act_joined(Time now) {
  if (ask_due_ > now) return;
  ask_due_ = Time::max();
  ask();
}

void Requester::give_up() {
  if (role() == Role::greedy) return;
  for (const Slot& slot : slots_) {
    if (slot.open) never_came(fmt::format("the answer to a request for {}", to_string(slot.key)));
  }
}

}  // namespace talus::load
