// Revisions that a player holds of edited chunks in its View. No I/O.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include <talus/voxel/coords.h>

namespace talus::load {

class HeldRevisions {
 public:
  /// Records that a chunk or its changes arrived: keeps the higher revision. Returns true if it is new;
  /// chunks that are not recorded have revision 0.
  bool raise(ChunkKey chunk, std::uint64_t revision) {
    if (revision == 0) return false;
    std::uint64_t& held = revisions_[chunk];
    const bool news = revision > held;
    held = std::max(held, revision);
    return news;
  }
  /// Forgets the chunks for which gone(chunk) is true.
  template <typename Gone>
  void forget(Gone&& gone) {
    std::erase_if(revisions_, [&](const auto& each) { return gone(each.first); });
  }
  [[nodiscard]] std::size_t size() const { return revisions_.size(); }

 private:
  std::unordered_map<ChunkKey, std::uint64_t> revisions_;
};

}  // namespace talus::load
