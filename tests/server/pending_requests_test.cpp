#include "player/session/pending_requests.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include <rapidcheck.h>

using namespace talus;
using namespace talus::server;

namespace {

// Times IdMap's multiplier this is 1 (mod 2^32): where its secret is 0, the multiples of this by small
// numbers all have the first slot for their home.
constexpr std::uint32_t kInverse = 0x144CBC89U;
static_assert(kInverse * 0x9E3779B9U == 1);

}  // namespace

TEST_CASE("a map by id does what a plain map does, with ids that all meet in one slot too") {
  const std::uint32_t spread = GENERATE(1U, kInverse);
  CHECK(rc::check([spread] {
    IdMap<int> map{0};
    std::map<std::uint32_t, int> plain;
    const auto steps = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(1U, 60U));
    for (const std::uint32_t number : steps) {
      const std::uint32_t id = number * spread;
      if (plain.erase(id) != 0) {
        map.erase(id);
      } else {
        map.insert(id, static_cast<int>(number));
        plain[id] = static_cast<int>(number);
      }
      RC_ASSERT(map.size() == plain.size());
      for (std::uint32_t n = 1; n < 60; ++n) {
        const int* const found = map.find(n * spread);
        RC_ASSERT((found != nullptr) == plain.contains(n * spread));
        if (found != nullptr) RC_ASSERT(*found == static_cast<int>(n));
      }
    }
  }));
}

TEST_CASE("pending requests do what plain maps would do, and start in the order asked") {
  CHECK(rc::check([] {
    PendingRequests pending;
    std::map<std::uint32_t, std::int32_t> chunks;  // chunk requests: id to x
    std::vector<std::uint32_t> unstarted;
    std::size_t heights_bytes = 0;
    std::map<std::uint32_t, std::uint64_t> tickets;
    std::int32_t asked = 0;
    const auto steps = *rc::gen::container<std::vector<std::pair<int, std::uint32_t>>>(
        rc::gen::pair(rc::gen::inRange(0, 5), rc::gen::inRange(1U, 40U)));
    for (const auto& [what, number] : steps) {
      const std::uint32_t id = number;
      const bool known = chunks.contains(id) || tickets.contains(id);
      RC_ASSERT(pending.contains(id) == known);
      if (what <= 1 && !known) {
        pending.add_chunk(id, {{{++asked, 0, 0}, Lod{}}, std::nullopt});
        chunks[id] = asked;
        unstarted.push_back(id);
      } else if (what == 2 && !known) {
        pending.add_heights(id, id + 1000, 10);
        tickets[id] = id + 1000;
        heights_bytes += 10;
      } else if (what == 3) {
        pending.erase(id);
        chunks.erase(id);
        heights_bytes -= tickets.erase(id) * 10;
        std::erase(unstarted, id);
      } else if (what == 4) {
        const auto next = pending.next_unstarted();
        RC_ASSERT(next.has_value() == !unstarted.empty());
        if (next) {
          RC_ASSERT(*next == unstarted.front());
          unstarted.erase(unstarted.begin());
        }
      }
      RC_ASSERT(pending.size() == chunks.size() + tickets.size());
      RC_ASSERT(pending.heights_bytes() == heights_bytes);
    }
    for (const auto& [id, x] : chunks) {
      RC_ASSERT(pending.chunk(id) != nullptr);
      RC_ASSERT(pending.chunk(id)->key.coord.x == x);
      RC_ASSERT_FALSE(pending.heights_ticket(id).has_value());
    }
    for (const auto& [id, ticket] : tickets) RC_ASSERT(pending.heights_ticket(id) == ticket);
  }));
}

TEST_CASE("no request has the id 0, which clients may name in a Cancel") {
  PendingRequests pending;
  CHECK(pending.chunk(0) == nullptr);
  pending.add_chunk(1, {});
  CHECK_FALSE(pending.contains(0));
  pending.erase(0);
  CHECK(pending.size() == 1);
}

TEST_CASE("a thousand requests are found, and answered in any order") {
  PendingRequests pending;
  for (std::uint32_t id = 1; id <= 1000; ++id) pending.add_heights(id, id, 1);
  for (std::uint32_t id = 1; id <= 1000; id += 2) pending.erase(id);
  for (std::uint32_t id = 1; id <= 1000; ++id) CHECK(pending.contains(id) == (id % 2 == 0));
  for (std::uint32_t id = 1000; id >= 2; id -= 2) pending.erase(id);
  CHECK(pending.empty());
  CHECK(pending.heights_bytes() == 0);
}
