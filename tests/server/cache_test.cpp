#include "chunks/cache/chunk_cache.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include <rapidcheck.h>

#include "chunks/cache/clock_cache.h"
#include "failing_allocations.h"

using namespace talus;
using namespace talus::server;

namespace {

/// The plainest form of what ClockCache does: entries in a row, and a hand that goes round them.
class ClockReference {
 public:
  explicit ClockReference(std::size_t capacity) : capacity_{capacity} {}
  bool find(int key) {
    const auto found = place(key);
    if (found == entries_.end()) return false;
    found->used = true;
    return true;
  }
  void put(int key, std::size_t bytes) {
    const std::size_t cost = bytes + ClockCache<int, int>::kEntryOverheadBytes;
    if (cost > capacity_) return erase(key);
    const std::size_t most = std::max(capacity_, bytes_held());
    if (place(key) == entries_.end()) {
      if (bytes_held() + cost <= most) {
        entries_.push_back({key, 0, false});
      } else {
        entries_[next_victim()] = {key, 0, false};
      }
    }
    *place(key) = {key, cost, false};
    while (bytes_held() > most) {
      std::size_t victim = next_victim();
      while (entries_[victim].key == key) victim = next_victim();
      remove(victim);
    }
  }
  void erase(int key) {
    if (const auto old = place(key); old != entries_.end())
      remove(static_cast<std::size_t>(old - entries_.begin()));
  }
  void set_capacity(std::size_t capacity) { capacity_ = capacity; }
  void fit(std::size_t probes) {
    for (; probes > 0 && bytes_held() > capacity_; --probes) {
      const std::size_t at = step();
      if (!std::exchange(entries_[at].used, false)) remove(at);
    }
  }
  std::size_t capacity() const { return capacity_; }
  std::size_t bytes_held() const {
    std::size_t sum = 0;
    for (const Entry& entry : entries_) sum += entry.cost;
    return sum;
  }

 private:
  struct Entry {
    int key;
    std::size_t cost;
    bool used;
  };
  std::vector<Entry>::iterator place(int key) {
    return std::find_if(entries_.begin(), entries_.end(),
                        [&](const Entry& entry) { return entry.key == key; });
  }
  std::size_t step() {
    const std::size_t at = hand_;
    hand_ = (hand_ + 1) % entries_.size();
    return at;
  }
  std::size_t next_victim() {
    for (;;) {
      const std::size_t at = step();
      if (!std::exchange(entries_[at].used, false)) return at;
    }
  }
  void remove(std::size_t at) {
    entries_[at] = entries_.back();
    entries_.pop_back();
    if (hand_ == entries_.size()) hand_ = 0;
  }
  std::size_t capacity_;
  std::size_t hand_ = 0;
  std::vector<Entry> entries_;
};

EncodedChunkPtr chunk_of(std::size_t payload_bytes) {
  return std::make_shared<const EncodedChunk>(ContentHash{}, std::vector<std::byte>(payload_bytes));
}

}  // namespace

TEST_CASE("ClockCache keeps what a row of entries and a hand would keep, and never grows past its capacity") {
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
      } else if (bytes > 560) {
        const std::size_t smaller = static_cast<std::size_t>(bytes - 560) * capacity / 40;
        cache.set_capacity(smaller);
        reference.set_capacity(smaller);
      } else if (bytes > 520) {
        auto probes = static_cast<std::size_t>(bytes - 520);
        reference.fit(probes);
        const bool fits = cache.fit(probes);
        RC_ASSERT(fits == (cache.bytes() <= reference.capacity()));
        if (!fits) RC_ASSERT(probes == 0U);
        std::erase_if(held, [&](const auto& entry) { return !cache.holds(entry.first); });
      } else {
        const std::size_t most = std::max(cache.bytes(), reference.capacity());
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
        RC_ASSERT(cache.bytes() <= most);
      }
      RC_ASSERT(cache.size() == held.size());
      for (const auto& [each, value] : held) RC_ASSERT(cache.holds(each));
      RC_ASSERT(cache.bytes() == reference.bytes_held());
    }
  }));
}

TEST_CASE("a used entry stays, an unused one goes") {
  constexpr std::size_t kEntry = 1000 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{8 * kEntry};
  for (int key = 0; key < 1000; ++key) {
    cache.put(key, key, 1000);
    REQUIRE(cache.find(0) != nullptr);
  }
  CHECK(cache.size() == 8);
}

TEST_CASE("a smaller capacity is fitted a slice a call, and the rest is found throughout") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{1000 * kEntry};
  for (int key = 0; key < 1000; ++key) cache.put(key, key, 100);
  for (int key = 0; key < 500; ++key) (void)cache.find(key);  // the hand passes these once
  cache.set_capacity(100 * kEntry);
  bool fits = false;
  int calls = 0;
  while (!fits) {
    const std::size_t before = cache.size();
    std::size_t probes = 40;
    fits = cache.fit(probes);
    ++calls;
    REQUIRE(before - cache.size() <= 40);
    int found = 0;
    for (int key = 0; key < 1000; ++key) found += cache.holds(key) ? 1 : 0;
    REQUIRE(found == static_cast<int>(cache.size()));
    REQUIRE(cache.bytes() == cache.size() * kEntry);
  }
  CHECK(calls > 1000 / 40);
  CHECK(cache.size() == 100);
  cache.put(5000, 5000, 100);
  CHECK(cache.holds(5000));
  CHECK(cache.size() == 100);
}

