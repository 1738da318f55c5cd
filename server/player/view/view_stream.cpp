#include "player/view/view_stream.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace talus::server {
namespace {

constexpr std::size_t kMinSorted = 128;  // minimum number of chunks sorted at once

}  // namespace

void ViewStream::replace(AreaOfInterest wanted, std::span<const AreaOfInterest> between, bool has_base) {
  std::vector<State> states(wanted.places(), has_base ? State::undecided : State::to_send);
  wanted.for_each_shared(interest_, between, [&](std::size_t place, std::size_t before, std::size_t count) {
    std::copy_n(&states_[before], count, &states[place]);
  });
  if (has_base && !has_base_) {
    std::ranges::replace_if(
        states, [](State state) { return state != State::done; }, State::undecided);
  }
  states_ = std::move(states);
  interest_ = std::move(wanted);
  has_base_ = has_base;
  clear_lists();
  if (has_base) return;
  interest_.for_each([this](ChunkKey key, AreaOfInterest::Place place) { list(key, place); });
  left_ = far_.size() + in_flight_;
}

void ViewStream::clear_lists() {
  near_.clear();
  near_end_ = 0;
  far_.clear();
  in_flight_ = 0;
  left_ = 0;
  if (far_.capacity() / 4 > interest_.places()) decltype(far_){}.swap(far_);  // memory of a much larger View
  next_column_ = {};
}

void ViewStream::list(ChunkKey key, AreaOfInterest::Place place) {
  State& state = states_[place];
  if (state == State::to_send) {
    far_.push_back(interest_.coarse_priority(key, place));
  } else if (is_in_flight(state)) {
    state = State::in_flight_unlisted;
    ++in_flight_;
  }
}

bool ViewStream::is_undecided(ChunkKey column) const {
  const ChunkRange rows = interest_.rows_of(column);
  if (rows.size() == 0) return false;
  column.coord.y = static_cast<std::int32_t>(rows.first);
  const auto first = states_.begin() + *interest_.place_of(column);
  return std::find(first, first + static_cast<std::ptrdiff_t>(rows.size()), State::undecided) !=
         first + static_cast<std::ptrdiff_t>(rows.size());
}

void ViewStream::mark_edited(std::span<const ChunkKey> edited) {
  for (const ChunkKey key : edited) {
    const auto place = interest_.place_of(key);
    if (place && states_[*place] == State::undecided) states_[*place] = State::to_send;
  }
  // Nearly all are done: whole blocks are passed over at once.
  constexpr std::size_t kBlock = 64;
  clear_lists();
  for (std::size_t from = 0; from < states_.size(); from += kBlock) {
    const std::span block = std::span{states_}.subspan(from, std::min(kBlock, states_.size() - from));
    unsigned others = 0;
    for (State& state : block) {
      state = state == State::undecided ? State::done : state;
      others |= static_cast<unsigned>(state) ^ static_cast<unsigned>(State::done);
    }
    if (others == 0) continue;
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (block[i] == State::done) continue;
      const auto place = static_cast<AreaOfInterest::Place>(from + i);
      list(interest_.ranked(place).first, place);
    }
  }
  left_ = far_.size() + in_flight_;
}

std::optional<ChunkKey> ViewStream::nearest() {
  refill_near();
  if (near_.empty()) return std::nullopt;
  return interest_.ranked(near_.back()).first;
}

void ViewStream::start(ChunkKey key) {
  states_[*interest_.place_of(key)] = State::in_flight;
  ++in_flight_;
}

bool ViewStream::unlist(AreaOfInterest::Place place) {
  State& state = states_[place];
  if (state == State::in_flight) state = State::in_flight_unlisted;
  return state == State::to_send;
}

void ViewStream::refill_near() {
  for (;;) {
    while (!near_.empty() && !unlist(AreaOfInterest::place_of_rank(near_.back()))) near_.pop_back();
    if (!near_.empty() || far_.empty()) return;
    move_near();
  }
}

void ViewStream::move_near() {
  const std::size_t some = std::min(far_.size(), std::max(kMinSorted, far_.size() / 8));
  if (some == 0) return;
  // Farthest first, so that the nearest are popped off the end. A ring of equal distance is never split.
  const auto nth = far_.end() - static_cast<std::ptrdiff_t>(some);
  std::nth_element(far_.begin(), nth, far_.end(), std::greater<>{});
  near_end_ = AreaOfInterest::end_of_ring(*nth);
  const auto near =
      std::partition(far_.begin(), nth, [this](std::uint64_t coarse) { return coarse >= near_end_; });
  for (auto coarse = near; coarse != far_.end(); ++coarse) {
    if (!unlist(AreaOfInterest::place_of_rank(*coarse))) continue;
    const auto [key, place] = interest_.ranked(*coarse);
    near_.push_back(interest_.rank(key, place));
  }
  std::sort(near_.begin(), near_.end(), std::greater<>{});
  far_.erase(near, far_.end());
}

void ViewStream::put_back(ChunkKey key) {
  const AreaOfInterest::Place place = *interest_.place_of(key);
  --in_flight_;
  if (std::exchange(states_[place], State::to_send) == State::in_flight) return;  // still listed
  const std::uint64_t coarse = interest_.coarse_priority(key, place);
  if (coarse < near_end_) {
    const std::uint64_t rank = interest_.rank(key, place);
    near_.insert(std::lower_bound(near_.begin(), near_.end(), rank, std::greater<>{}), rank);
  } else {
    far_.push_back(coarse);
  }
}

void ViewStream::done(ChunkKey key) {
  State& state = states_[*interest_.place_of(key)];
  assert(is_in_flight(state));
  --in_flight_;
  state = State::done;
  --left_;
}

}  // namespace talus::server
