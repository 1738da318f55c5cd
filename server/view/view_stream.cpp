#include "view/view_stream.h"

#include <algorithm>
#include <utility>

namespace talus::server {
namespace {

constexpr std::size_t kMinSorted = 128;  // chunks that are put in order at once, at least

}  // namespace

std::vector<ChunkKey> ViewStream::replace(AreaOfInterest wanted, std::span<const AreaOfInterest> between) {
  std::vector<State> states(wanted.places(), State::to_send);
  wanted.for_each_shared(interest_, between, [&](std::size_t place, std::size_t before, std::size_t count) {
    std::copy_n(&states_[before], count, &states[place]);
  });
  states_ = std::move(states);
  interest_ = std::move(wanted);

  near_ = {};
  near_end_ = 0;
  far_.clear();
  if (far_.capacity() / 4 > interest_.places()) decltype(far_){}.swap(far_);  // of a much larger View
  interest_.for_each([this](ChunkKey key, AreaOfInterest::Place place) {
    if (states_[place] == State::to_send) far_.push_back(interest_.coarse_priority(key, place));
  });

  std::vector<ChunkKey> dropped;
  for (const ChunkKey key : in_flight_) {
    const auto place = interest_.place_of(key);
    if (!place || states_[*place] != State::in_flight) dropped.push_back(key);
  }
  for (const ChunkKey key : dropped) in_flight_.erase(key);
  left_ = far_.size() + in_flight_.size();
  next_column_ = {};
  return dropped;
}

std::optional<ChunkKey> ViewStream::next() {
  refill_near();
  if (near_.empty()) return std::nullopt;
  const auto [key, place] = interest_.ranked(near_.top());
  near_.pop();
  states_[place] = State::in_flight;
  in_flight_.insert(key);
  return key;
}

void ViewStream::refill_near() {
  for (;;) {
    while (!near_.empty() && states_[interest_.ranked(near_.top()).second] != State::to_send) near_.pop();
    if (!near_.empty() || far_.empty()) return;
    move_near();
  }
}

void ViewStream::move_near() {
  const std::size_t some = std::min(far_.size(), std::max(kMinSorted, far_.size() / 16));
  if (some == 0) return;
  // Farthest first, so that the nearest are taken off the end. A ring of equal distance is never split.
  const auto nth = far_.end() - static_cast<std::ptrdiff_t>(some);
  std::nth_element(far_.begin(), nth, far_.end(), std::greater<>{});
  near_end_ = AreaOfInterest::end_of_ring(*nth);
  const auto near =
      std::partition(far_.begin(), nth, [this](std::uint64_t coarse) { return coarse >= near_end_; });
  for (auto coarse = near; coarse != far_.end(); ++coarse) {
    const auto [key, place] = interest_.ranked(*coarse);
    if (states_[place] == State::to_send) near_.push(interest_.rank(key, place));
  }
  far_.erase(near, far_.end());
}

void ViewStream::put_back(ChunkKey key) {
  leave(key, State::to_send);
  const AreaOfInterest::Place place = *interest_.place_of(key);
  const std::uint64_t coarse = interest_.coarse_priority(key, place);
  if (coarse < near_end_) {
    near_.push(interest_.rank(key, place));
  } else {
    far_.push_back(coarse);
  }
}

void ViewStream::done(ChunkKey key) {
  leave(key, State::done);
  --left_;
}

void ViewStream::leave(ChunkKey key, State state) {
  states_[*interest_.place_of(key)] = state;
  in_flight_.erase(key);
}

}  // namespace talus::server
