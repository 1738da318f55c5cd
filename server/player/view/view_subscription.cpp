#include "player/view/view_subscription.h"

#include <utility>

namespace talus::server {

void ViewSubscription::request(View view) {
  const bool same = requested_ && same_chunks(*requested_, view);
  // The client has dropped chunks that left in any View, applied or not.
  if (requested_ && !same) {
    if (unseen_.size() == kMaxUnseenViews) unseen_ = {AreaOfInterest{}};
    unseen_.emplace_back(*requested_);
  }
  if ((requested_ ? requested_->has_base : has_base()) && !view.has_base) unseen_ = {AreaOfInterest{}};
  if (!known_.empty() && !same) {
    const AreaOfInterest wanted{view};
    std::erase_if(known_, [&](const auto& chunk) { return !wanted.place_of(chunk.first); });
  }
  piles_up_ = requested_.has_value();
  requested_ = std::move(view);
}

void ViewSubscription::add_known(ChunkKey key, ContentHash hash) {
  if (known_.size() < kMaxKnownChunks) known_[key] = hash;
}

void ViewSubscription::apply() {
  if (!requested_) return;
  const View view = *std::exchange(requested_, std::nullopt);
  piles_up_ = false;
  number_ = view.number;
  completion_due_ = number_ != 0;
  AreaOfInterest wanted{view};
  heading_.move_to(view.centre, view.rings.empty() ? view.horizontal_radius : view.rings.back().radius);
  ahead_ = heading_.ahead(wanted.boxes());
  stream_.replace(std::move(wanted), std::exchange(unseen_, {}), view.has_base);
  if (!view.has_base) forget_known();
}

void ViewSubscription::mark_edited(std::span<const ChunkKey> edited) {
  stream_.mark_edited(edited);
  forget_known();
}

void ViewSubscription::forget_known() {
  std::erase_if(known_, [&](const auto& chunk) { return !stream_.wants(chunk.first); });
}

void ViewSubscription::clear() {
  requested_.reset();
  piles_up_ = false;
  unseen_.clear();
  known_.clear();
  number_ = 0;
  completion_due_ = false;
  ahead_.clear();
  stream_.replace({});
}

std::optional<std::uint32_t> ViewSubscription::completed() {
  if (!completion_due_ || requested_ || stream_.left() > 0) return std::nullopt;
  completion_due_ = false;
  return number_;
}

void ViewSubscription::done(ChunkKey key) {
  stream_.done(key);
  if (!known_.empty()) known_.erase(key);
}

bool ViewSubscription::knows(ChunkKey key, ContentHash hash) const {
  if (known_.empty()) return false;
  const auto known = known_.find(key);
  return known != known_.end() && known->second == hash;
}

std::size_t ViewSubscription::bytes() const {
  constexpr std::size_t kPerKnown = 64;
  // The source has the boxes too, and again by place.
  return stream_.bytes() + known_.size() * kPerKnown + ahead_.size() * 6 * sizeof(LevelBox);
}

}  // namespace talus::server
