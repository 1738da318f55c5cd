// The pools that flows share, one line each. OPERATIONS.md prints the table, and tests/e2e/pools_test.cpp
// tries each line with one greedy flow and a client of another one.
#pragma once

#include <array>
#include <string_view>

namespace talus::server {

struct Pool {
  std::string_view name;
  std::string_view size;
  std::string_view share;      // of one flow, while others want some
  std::string_view gives_way;  // empty: nothing, and the flow is refused more, or waits
};

inline constexpr std::array kPools{
    Pool{"connections", "`limits.connections`",
         "as many as any, and a 64th; an address `limits.connections_per_address`",
         "of the flow with most, what has sent nothing for longest"},
    Pool{"handshakes", "`limits.handshakes_in_flight`", "as many as any address",
         "the oldest if over 3 s old, else the oldest of the address with most"},
    Pool{"memory of sessions, HTTP answers", "5/8 of `limits.memory_bytes`, less other uses",
         "as much as any, and a 64th of the budget",
         "a session whose client is 5 s behind 16 KiB/s, else one of the flow with most, if it has two"},
    Pool{"chunks that wait for a generator", "`generation.queue_chunks`",
         "as many as are free; a session always 16", ""},
    Pool{"edits that wait for the log", "256, or 256 KiB; a session 64", "turns by cost", ""},
    Pool{"editors", "65,536, or [fewer](#the-index-of-edited-chunks)", "an address `rates.address_editors`",
         "the oldest that never edited"},
    Pool{"chunks never edited before", "[the index](#the-index-of-edited-chunks)",
         "an address `rates.address_new_chunks`", ""},
};

}  // namespace talus::server
