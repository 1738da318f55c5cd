#include "limits/memory/memory_budget.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

// Maximum number of sessions that give way at once.
constexpr int kMaxGiveWay = 16;

}  // namespace

MemoryBudget::MemoryBudget(std::uint64_t limit_bytes, std::size_t threads)
    : limit_{limit_bytes},
      jobs_{limit_bytes / 4 * 3, limit_bytes / 8 * 5, limit_bytes / 8 * 7},
      work_{limit_bytes / 4 * 3, limit_bytes / 8 * 5, limit_bytes / 16 * 13},
      connections_{limit_bytes / 8 * 5, limit_bytes / 2, limit_bytes / 8 * 5} {
  set(MemoryUse::program, program_bytes(threads));
}

std::uint64_t MemoryBudget::used(MemoryUse use) const {
  const std::int64_t bytes = used_[static_cast<std::size_t>(use)].load();
  return static_cast<std::uint64_t>(std::max<std::int64_t>(0, bytes));
}

std::uint64_t MemoryBudget::beside_caches() const {
  return used(MemoryUse::program) + used(MemoryUse::sessions) + used(MemoryUse::jobs) +
         used(MemoryUse::generators) + used(MemoryUse::edits) + used(MemoryUse::store);
}

std::uint64_t MemoryBudget::over(std::uint64_t bytes) const {
  const std::uint64_t used = beside_caches();
  return used - std::min(used, bytes + shares_.leaving());
}

bool MemoryBudget::make_room(FlowId flow, std::uint64_t bytes, std::uint64_t level, Clock::time_point now) {
  bool made = shares_.leaving() > 0;
  std::uint64_t wanted = over(level - std::min(level, bytes));
  // Even if there is room: the gate is closed until use is well below the level.
  if (!made) wanted = std::max<std::uint64_t>(wanted, 1);
  for (int i = 0; i < kMaxGiveWay && wanted > 0; ++i) {
    const auto held = shares_.make_room(flow, bytes, limit_ / kFlows, now);
    if (!held) return i > 0;
    made = true;
    wanted -= std::min(wanted, *held);
  }
  return made;
}

std::uint64_t MemoryBudget::used() const {
  return beside_caches() + used(MemoryUse::chunk_cache) + used(MemoryUse::patch_cache) +
         used(MemoryUse::edit_cache) + used(MemoryUse::column_cache);
}

void MemoryBudget::add(MemoryUse use, std::int64_t bytes) {
  used_[static_cast<std::size_t>(use)].fetch_add(bytes);
  update_gates();
}

void MemoryBudget::set(MemoryUse use, std::uint64_t bytes) {
  used_[static_cast<std::size_t>(use)].store(static_cast<std::int64_t>(bytes));
  update_gates();
}

void MemoryBudget::update_gates() {
  if (limit_ == 0) return;
  const auto level = [this] { return beside_caches(); };
  const auto settled = [this] { return used(MemoryUse::jobs) == 0; };
  // Sessions end at some time; memory of edits stays.
  connections_.update(level, [this] { return used(MemoryUse::sessions) == 0; });
  work_.update(level, settled);
  if (!jobs_.update(level, settled)) return;
  const std::lock_guard lock{resumed_mutex_};
  if (resumed_) resumed_();
}

void MemoryBudget::when_jobs_resume(std::function<void()> resumed) {
  const std::lock_guard lock{resumed_mutex_};
  resumed_ = std::move(resumed);
}

std::uint64_t MemoryBudget::left_by(std::uint64_t bytes) const {
  const std::uint64_t most = limit_ / 8 * 7;
  return most - std::min(most, bytes);
}

std::uint64_t MemoryBudget::for_caches(std::uint64_t wanted) const {
  if (limit_ == 0) return wanted;
  const std::uint64_t edits = used(MemoryUse::edit_cache);
  const std::uint64_t columns = used(MemoryUse::column_cache);
  // The minimum of all caches is a 16th, of which the caches of edits and of columns have a 64th each.
  const std::uint64_t least = limit_ / 16 - std::min(edits, limit_ / 64) - std::min(columns, limit_ / 64);
  return std::min(wanted, std::max(left_by(beside_caches() + edits + columns), least));
}

std::uint64_t MemoryBudget::for_edit_cache(std::uint64_t wanted) const {
  if (limit_ == 0) return wanted;
  return std::min(wanted, std::max(left_by(beside_caches()) / 8, limit_ / 64));
}

}  // namespace talus::server
