// Which of the chunks made here are compared with the server's. Pure.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <talus/client/chunk_maker.h>
#include <talus/client/client.h>

namespace talus::client {

/// The first proofs come from different batches, so that they are spread over the View, as long as there are
/// batches; the rest from all chunks that were made.
class Proofs {
 public:
  struct Proof {
    ChunkKey key;
    ContentHash hash;
  };

  explicit Proofs(std::uint64_t seed) : random_{seed} {}

  /// A connection begins: proofs are due as at the first.
  void begin() {
    due_ = kFirstProofs;
    uncounted_ = 0;
    sample_.clear();
    sampled_ = 0;
  }

  /// A batch was made; `mixed` are those of its chunks that have several materials and no edits. Returns the
  /// chunks to be compared. `last`: nothing else is to be made now.
  [[nodiscard]] std::vector<Proof> made(std::size_t chunks, const std::vector<Proof>& mixed, bool last);

  /// A comparison had no result: another takes its place.
  void repeat() { ++due_; }

 private:
  static constexpr std::size_t kMaxSample = 64;

  [[nodiscard]] std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>{0, count - 1}(random_);
  }

  std::mt19937_64 random_;
  std::size_t due_ = kFirstProofs;
  std::size_t uncounted_ = 0;  // chunks made since one became due
  std::vector<Proof> sample_;  // of all chunks not compared, evenly
  std::size_t sampled_ = 0;    // chunks that could have come into it
};

}  // namespace talus::client
