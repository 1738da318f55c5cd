#include "player/view/view_stream.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace talus::server {
namespace {

constexpr std::size_t kMinSorted = 128;  // minimum number of chunks sorted at once

}  // namespace

void ViewStream::replace(AreaOfInterest wanted, std::span<const AreaOfInterest> between) {
  std::vector<State> states(wanted.places(), State::to_send);
  wanted.for_each_shared(interest_, between, [&](std::size_t place, std::size_t before, std::size_t count) {
    std::copy_n(&states_[before], count, &states[place]);
  });
  states_ = std::move(states);
  interest_ = std::move(wanted);

  near_.clear();
  near_end_ = 0;
  far_.clear();
  in_flight_ = 0;
  if (far_.capacity() / 4 > interest_.places()) decltype(far_){}.swap(far_);  // memory of a much larger View
  interest_.for_each([this](ChunkKey key, AreaOfInterest::Place place) {
    State& state = states_[place];
    if (state == State::to_send) {
      far_.push_back(interest_.coarse_priority(key, place));
    } else if (is_in_flight(state)) {
      state = State::in_flight_unlisted;
      ++in_flight_;
    }
  });
  left_ = far_.size() + in_flight_;
  next_column_ = {};
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
