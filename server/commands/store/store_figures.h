// What a store holds, counted by reading all of it, and whether it agrees with itself.
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
    std::uint64_t chunks = 0;  // that have overrides
    std::uint64_t voxels = 0;
    edits::StateHash hash;      // of its overrides
    edits::StateHash expected;  // of those that level 0 says; of level 0 nothing
  };
  std::array<Level, Lod::kMax + 1> levels;
  std::uint64_t emptied_chunks = 0;  // of any level: all their edits were undone
  std::uint64_t editors = 0;
  std::map<MaterialId, std::uint64_t> materials;  // voxels of level 0
};

[[nodiscard]] tl::expected<StoreFigures, std::string> read_figures(const store::ReadOnlyStore& store,
                                                                   ProgressBar& progress);

/// Voxels of level 0 by material, with a progress bar of its own.
[[nodiscard]] tl::expected<std::map<MaterialId, std::uint64_t>, std::string> voxels_by_material(
    const store::ReadOnlyStore& store);

/// Whether S and the coarse levels are what level 0 says, and the log is whole as far as it is kept. An error
/// is one line and names what is not as it must be.
[[nodiscard]] tl::expected<void, std::string> verify(const store::ReadOnlyStore& store,
                                                     const StoreFigures& figures);

}  // namespace talus::server
