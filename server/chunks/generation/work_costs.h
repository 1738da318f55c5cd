// Estimated costs of work for the generators, and how much of it may be in flight or put back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "chunks/generation/patch.h"

namespace talus::server {

/// All in the same unit, which may be any.
struct WorkCosts {
  std::uint64_t patch = 1;                           // making a patch; at least 1
  std::uint64_t chunk = 0;                           // making a chunk of it
  std::uint64_t height = 0;                          // making the height of a column
  std::function<bool(const PatchKey&)> in_memory{};  // true if the patch need not be made; unset: never
  std::uint64_t longest_piece = UINT64_MAX;          // work that costs more yields to other work
  std::size_t max_in_flight = SIZE_MAX;              // maximum number of pieces of one flow
  std::size_t max_begun = SIZE_MAX;                  // maximum number of pieces that yielded, of all flows
  std::size_t max_begun_of_flow = SIZE_MAX;          // the same for one flow
  std::size_t max_open = SIZE_MAX;  // maximum number of expensive pieces that yielded or are in flight
  std::size_t max_open_of_flow = SIZE_MAX;  // the same for one flow
};

}  // namespace talus::server
