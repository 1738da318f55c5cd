// A builder's unanswered edits, in the order that the protocol requires: each with its sequence; edits sent
// before, after a lost connection or a temporary refusal, precede new ones. No I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <talus/voxel/material.h>

#include "pending_chunks.h"

namespace talus::load {

struct OpenWrite {
  std::size_t cell = 0;
  MaterialId material{};
  Time due{};
  bool in_flight = false;
};

class OpenWrites {
 public:
  [[nodiscard]] std::size_t size() const { return open_.size(); }
  [[nodiscard]] bool empty() const { return open_.empty(); }

  /// Adds an edit to be sent; returns its sequence.
  std::uint64_t add(const OpenWrite& write);
  /// Marks the first edit that is not in flight as in flight; nullopt if all are.
  [[nodiscard]] std::optional<std::uint64_t> send_next();
  [[nodiscard]] const OpenWrite& at(std::uint64_t sequence) const { return open_.at(sequence); }

  [[nodiscard]] static std::uint32_t id_of(std::uint64_t sequence) {
    return static_cast<std::uint32_t>(sequence % 0x7FFF'FFFF) + 1;
  }
  /// The sequence of an edit in flight; nullopt if the id is unknown.
  [[nodiscard]] std::optional<std::uint64_t> in_flight(std::uint32_t id) const;

  /// Removes an answered edit.
  OpenWrite take(std::uint64_t sequence);
  /// To be sent again with its sequence.
  void put_back(std::uint64_t sequence) { open_.at(sequence).in_flight = false; }
  /// Was not applied, and must be: to be sent with a new sequence.
  void renew(std::uint64_t sequence) {
    OpenWrite write = take(sequence);
    write.in_flight = false;
    (void)add(write);
  }
  /// The connection broke.
  void put_all_back();
  /// The server has decided all edits up to `last_sequence`. If it no longer knows the editor, returns the
  /// edits with unknown outcome.
  [[nodiscard]] std::vector<OpenWrite> attached(bool known, std::uint64_t last_sequence);

 private:
  std::map<std::uint64_t, OpenWrite> open_;  // by sequence
  std::uint64_t last_sequence_ = 0;
};

}  // namespace talus::load
