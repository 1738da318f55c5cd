// A builder's edits that are not answered yet, as the protocol wants them sent: each with its sequence, again
// after a lost connection and where the server refused it for now, those before the new ones. No I/O.
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

  /// A new one; returns its sequence. It is to be sent.
  std::uint64_t add(const OpenWrite& write);
  /// The first that is not on its way, which is then. None: all are.
  [[nodiscard]] std::optional<std::uint64_t> send_next();
  [[nodiscard]] const OpenWrite& at(std::uint64_t sequence) const { return open_.at(sequence); }

  [[nodiscard]] static std::uint32_t id_of(std::uint64_t sequence) {
    return static_cast<std::uint32_t>(sequence % 0x7FFF'FFFF) + 1;
  }
  /// The sequence of one that is on its way. None: none is by this id.
  [[nodiscard]] std::optional<std::uint64_t> in_flight(std::uint32_t id) const;

  /// It is answered.
  OpenWrite take(std::uint64_t sequence);
  /// It is to be sent again with its sequence.
  void put_back(std::uint64_t sequence) { open_.at(sequence).in_flight = false; }
  /// It did not happen, and shall: it is to be sent with a sequence of its own.
  void renew(std::uint64_t sequence) {
    OpenWrite write = take(sequence);
    write.in_flight = false;
    (void)add(write);
  }
  /// The connection broke.
  void put_all_back();
  /// The server has decided about all up to `last_sequence`. Where it does not know the editor any more,
  /// returns those of which nobody knows.
  [[nodiscard]] std::vector<OpenWrite> attached(bool known, std::uint64_t last_sequence);

 private:
  std::map<std::uint64_t, OpenWrite> open_;  // by sequence
  std::uint64_t last_sequence_ = 0;
};

}  // namespace talus::load
