// Why edits, and who wants to edit, are refused: by this operators see it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

enum class EditRefused : std::uint8_t {
  out_of_range,  // it breaks a bound, or a material is none of the world
  ground,        // the chunk as generated failed
  half_closed,   // the client sends no more, and the edit needs ground that is not generated yet
  busy,
  unwritable,  // the store cannot be written now
  index_full,  // too many chunks were edited
  unreadable,  // a chunk's edits cannot be read
  conflict,
  not_applied,
  expired,
  invalid,
  // Of an Attach.
  behind,        // the client has seen more than this server has
  editors_full,  // as many edit as may
  overtaken,     // others attach as the same editor
  // Of both.
  cut_off,  // the log that servers share cannot be reached
};

/// Their label in metrics.
inline constexpr std::array<std::string_view, 15> kEditRefusedNames{
    "out_of_range", "ground",     "half_closed",  "busy",        "unwritable",
    "index_full",   "unreadable", "conflict",     "not_applied", "expired",
    "invalid",      "behind",     "editors_full", "overtaken",   "cut_off"};

}  // namespace talus::server
