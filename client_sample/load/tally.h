// Observations of one role. Each worker has its own; they are merged at the end.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "measure/histogram.h"
#include "role.h"

namespace talus::load {

struct Tally {
  /// Waits of chunks from the scheduled time of the View that first wanted them: `join` for first Views and
  /// after jumps, `travel` for chunks added by later steps. A chunk that never arrived, or left the View
  /// before, counts with the time waited.
  measure::Histogram join, travel;
  measure::Histogram requests;           // from GetChunks to the answer
  measure::Histogram first_chunk;        // from the scheduled time of connecting
  measure::Histogram full_view;          // to the last chunk of the first View, and of Views after a jump
  measure::Histogram horizon;            // the same, including the last chunk of the rings
  measure::Histogram near;               // from the scheduled time of a View until its two nearest rings were
                                         // complete
  measure::Histogram returns;            // from a lost connection until these rings were complete
  measure::Histogram back;               // from a lost connection or GoAway until Welcome and Pong, and until
                                         // Attached
  measure::Histogram full_again;         // from a lost connection to the last chunk of the View
  measure::Histogram edit_ack;           // from the scheduled time of an edit to its EditResult
  measure::Histogram edit_arrival;       // from the same time until another player of its place saw it
  measure::Histogram edit_other_server;  // the same for players at another server
  std::chrono::nanoseconds longest_without{};  // without any chunk, for a player that waited for some

  /// Chunks that arrived n View steps after the one that wanted them; the last element counts all later ones.
  std::array<std::uint64_t, 8> late_steps{};

  std::uint64_t chunks = 0, chunk_bytes = 0;  // Chunk messages
  std::uint64_t uniform = 0;                  // chunks in UniformColumns
  std::uint64_t unchanged = 0;
  std::uint64_t made = 0;                       // chunks that real players would have made
  std::uint64_t proofs = 0, failed_proofs = 0;  // of them, compared with the server's
  std::uint64_t stale = 0;                      // left the View while in flight
  std::uint64_t repeated = 0;                   // arrived twice after leaving and returning: allowed
  std::uint64_t updated = 0;                    // sent again completely because of an edit
  std::uint64_t missed = 0;                     // left the View before they arrived
  std::uint64_t unconfirmed = 0;  // left and returned, and the server sent nothing more: allowed
  std::uint64_t verified = 0;     // decoded and hashed
  std::uint64_t unanswered = 0;   // missing at the end of the drain: late, or lost
  std::string first_unanswered;

  std::uint64_t edits = 0;          // acknowledged
  std::uint64_t edited_voxels = 0;  // changed by them
  std::uint64_t edit_arrivals = 0;  // at other players
  std::uint64_t edits_unknown = 0;  // the server no longer knows the editor
  std::uint64_t edits_missing = 0;  // acknowledged, but not seen by a player at the end of the drain
  std::string first_missing;
  std::string first_refused;  // the server's text for an edit or an Attach

  // Errors of the server, by kind.
  std::uint64_t bad_chunks = 0;  // not decodable, or of another hash or codec
  std::uint64_t outside = 0;     // never requested
  std::uint64_t duplicates = 0;
  std::uint64_t bad_messages = 0;
  std::string first_wrong;

  std::uint64_t ordered = 0, disordered = 0;  // chunks whose order was checked; number beyond the tolerance
  std::int64_t worst_ring_gap = 0;

  std::uint64_t joins = 0, cuts = 0;
  std::uint64_t reconnects = 0;                      // joins after a lost connection
  std::uint64_t new_patches = 0;                     // squares of --patch-tiles that entered a player's View
  std::map<std::string, std::uint64_t> errors;       // Error messages, by code
  std::map<std::string, std::uint64_t> disconnects;  // unexpected ones, by reason

  void merge(const Tally& other);
  /// Increments `counter` and keeps the first text.
  void wrong(std::uint64_t& counter, const std::string& what);
  void never_came(const std::string& what);
  [[nodiscard]] std::uint64_t wrongs() const { return bad_chunks + outside + duplicates + bad_messages; }
  [[nodiscard]] std::uint64_t error_count() const;
  [[nodiscard]] std::uint64_t disconnect_count() const;
};

using Tallies = std::array<Tally, kRoles>;

}  // namespace talus::load
