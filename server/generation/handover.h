// Answers on their way from a generator to those who wait.
#pragma once

#include <chrono>
#include <cstddef>
#include <unordered_map>
#include <vector>

#include "generation/chunk_client.h"
#include "log/logger.h"

namespace talus::server {

/// Waking a client's thread costs as much as many a chunk, and on a busy core it takes the generator's place.
/// So what is made soon after something was handed over goes with the next chunk of the same piece of work.
/// Of one thread, for one piece of work; flush() ends it.
class Handover {
 public:
  explicit Handover(const Logger& log) : log_{log} {}

  /// A waiter for whom there is no memory goes without, which the log says.
  void add(const std::vector<ChunkClientPtr>& waiters, ChunkKey key, const ChunkAnswer& answer);
  /// Hands over what was added since.
  void flush();

 private:
  using Clock = std::chrono::steady_clock;

  template <typename Step>
  void log_failure(std::size_t chunks, Step&& step);

  const Logger& log_;
  std::unordered_map<ChunkClientPtr, std::vector<ReadyChunk>> parcels_;
  Clock::time_point handed_over_{};
};

}  // namespace talus::server
