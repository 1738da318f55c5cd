// What work for the generators is likely to cost, and how much of it may be in flight or put back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "chunks/generation/patch.h"

namespace talus::server {

/// In any unit, the same for all.
struct WorkCosts {
  std::uint64_t patch = 1;                           // to make one; at least 1
  std::uint64_t chunk = 0;                           // to make one of a patch
  std::uint64_t height = 0;                          // of a column
  std::function<bool(const PatchKey&)> in_memory{};  // whether the patch need not be made; unset: none is
  std::uint64_t longest_piece = UINT64_MAX;          // what is dearer gives way to others
  std::size_t max_in_flight = SIZE_MAX;              // pieces of one flow
  std::size_t max_begun = SIZE_MAX;                  // pieces that gave way, of all flows
  std::size_t max_begun_of_flow = SIZE_MAX;          // and of one
};

}  // namespace talus::server
