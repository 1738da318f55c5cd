#include "session/request_book.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include <rapidcheck.h>

using namespace talus;
using namespace talus::server;

TEST_CASE("the book holds what was asked and not yet answered, and hands it out in the order asked") {
  CHECK(rc::check([] {
    RequestBook book;
    std::map<std::uint32_t, std::int32_t> plain;  // chunk requests: id to x
    std::vector<std::uint32_t> waiting;
    std::size_t heights_bytes = 0;
    std::map<std::uint32_t, std::uint64_t> tickets;
    std::int32_t asked = 0;
    const auto steps = *rc::gen::container<std::vector<std::pair<int, std::uint32_t>>>(
        rc::gen::pair(rc::gen::inRange(0, 5), rc::gen::inRange(1U, 40U)));
    for (const auto& [what, id] : steps) {
      const bool known = plain.contains(id) || tickets.contains(id);
      RC_ASSERT(book.contains(id) == known);
      if (what <= 1 && !known) {
        book.add_chunk(id, {{{++asked, 0, 0}, Lod{}}, std::nullopt});
        plain[id] = asked;
        waiting.push_back(id);
      } else if (what == 2 && !known) {
        book.add_heights(id, id + 1000, 10);
        tickets[id] = id + 1000;
        heights_bytes += 10;
      } else if (what == 3) {
        book.erase(id);
        plain.erase(id);
        heights_bytes -= tickets.erase(id) * 10;
        std::erase(waiting, id);
      } else if (what == 4) {
        const auto next = book.next_waiting();
        RC_ASSERT(next.has_value() == !waiting.empty());
        if (next) {
          RC_ASSERT(*next == waiting.front());
          waiting.erase(waiting.begin());
        }
      }
      RC_ASSERT(book.size() == plain.size() + tickets.size());
      RC_ASSERT(book.heights_bytes() == heights_bytes);
    }
    for (const auto& [id, x] : plain) {
      RC_ASSERT(book.chunk(id) != nullptr);
      RC_ASSERT(book.chunk(id)->key.coord.x == x);
      RC_ASSERT_FALSE(book.heights_ticket(id).has_value());
    }
    for (const auto& [id, ticket] : tickets) RC_ASSERT(book.heights_ticket(id) == ticket);
  }));
}
