// The memory that talusd accounts for, against limits.memory_bytes. Callable from any thread; locks only when
// new work is let in again.
//
// Caches give way first: they may have what everything else leaves. When everything else comes near the
// limit, new connections are refused, and after them new work, each until use is well below the limit again:
// what is in flight can end, and nothing flaps. Before a client is refused, sessions of others give way
// (flow_shares.h).
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string_view>

#include "limits/flows/flow_shares.h"
#include "limits/memory/hysteresis_gate.h"
#include "runtime/clock.h"

namespace talus::server {

/// Text of an error when limits.memory_bytes is reached.
inline constexpr std::string_view kNoMemory = "this server's memory is all in use";

enum class MemoryUse : std::uint8_t {
  program,
  sessions,
  jobs,
  generators,
  edits,
  store,
  chunk_cache,
  patch_cache,
  edit_cache,
  column_cache
};
inline constexpr std::array<std::string_view, 10> kMemoryUses{
    "program", "sessions",    "jobs",        "generators", "edits",
    "store",   "chunk_cache", "patch_cache", "edit_cache", "column_cache"};

class MemoryBudget {
 public:
  /// Memory of the program before it serves a client: its code, its log, and up to kFewThreads threads.
  static constexpr std::uint64_t kProgramBytes = std::uint64_t{24} << 20;
  static constexpr std::size_t kFewThreads = 16;
  /// Memory that each thread beyond kFewThreads keeps for its next work, at most: four outputs of 32 KiB if
  /// it serves sockets; the layers and the code of a chunk, 63 and 65 KiB, if it generates.
  static constexpr std::uint64_t kThreadBytes = std::uint64_t{128} << 10;
  /// Memory of a new connection.
  static constexpr std::uint64_t kConnectionBytes = std::uint64_t{32} << 10;
  /// A flow whose clients drain what it holds may always have the limit divided by this.
  static constexpr std::uint64_t kFlows = 64;
  /// A session may give way if its client is over kPatience behind draining this number of bytes a second.
  static constexpr std::uint64_t kDrainedBytes = std::uint64_t{16} << 10;
  static constexpr std::chrono::seconds kPatience{5};
  /// Returns the memory of the program with `threads` threads that serve and generate.
  [[nodiscard]] static constexpr std::uint64_t program_bytes(std::size_t threads) {
    return kProgramBytes + (threads > kFewThreads ? (threads - kFewThreads) * kThreadBytes : 0);
  }

  /// 0: no limit, nothing is ever refused.
  explicit MemoryBudget(std::uint64_t limit_bytes, std::size_t threads = 0);

  [[nodiscard]] std::uint64_t limit_bytes() const { return limit_; }
  [[nodiscard]] std::uint64_t used(MemoryUse use) const;
  [[nodiscard]] std::uint64_t used() const;

  /// Both may call the function given to when_jobs_resume(): hold no lock that it takes.
  void add(MemoryUse use, std::int64_t bytes);
  void set(MemoryUse use, std::uint64_t bytes);

  /// False once use reaches 3/4 of the limit; true again below 5/8, or below 7/8 if no job is left. If
  /// sessions hold the memory they are then served one after the other, as a client that waits for chunks may
  /// hold it until they come.
  [[nodiscard]] bool takes_jobs() const { return jobs_.open(); }
  /// Returns true if heights may be asked for, and Views and frames may grow. False once use reaches 3/4 of
  /// the limit; true again below 5/8, or below 13/16 if no job is left: idle sessions may have 5/8, and
  /// generators keep an eighth for good.
  [[nodiscard]] bool takes_work() const { return work_.open(); }
  /// Returns true if new connections may come. False once use reaches 5/8 of the limit; true again below 1/2,
  /// or below 5/8 if no session is left that could end. Sessions that are open need memory to work.
  [[nodiscard]] bool takes_connections() const { return connections_.open(); }
  /// Its parts belong to sessions and HTTP connections.
  [[nodiscard]] FlowShares& shares() { return shares_; }
  /// Returns true if `flow` may have a connection, or `bytes` for work. If memory is short, a session of
  /// others gives way.
  [[nodiscard]] bool takes_connection_of(FlowId flow, Clock::time_point now) {
    return takes_connections() || make_room(flow, kConnectionBytes, limit_ / 8 * 5, now);
  }
  [[nodiscard]] bool takes_work_of(FlowId flow, std::uint64_t bytes, Clock::time_point now) {
    return takes_work() || make_room(flow, bytes, limit_ / 8 * 5, now);
  }
  /// Ends sessions whose clients drain too little, if memory is short for new connections: call it often.
  void end_still_sessions(Clock::time_point now) {
    if (!takes_connections()) shares_.end_still(over(limit_ / 2), now);
  }
  /// `resumed` is called when takes_jobs() becomes true again, on the thread that gave memory back; it must
  /// not wait, throw, or change the budget. Replaces the function before, and returns when no thread is in
  /// it.
  void when_jobs_resume(std::function<void()> resumed);

  /// Returns how much of `wanted` bytes caches of chunks and patches may hold now: 7/8 of the limit less
  /// everything else and the caches of edits and of columns on disk; at least 1/16 of the limit, less those
  /// caches' minimum, a 64th each.
  [[nodiscard]] std::uint64_t for_caches(std::uint64_t wanted) const;
  /// Returns the same for the cache of edits: an eighth of what caches may have, and at least 1/64 of the
  /// limit.
  [[nodiscard]] std::uint64_t for_edit_cache(std::uint64_t wanted) const;

 private:
  [[nodiscard]] std::uint64_t beside_caches() const;
  /// Memory in use above `bytes`, without what sessions that gave way are giving back.
  [[nodiscard]] std::uint64_t over(std::uint64_t bytes) const;
  /// Sessions of others give way until `flow` could have `bytes` below `level`. Returns true if one did, or
  /// if those that gave way before suffice.
  [[nodiscard]] bool make_room(FlowId flow, std::uint64_t bytes, std::uint64_t level, Clock::time_point now);
  /// Returns what `bytes` leave of 7/8 of the limit.
  [[nodiscard]] std::uint64_t left_by(std::uint64_t bytes) const;
  void update_gates();

  const std::uint64_t limit_;
  std::array<std::atomic<std::int64_t>, kMemoryUses.size()> used_{};
  HysteresisGate jobs_, work_, connections_;
  FlowShares shares_{kPatience};
  std::mutex resumed_mutex_;
  std::function<void()> resumed_;
};

}  // namespace talus::server
