#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <list>
#include <span>

#include <rapidcheck.h>

#include <talus/voxel/codec.h>

#include "cache/chunk_cache.h"
#include "cache/clock_cache.h"
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
    if (const auto old = place(key); old != slots_.end()) vacate(old);
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

TEST_CASE("ClockCache keeps what plain slots and a hand would keep, and never more than its capacity") {
  CHECK(rc::check([] {
    const auto capacity = *rc::gen::inRange<std::size_t>(200, 20'000);
    ClockCache<int, int> cache{capacity};
    ClockReference reference{capacity};
    const auto steps =
        *rc::gen::resize(400, rc::gen::container<std::vector<std::pair<int, int>>>(
                                  rc::gen::pair(rc::gen::inRange(0, 60), rc::gen::inRange(-300, 600))));
    for (const auto& [key, bytes] : steps) {
      if (bytes < 0) {
        const int* const value = cache.find(key);
        RC_ASSERT((value != nullptr) == reference.find(key));
        if (value != nullptr) RC_ASSERT(*value == key);
      } else {
        cache.put(key, key, static_cast<std::size_t>(bytes));
        reference.put(key, static_cast<std::size_t>(bytes));
      }
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

TEST_CASE("a chunk's frame is the message that FlatBuffers would make for that request and place") {
  CHECK(rc::check([] {
    const auto payload = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
    const auto hash =
        *rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::arbitrary<std::uint64_t>());
    const auto id = *rc::gen::element<std::uint32_t>(0, 1, 0x01020304, 0xFFFFFFFF);
    const auto at = *rc::gen::arbitrary<std::array<std::int32_t, 3>>();
    const ChunkKey key{{at[0], at[1], at[2]}, Lod::of(*rc::gen::inRange(0, Lod::kMax + 1))};

    const EncodedChunk chunk{{hash.first, hash.second}, std::as_bytes(std::span{payload})};
    std::vector<std::byte> output(8);  // frames of others lie before it
    chunk.append_frame(output, id, key);
    chunk.append_frame(output, 7, {});
    RC_ASSERT(output.size() == 8 + 2 * chunk.frame_bytes());
    const std::vector<std::byte> frame(output.begin() + 8,
                                       output.end() - static_cast<std::ptrdiff_t>(chunk.frame_bytes()));

    const auto message = protocol::read_message(frame);
    RC_ASSERT(message.has_value());
    const wire::Chunk& read = *(*message)->body_as_Chunk();
    RC_ASSERT(read.id() == id);
    RC_ASSERT((std::array{read.key()->x(), read.key()->y(), read.key()->z()}) == at);
    RC_ASSERT(read.key()->lod() == key.lod.value());
    RC_ASSERT(read.revision() == 0U);
    RC_ASSERT(std::pair(read.hash()->low(), read.hash()->high()) == hash);
    RC_ASSERT(read.codec() == kCodecVersion);
    RC_ASSERT(std::vector(read.payload()->begin(), read.payload()->end()) == payload);
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
