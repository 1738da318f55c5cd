// Why an edit or an Attach was not applied: one error from the log to the wire.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <tl/expected.hpp>

namespace talus::server {

enum class EditErrorCode : std::uint8_t {
  // Counted in talus_edits_refused_total, by kEditErrorNames.
  out_of_range,  // a bound of the world, the edit or the log's messages; or an unknown material
  ground,        // a chunk could not be generated
  half_closed,   // the client sends no more, and the edit needs chunks that are not generated yet
  busy,          // the queue or the server's memory is full, or the log stops
  unwritable,    // the store cannot be written now; whether the log has the entry is unknown
  index_full,    // the index of edited chunks has no room for a chunk that was never edited
  unreadable,    // the store cannot read the overrides of a chunk
  conflict,      // a guard does not hold
  not_applied,   // the sequence is too low, and no edit had it
  expired,       // not attached: another connection attached as the editor, or the editor was removed
  invalid,
  behind,        // Attach: the client has seen a later revision than this server's
  editors_full,  // Attach: the editor table is full
  overtaken,     // Attach: another connection attaches as the same editor
  cut_off,       // the shared log cannot be reached, and does not get the entry
  // Found by the session or by a command, and not counted.
  forbidden,
  unsupported,
  leaving,  // the session accepts no more requests
  too_many_unanswered,
  malformed,  // ends the connection
  too_large,
  unanswered,  // no proper answer: whether the log has the entry is unknown
};

/// Labels of the counted codes in metrics.
inline constexpr std::array<std::string_view, 15> kEditErrorNames{
    "out_of_range", "ground",     "half_closed",  "busy",        "unwritable",
    "index_full",   "unreadable", "conflict",     "not_applied", "expired",
    "invalid",      "behind",     "editors_full", "overtaken",   "cut_off"};

/// Returns true if the same entry may succeed later, and is harmless if it was applied already.
[[nodiscard]] constexpr bool is_transient(EditErrorCode code) {
  return code == EditErrorCode::busy || code == EditErrorCode::unwritable || code == EditErrorCode::cut_off;
}

struct EditError {
  EditErrorCode code{};
  std::string message;  // one line, for the client
};

[[nodiscard]] inline tl::unexpected<EditError> edit_error(EditErrorCode code, std::string message) {
  return tl::unexpected{EditError{code, std::move(message)}};
}

}  // namespace talus::server
