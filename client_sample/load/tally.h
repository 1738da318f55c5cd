// What was seen, a role. Each worker has its own; they are merged at the end.
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
  /// Waits of chunks from the scheduled time of the View that first wanted them: `join` for the first View
  /// and after a jump, `travel` for what later steps added. What never came, or left the View before it
  /// came, counts with the time for which it was waited.
  measure::Histogram join, travel;
  measure::Histogram requests;     // from GetChunks to its answer
  measure::Histogram first_chunk;  // from the scheduled time of connecting
  measure::Histogram full_view;    // to the last chunk of the first View, and of Views after a jump
  measure::Histogram horizon;      // the same, to the last chunk of its rings, too
  measure::Histogram near;         // from the scheduled time of a View until its two nearest rings were there
  measure::Histogram returns;      // from when a connection was lost until then
  measure::Histogram back;         // from then, or GoAway, until Welcome and Pong, and until Attached
  measure::Histogram full_again;   // from when it was lost to the last chunk of the View
  measure::Histogram edit_ack;     // from the scheduled time of an edit to its EditResult
  measure::Histogram edit_arrival;             // from there until another player of its place saw it
  measure::Histogram edit_other_server;        // the same, of players at another server
  std::chrono::nanoseconds longest_without{};  // any chunk, of one player that waited for some

  /// Chunks that came n View steps after the one that wanted them; the last place counts all beyond.
  std::array<std::uint64_t, 8> late_steps{};

  std::uint64_t chunks = 0, chunk_bytes = 0;  // Chunk messages
  std::uint64_t uniform = 0;                  // chunks that came in UniformColumns
  std::uint64_t unchanged = 0;
  std::uint64_t stale = 0;        // left the View when they were on their way
  std::uint64_t repeated = 0;     // came twice after leaving and coming back: allowed
  std::uint64_t updated = 0;      // came whole again, as it was edited
  std::uint64_t missed = 0;       // left the View before they came
  std::uint64_t unconfirmed = 0;  // left and came back, and the server said no more: allowed
  std::uint64_t verified = 0;     // decoded, and hashed
  std::uint64_t unanswered = 0;   // had not come when the drain was over: late, or lost
  std::string first_unanswered;

  std::uint64_t edits = 0;          // acknowledged
  std::uint64_t edited_voxels = 0;  // that they changed
  std::uint64_t edit_arrivals = 0;  // at other players
  std::uint64_t edits_unknown = 0;  // the server has forgotten who sent them
  std::uint64_t edits_missing = 0;  // acknowledged, and not seen by a player when the drain was over
  std::string first_missing;
  std::string first_refused;  // what the server said of an edit or an Attach

  // Errors of the server, each of them.
  std::uint64_t bad_chunks = 0;  // not decodable, of another hash or codec
  std::uint64_t outside = 0;     // nobody asked for them
  std::uint64_t duplicates = 0;
  std::uint64_t bad_messages = 0;
  std::string first_wrong;

  std::uint64_t ordered = 0, disordered = 0;  // chunks whose order was looked at; those beyond the tolerance
  std::int64_t worst_ring_gap = 0;

  std::uint64_t joins = 0, cuts = 0;
  std::uint64_t reconnects = 0;                 // joins after a connection was lost
  std::uint64_t new_patches = 0;                // squares of --patch-tiles that came into a player's View
  std::map<std::string, std::uint64_t> errors;  // Error messages, by code
  std::map<std::string, std::uint64_t> disconnects;  // not asked for, by reason

  void merge(const Tally& other);
  /// Counts and remembers the first.
  void wrong(std::uint64_t& counter, const std::string& what);
  void never_came(const std::string& what);
  [[nodiscard]] std::uint64_t wrongs() const { return bad_chunks + outside + duplicates + bad_messages; }
  [[nodiscard]] std::uint64_t error_count() const;
  [[nodiscard]] std::uint64_t disconnect_count() const;
};

using Tallies = std::array<Tally, kRoles>;

}  // namespace talus::load
