// A store's edits to a file and back, and from one world to another. The new store is made beside the one
// that is there and takes its place at the end.
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

struct Exported {
  std::uint64_t chunks = 0;
  std::uint64_t voxels = 0;
};
[[nodiscard]] tl::expected<Exported, std::string> export_edits(const store::ReadOnlyStore& store,
                                                               const std::filesystem::path& file);

enum class Winner : std::uint8_t { file, store };

struct Rebuilt {
  std::uint64_t chunks = 0;  // that the store has now
  std::uint64_t voxels = 0;
  std::uint64_t both = 0;     // import: voxels that both had
  bool compared = false;      // import: whether it was known what the world generates
  std::uint64_t as_base = 0;  // rebase: overrides that are as the new world generates
  std::uint64_t unknown = 0;  // rebase: overrides of materials that the new world has not
  ContentHash store_id;
  std::filesystem::path replaced;  // where the store is that was there; empty: there was none
};

/// Adds the file's edits to those of the store in `directory`, or makes one there, of the file's world.
/// `winner` has the voxels that both have. Materials are those of the same names: a
/// file with voxels of a placed one whose name is that of a generated one in the store is refused, and so is
/// one with voxels of what the file's world does not generate, and one with names that no world may give.
/// What that generates `world` says where it is that one, else the store where it has the names; null: no
/// world is known. The new store's time is the file's where the store's is
/// earlier, but at most `now_ms`, since 1970.
[[nodiscard]] tl::expected<Rebuilt, std::string> import_edits(const std::filesystem::path& file,
                                                              const store::DataDirectory& directory,
                                                              Winner winner, std::int64_t now_ms,
                                                              const terrain::World* world = nullptr);

/// The store's edits over another world: overrides that are as that generates go, materials are those of the
/// same names. Where the world lacks some, nothing happens, unless those voxels may go. A store of that world
/// has something to lose where the world's file has lost a placeable; else it is refused.
[[nodiscard]] tl::expected<Rebuilt, std::string> rebase_edits(const store::DataDirectory& directory,
                                                              const terrain::World& world, bool drop_unknown);

/// The ids that a rebased store gives to the world's materials, by name: those that the world generates have
/// theirs, what else may be placed keeps the id that it has in the store, where that was one for it. An error
/// is that no id is left.
[[nodiscard]] tl::expected<std::map<std::string, MaterialId>, std::string> rebased_materials(
    const std::map<std::string, MaterialId>& stored, const terrain::World& world);

}  // namespace talus::server
