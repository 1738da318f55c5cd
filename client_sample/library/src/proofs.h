// Chooses the chunks made here that are compared with the server's. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <talus/client/chunk_maker.h>
#include <talus/client/client.h>

namespace talus::client {

/// The first proofs come from four batches, the 1st, 4th, 9th and 16th: the first is nearest and proves at
/// once, all are spread over the View, and the server makes the columns of four patches for them. If there
/// are fewer batches, the rest come from all chunks that were made.
class Proofs {
 public:
  struct Proof {
    ChunkKey key;
    ContentHash hash;
  };

  explicit Proofs(std::uint64_t seed) : random_{seed} {}

  /// A connection begins: proofs are due as at the first.
  void begin() {
    first_ = kFirstProofs;
    batches_ = due_ = uncounted_ = sampled_ = 0;
    sample_.clear();
  }

  /// A batch was made; `mixed` are those of its chunks that have several materials and no edits. Returns the
  /// chunks to be compared. `last`: nothing else is to be made now.
  [[nodiscard]] std::vector<Proof> made(std::size_t chunks, std::vector<Proof> mixed, bool last);

  /// A comparison had no result: another takes its place.
  void repeat() { ++due_; }

 private:
  static constexpr std::size_t kInterval = kProofsTogether * kChunksPerProof;
  static constexpr std::size_t kMaxSample = 64;

  [[nodiscard]] std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>{0, count - 1}(random_);
  }

  std::mt19937_64 random_;
  std::size_t first_ = kFirstProofs;  // of the first, still due
  std::size_t batches_ = 0;           // with mixed chunks
  std::size_t due_ = 0;               // of the others
  std::size_t uncounted_ = 0;         // chunks made since some became due
  std::vector<Proof> sample_;         // of all chunks not compared, evenly
  std::size_t sampled_ = 0;           // chunks that could have come into it
};

}  // namespace talus::client