TEST_CASE("an insert into a cache that is too large frees room for the new entry only") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{1000 * kEntry};
  for (int key = 0; key < 1000; ++key) cache.put(key, key, 100);
  cache.set_capacity(10 * kEntry);
  int evicted = 0;
  cache.put(2000, 2000, 100, [&](int, int&&) noexcept { ++evicted; });
  CHECK(evicted == 1);
  CHECK(cache.holds(2000));
  CHECK(cache.size() == 1000);
}

TEST_CASE("a put() with any failed allocation changes nothing and can be repeated") {
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
    bool failed = true;
    for (std::size_t allocations = 0; failed; ++allocations) {
      {
        const talus::test::FailingAllocations failing{allocations};
        try {
          cache.put(key, i, 100, [&](int old, int&&) noexcept { evicted.push_back(old); });
        } catch (const std::bad_alloc&) {
        }
        failed = failing.has_failed();
      }
      if (!failed) break;
      ++failures;
      REQUIRE(evicted.empty());
      check_all_held();
    }
    for (const int old : evicted) held.erase(old);
    held[key] = i;
    check_all_held();
  }
  CHECK(failures > 4);
}

TEST_CASE("a cache that lacks the memory to give its memory back fits all the same, and is whole") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{1000 * kEntry};
  for (int key = 0; key < 1000; ++key) cache.put(key, key, 100);
  cache.set_capacity(8 * kEntry);
  bool failed = false;
  std::size_t probes = 1000;
  {
    const talus::test::FailingAllocations failing{0};
    REQUIRE(cache.fit(probes));
    failed = failing.has_failed();
  }
  CHECK(failed);
  CHECK(cache.size() == 8);
  for (int i = 0; i < 2; ++i) {
    CHECK(cache.fit(probes));  // the first gives it back
    int found = 0;
    for (int key = 0; key < 1000; ++key) found += cache.holds(key) ? 1 : 0;
    CHECK(found == 8);
  }
}

TEST_CASE("nothing is allocated to evict, to erase or to replace") {
  constexpr std::size_t kEntry = 100 + ClockCache<int, int>::kEntryOverheadBytes;
  ClockCache<int, int> cache{10 * kEntry};
  for (int key = 0; key < 10; ++key) cache.put(key, key, 100);
  const talus::test::FailingAllocations failing{0};
  for (int key = 5; key < 100; ++key) cache.put(key, key, 100);
  cache.erase(99);
  cache.put(98, 0, 100);
  const bool failed = failing.has_failed();
  CHECK_FALSE(failed);
}

TEST_CASE("a sharded put() with any failed allocation leaves every shard whole") {
  using Cache = ShardedCache<ChunkKey, int>;
  constexpr std::size_t kEntry = 100 + ClockCache<ChunkKey, int>::kEntryOverheadBytes;
  Cache cache{1000 * kEntry};
  std::set<std::int32_t> held;
  for (std::int32_t x = 0; x < 200; ++x) {
    const ChunkKey key{{x, 0, 0}, Lod{}};
    bool failed = true;
    for (std::size_t allocations = 0; failed; ++allocations) {
      {
        const talus::test::FailingAllocations failing{allocations};
        try {
          cache.put(key, x, 100);
        } catch (const std::bad_alloc&) {
        }
        failed = failing.has_failed();
      }
      if (!failed) held.insert(x);
      REQUIRE(cache.holds(key) == !failed);
      REQUIRE(cache.bytes() == held.size() * kEntry);
    }
    REQUIRE(cache.find(key) == x);
  }
}

TEST_CASE("a sharded cache of a smaller capacity fits after calls that look at no more than they may") {
  ShardedCache<ChunkKey, int> cache{1 << 20};
  const auto held = [&] {
    std::size_t count = 0;
    for (std::int32_t x = 0; x < 5000; ++x) count += cache.holds({{x, 0, 0}, Lod{}}) ? 1U : 0U;
    return count;
  };
  for (std::int32_t x = 0; x < 5000; ++x) cache.put({{x, 0, 0}, Lod{}}, x, 100);
  cache.set_capacity(1 << 16);
  bool fits = false;
  while (!fits) {
    const std::size_t before = held();
    std::size_t probes = 100;
    fits = cache.fit(probes);
    REQUIRE(before - held() == 100 - probes);
  }
  CHECK(cache.bytes() <= 1 << 16);
  CHECK(cache.bytes() > 1 << 15);
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
