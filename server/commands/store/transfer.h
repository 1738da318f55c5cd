// Exports and imports a store's edits, and moves them to another world. The new store is built separately and
// replaces the old one at the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>
#include <talus/store/read_only_store.h>
#include <talus/terrain/world.h>

namespace talus::server {

struct ExportResult {
  std::uint64_t chunks = 0;
  std::uint64_t voxels = 0;
};
[[nodiscard]] tl::expected<ExportResult, std::string> export_edits(const store::ReadOnlyStore& store,
                                                                   const std::filesystem::path& file);

enum class Winner : std::uint8_t { file, store };

struct Rebuilt {
  std::uint64_t chunks = 0;  // in the new store
  std::uint64_t voxels = 0;
  std::uint64_t both = 0;     // import: voxels in both the file and the store
  bool compared = false;      // import: the materials that the world generates were known
  std::uint64_t as_base = 0;  // rebase: overrides equal to the new world's generated voxels
  std::uint64_t unknown = 0;  // rebase: overrides of materials that the new world lacks
  ContentHash fingerprint;    // import: of the world
  ContentHash store_id;
  std::filesystem::path replaced;  // where the previous store is kept; empty: there was none
};

/// Merges the file's edits into the store in `directory`, or creates a store of the file's world there.
/// `winner` decides voxels that both have. Materials are matched by name. Rejects a file with voxels of a
/// placed material whose name the store's world generates, voxels of a generated material that the file's
/// world does not generate, or names that a world may not use. The generated materials come from `world` if
/// it is the file's world, otherwise from the store if it has their names; `world` may be null. The new
/// store's time is the later of the store's and the file's, the latter capped at `now_ms`, since 1970.
[[nodiscard]] tl::expected<Rebuilt, std::string> import_edits(const std::filesystem::path& file,
                                                              const store::DataDirectory& directory,
                                                              Winner winner, std::int64_t now_ms,
                                                              const terrain::World* world = nullptr);

/// Moves the store's edits to another world: drops overrides equal to the generated voxels, and matches
/// materials by name. Fails if the world lacks some materials, unless `drop_unknown`. A store already of that
/// world is rejected, unless the world's file has lost a placeable, so that there are voxels to drop.
[[nodiscard]] tl::expected<Rebuilt, std::string> rebase_edits(const store::DataDirectory& directory,
                                                              const terrain::World& world, bool drop_unknown);

/// Returns the ids of the world's materials in a rebased store, by name: generated materials have the world's
/// ids; placeable ones keep the id that the store gave them, if it was a placed material's. Fails if ids run
/// out.
[[nodiscard]] tl::expected<std::map<std::string, MaterialId>, std::string> rebased_materials(
    const std::map<std::string, MaterialId>& stored, const terrain::World& world);

}  // namespace talus::server
