// The pools that flows share, one line each. OPERATIONS.md prints the table, and tests/e2e/pools_test.cpp
// tries each line with one greedy flow of each kind of client and a client of another flow.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// Kinds of clients that take parts of a pool.
enum PoolUsers : std::uint8_t {
  kSessions = 1,   // by TCP or WebSocket
  kHttp = 2,       // players' HTTP
  kOperators = 4,  // the operators' port
  kCommands = 8,   // talusd store
};

struct Pool {
  std::string_view name;
  unsigned users;  // PoolUsers
  std::string_view size;
  std::string_view share;      // of one flow, while others want some
  std::string_view gives_way;  // empty: nothing, and the flow is refused more, or waits
};

inline constexpr std::array kPools{
    Pool{"connections", kSessions | kHttp, "`limits.connections`",
         "as many as any, and a 64th; an address `limits.connections_per_address`",
         "of the flow with most, what has sent nothing for longest"},
    Pool{"handshakes", kSessions | kHttp, "`limits.handshakes_in_flight`", "as many as any address",
         "the oldest if over 3 s old, else the oldest of the address with most"},
    Pool{"refusals being sent", kSessions | kHttp, "64", "as many as any address",
         "the oldest of the address with most"},
    Pool{"memory: sessions, frames, WebSocket buffers, HTTP answers", kSessions | kHttp,
         "5/8 of `limits.memory_bytes`, less other uses", "as much as any, and a 64th of the budget",
         "a session whose client is 5 s behind 16 KiB/s, else one of the flow with most, if it has two, else "
         "one 1 s behind"},
    Pool{"io threads: frames, HTTP rounds, handshakes", kSessions | kHttp, "`threads.io`",
         "turns of 32 requests, 4 KiB of input, 256 KiB of answers or half a handshake step", ""},
    Pool{"io threads: Views", kSessions, "a quarter of each", "turns by time", ""},
    Pool{"generators: chunks, heights, map tiles", kSessions | kHttp, "`threads.generator`", "turns by time",
         "a piece, if it may wait"},
    Pool{"pieces begun", kSessions | kHttp, "16, or 1/8 of `limits.memory_bytes`", "a quarter", ""},
    Pool{"chunks that wait for a generator", kSessions | kHttp, "`generation.queue_chunks`",
         "as many as are free; a session or request always 16", ""},
    Pool{"edits that wait for the log", kSessions, "256, or 256 KiB; a session 64", "turns by cost", ""},
    Pool{"editors", kSessions, "65,536, or [fewer](#the-index-of-edited-chunks)",
         "an address `rates.address_editors`", "the oldest that never edited"},
    Pool{"chunks never edited before", kSessions, "[the index](#the-index-of-edited-chunks)",
         "an address `rates.address_new_chunks`", ""},
    Pool{"followed changes", kSessions, "16,384 chunks", "a session 4,096",
         "the list: all its chunks are compared"},
    Pool{"operators' connections", kOperators, "32", "as many as any address",
         "the longest idle of the address with most"},
    Pool{"checkpoints over their port", kOperators, "2", "as many as any address",
         "the oldest of the address with most"},
    Pool{"`talusd store` commands", kCommands, "4", "as many as any process",
         "the oldest of the process with most"},
};

}  // namespace talus::server
