// Counts a store's contents by reading all of it, and verifies its consistency.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/state_hash.h>
#include <talus/progress/progress_bar.h>
#include <talus/store/read_only_store.h>

namespace talus::server {

struct StoreFigures {
  struct Level {
    std::uint64_t chunks = 0;  // with overrides
    std::uint64_t voxels = 0;
    edits::StateHash hash;      // of the stored overrides
    edits::StateHash expected;  // of the overrides derived from level 0; unused for level 0
  };
  std::array<Level, Lod::kMax + 1> levels;
  std::uint64_t emptied_chunks = 0;  // of any level: all edits were undone
  std::uint64_t editors = 0;
  std::map<MaterialId, std::uint64_t> materials;  // voxels of level 0
};

[[nodiscard]] tl::expected<StoreFigures, std::string> read_figures(const store::ReadOnlyStore& store,
                                                                   ProgressBar& progress);

/// Counts voxels of level 0 by material, showing its own progress bar.
[[nodiscard]] tl::expected<std::map<MaterialId, std::uint64_t>, std::string> voxels_by_material(
    const store::ReadOnlyStore& store);

/// Checks that the state hash and the coarse levels match level 0, and that the kept log is complete. An
/// error is one line that names the inconsistency.
[[nodiscard]] tl::expected<void, std::string> verify(const store::ReadOnlyStore& store,
                                                     const StoreFigures& figures);

}  // namespace talus::server
