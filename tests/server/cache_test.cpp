#include "cache/chunk_cache.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include <rapidcheck.h>

#include "cache/clock_cache.h"
#include "failing_allocations.h"

using namespace talus;
using namespace talus::server;

namespace {

/// The plainest form of what ClockCache does: entries in their slots, and a hand that goes round them.
class ClockReference {
 public:
  explicit ClockReference(std::size_t capacity) : capacity_{capacity} {}
  bool find(int key) {
    const auto found = place(key);
    if (found == slots_.end()) return false;
    found->used = true;
    return true;
  }
  void put(int key, std::size_t bytes) {
    erase(key);
    const std::size_t cost = bytes + ClockCache<int, int>::kEntryOverheadBytes;
    if (cost > capacity_) return;
    for (; bytes_held() + cost > capacity_; hand_ = (hand_ + 1) % slots_.size()) {
      Slot& slot = slots_[hand_];
      if (slot.cost > 0 && !slot.used) vacate(place(slot.key));
      slot.used = false;
    }
    // The slot vacated last.
    if (vacant_.empty()) {
      vacant_.push_back(slots_.size());
      slots_.emplace_back();
    }
    slots_[vacant_.back()] = {key, cost, false};
    vacant_.pop_back();
  }
  void erase(int key) {
    if (const auto old = place(key); old != slots_.end()) vacate(old);
  }
  std::size_t bytes_held() const {
    std::size_t sum = 0;
    for (const Slot& slot : slots_) sum += slot.cost;
    return sum;
  }

 private:
  struct Slot {
    int key;
    std::size_t cost;
    bool used;
  };
  std::vector<Slot>::iterator place(int key) {
    return std::find_if(slots_.begin(), slots_.end(),
                        [&](const Slot& slot) { return slot.cost > 0 && slot.key == key; });
  }
  void vacate(std::vector<Slot>::iterator slot) {
    slot->cost = 0;
    vacant_.push_back(static_cast<std::size_t>(slot - slots_.begin()));
  }
  std::size_t capacity_;
  std::size_t hand_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::size_t> vacant_;
};

EncodedChunkPtr chunk_of(std::size_t payload_bytes) {
  return std::make_shared<const EncodedChunk>(ContentHash{}, std::vector<std::byte>(payload_bytes));
}

}  // namespace

TEST_CASE("ClockCache keeps what plain slots and a hand would keep, and never more than its capacity") {
  CHECK(rc::check([] {
    const auto capacity = *rc::gen::inRange<std::size_t>(200, 20'000);
    ClockCache<int, int> cache{capacity};
    ClockReference reference{capacity};
    const auto steps =
        *rc::gen::resize(400, rc::gen::container<std::vector<std::pair<int, int>>>(
                                  rc::gen::pair(rc::gen::inRange(0, 60), rc::gen::inRange(-400, 600))));
    std::map<int, int> held;  // by what the cache said of its evictions
    for (const auto& [key, bytes] : steps) {
      if (bytes < -300) {
        cache.erase(key);
        reference.erase(key);
        held.erase(key);
      } else if (bytes < 0) {
        const int* const value = cache.find(key);
        RC_ASSERT((value != nullptr) == reference.find(key));
        if (value != nullptr) RC_ASSERT(*value == key);
      } else {
        held.erase(key);
        std::vector<std::pair<int, int>> evicted;
        cache.put(key, key, static_cast<std::size_t>(bytes),
                  [&](int old, int&& value) noexcept { evicted.emplace_back(old, value); });
        for (const auto& [old, value] : evicted) {
          RC_ASSERT(old == value);
          RC_ASSERT(held.erase(old) == 1U);
        }
        if (cache.holds(key)) held[key] = key;
        reference.put(key, static_cast<std::size_t>(bytes));
      }
      RC_ASSERT(cache.size() == held.size());
      for (const auto& [each, value] : held) RC_ASSERT(cache.holds(each));
      RC_ASSERT(cache.bytes() == reference.bytes_held());
      RC_ASSERT(cache.bytes() <= capacity);
    }
  }));
}

TEST_CASE("what is used stays, what is not goes") {
  constexpr std::size_t kEntry = 1000 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{8 * kEntry};
  for (int key = 0; key < 1000; ++key) {
    cache.put(key, key, 1000);
    REQUIRE(cache.find(0) != nullptr);
  }
  CHECK(cache.size() == 8);
}

TEST_CASE("a smaller capacity evicts at once, gives its memory back, and leaves the rest to be found") {
  ClockCache<int, int> cache{1 << 20};
  for (int key = 0; key < 1000; ++key) cache.put(key, key, 100);
  cache.set_capacity(1 << 14);
  CHECK(cache.bytes() <= 1 << 14);
  CHECK(cache.size() > 50);
  int found = 0;
  for (int key = 0; key < 1000; ++key) {
    if (!cache.holds(key)) continue;
    CHECK(*cache.find(key) == key);
    ++found;
  }
  CHECK(found == static_cast<int>(cache.size()));
  cache.put(5000, 5000, 100);
  CHECK(cache.holds(5000));
}

TEST_CASE("a put() whose allocation fails has changed nothing, and can be tried again") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{60 * kEntry};
  std::map<int, int> held;  // by what the cache said of its evictions
  const auto check_all_held = [&] {
    REQUIRE(cache.size() == held.size());
    REQUIRE(cache.bytes() == held.size() * kEntry);
    for (const auto& [key, value] : held) {
      const int* const found = cache.find(key);
      REQUIRE(found != nullptr);
      REQUIRE(*found == value);
    }
  };
  int failures = 0;
  for (int i = 0; i < 400; ++i) {
    const int key = i % 80;
    std::vector<int> evicted;
    evicted.reserve(80);
    const auto put = [&] {
      cache.put(key, i, 100, [&](int old, int&&) noexcept { evicted.push_back(old); });
    };
    bool failed = false;
    {
      const talus::test::FailingAllocations failing{static_cast<std::size_t>(i % 2)};
      try {
        put();
      } catch (const std::bad_alloc&) {
        failed = true;
      }
    }
    if (failed) {
      ++failures;
      REQUIRE(evicted.empty());
      check_all_held();
      put();
    }
    for (const int old : evicted) held.erase(old);
    held[key] = i;
    check_all_held();
  }
  CHECK(failures > 1);
}

TEST_CASE("nothing is allocated to evict, to erase or to replace") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{10 * kEntry};
  for (int key = 0; key < 10; ++key) cache.put(key, key, 100);
  const talus::test::FailingAllocations failing{0};
  for (int key = 5; key < 100; ++key) cache.put(key, key, 100);
  cache.erase(99);
  cache.put(98, 0, 100);
  const bool failed_before = failing.has_failed();
  cache.set_capacity(4 * kEntry);
  const bool failed = failing.has_failed();
  CHECK_FALSE(failed_before);
  CHECK(failed);  // the memory in which less memory would be held
  CHECK(cache.size() == 4);
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
