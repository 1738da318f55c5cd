// A player's chunks that it makes itself and compares with the server's, as client::Client does. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <talus/client/client.h>

namespace talus::load {

class Proofs {
 public:
  /// A connection begins: all proofs of the one before are forgotten.
  void begin() { *this = Proofs{}; }
  /// The player makes this many more chunks. Returns how many proofs it owes then.
  [[nodiscard]] std::size_t made(std::size_t chunks) {
    uncounted_ += chunks;
    constexpr std::size_t kInterval = client::kProofsTogether * client::kChunksPerProof;
    const std::size_t due = std::exchange(first_, 0) + uncounted_ / kInterval * client::kProofsTogether;
    uncounted_ %= kInterval;
    return due;
  }

  struct Proof {
    ChunkKey key;
    ContentHash hash;
  };
  /// A proof is sent; returns the id of its request.
  [[nodiscard]] std::uint32_t sent(const Proof& proof) {
    open_.emplace(++last_id_, proof);
    return last_id_;
  }
  /// The proof that this request asked for, which is answered; nullopt: none did.
  [[nodiscard]] std::optional<Proof> answered(std::uint32_t id) {
    const auto found = open_.find(id);
    if (found == open_.end()) return std::nullopt;
    const Proof proof = found->second;
    open_.erase(found);
    return proof;
  }

 private:
  std::size_t first_ = client::kFirstProofs;
  std::size_t uncounted_ = 0;  // chunks made since some were due
  std::uint32_t last_id_ = 0;
  std::map<std::uint32_t, Proof> open_;
};

}  // namespace talus::load
