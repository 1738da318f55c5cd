#include "stream/view_stream.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace talus::server {

std::vector<ChunkKey> ViewStream::replace(std::vector<ChunkKey> wanted) {
  std::unordered_set<ChunkKey> done;
  for (std::size_t place = 0; place < order_.size(); ++place) {
    if (states_[place] == State::done) done.insert(order_[place]);
  }
  const auto before = std::exchange(under_way_, {});
  order_ = std::move(wanted);
  states_.assign(order_.size(), State::wanted);
  cursor_ = 0;
  for (std::size_t place = 0; place < order_.size(); ++place) {
    const ChunkKey key = order_[place];
    if (before.contains(key)) {
      states_[place] = State::under_way;
      under_way_.emplace(key, place);
    } else if (done.contains(key)) {
      states_[place] = State::done;
    }
  }
  std::vector<ChunkKey> dropped;
  for (const auto& [key, place] : before) {
    if (!under_way_.contains(key)) dropped.push_back(key);
  }
  return dropped;
}

std::optional<ChunkKey> ViewStream::next() {
  while (cursor_ < order_.size() && states_[cursor_] != State::wanted) ++cursor_;
  if (cursor_ == order_.size()) return std::nullopt;
  states_[cursor_] = State::under_way;
  under_way_.emplace(order_[cursor_], cursor_);
  return order_[cursor_];
}

void ViewStream::put_back(ChunkKey key) {
  cursor_ = std::min(cursor_, under_way_.at(key));
  leave(key, State::wanted);
}

void ViewStream::done(ChunkKey key) {
  leave(key, State::done);
}

void ViewStream::leave(ChunkKey key, State state) {
  const auto found = under_way_.find(key);
  states_[found->second] = state;
  under_way_.erase(found);
}

}  // namespace talus::server
