#include <algorithm>
#include <catch2/catch.hpp>
#include <list>

#include <rapidcheck.h>

#include "cache/chunk_cache.h"
#include "cache/lru.h"

using namespace talus;
using namespace talus::server;

namespace {

/// The plainest form of what Lru does.
class Reference {
 public:
  explicit Reference(std::size_t capacity) : capacity_{capacity} {}
  bool find(int key) {
    const auto found = place(key);
    if (found == entries_.end()) return false;
    entries_.splice(entries_.begin(), entries_, found);
    return true;
  }
  void put(int key, std::size_t bytes) {
    const auto old = place(key);
    if (old != entries_.end()) entries_.erase(old);
    const std::size_t cost = bytes + Lru<int, int>::kEntryOverheadBytes;
    if (cost > capacity_) return;
    entries_.emplace_front(key, cost);
    while (bytes_held() > capacity_) entries_.pop_back();
  }
  std::size_t bytes_held() const {
    std::size_t sum = 0;
    for (const auto& [key, cost] : entries_) sum += cost;
    return sum;
  }

 private:
  std::list<std::pair<int, std::size_t>>::iterator place(int key) {
    return std::find_if(entries_.begin(), entries_.end(),
                        [&](const auto& each) { return each.first == key; });
  }
  std::size_t capacity_;
  std::list<std::pair<int, std::size_t>> entries_;
};

EncodedChunkPtr chunk_of(std::size_t payload_bytes) {
  auto chunk = std::make_shared<EncodedChunk>();
  chunk->payload.resize(payload_bytes);
  return chunk;
}

}  // namespace

TEST_CASE("Lru keeps what a plain list would keep, and never more than its capacity") {
  CHECK(rc::check([] {
    constexpr std::size_t kCapacity = 2000;
    Lru<int, int> lru{kCapacity};
    Reference reference{kCapacity};
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, 12), rc::gen::inRange(-300, 2200)));
    for (const auto& [key, bytes] : steps) {
      if (bytes < 0) {
        RC_ASSERT((lru.find(key) != nullptr) == reference.find(key));
      } else {
        lru.put(key, bytes, static_cast<std::size_t>(bytes));
        reference.put(key, static_cast<std::size_t>(bytes));
      }
      RC_ASSERT(lru.bytes() == reference.bytes_held());
      RC_ASSERT(lru.bytes() <= kCapacity);
    }
  }));
}

TEST_CASE("the chunk cache stays within its bytes") {
  constexpr std::size_t kCapacity = 64 * 1024;
  ChunkCache cache{kCapacity};
  for (std::int32_t x = 0; x < 2000; ++x)
    cache.put({{x, 0, 0}, Lod{}}, chunk_of(static_cast<std::size_t>(x)));
  CHECK(cache.bytes() <= kCapacity);
  CHECK(cache.bytes() > kCapacity / 2);
}

TEST_CASE("the chunk cache gives back what it was given, by place and level") {
  ChunkCache cache{1 << 20};
  const auto chunk = chunk_of(10);
  cache.put({{1, 2, 3}, Lod{}}, chunk);
  CHECK(cache.find({{1, 2, 3}, Lod{}}) == chunk);
  CHECK(cache.find({{1, 2, 3}, Lod::of(1)}) == nullptr);
  CHECK(cache.find({{3, 2, 1}, Lod{}}) == nullptr);
}
