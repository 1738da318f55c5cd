// A world and one player's edits, kept in one file. Edits are those of local::Edits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <span>

#include <talus/local/edits.h>
#include <talus/local/local.h>
#include <talus/saves/save_error.h>
#include <talus/saves/save_file.h>

namespace talus::saves {

/// A world and all that a save must hold to make it again.
struct WorldSource {
  std::shared_ptr<const local::World> world;
  SavedWorld saved;
};

/// Reads a world's file, and with `files` those that it names.
[[nodiscard]] tl::expected<WorldSource, local::SpecProblem> read_world(std::span<const std::byte> toml,
                                                                       const local::FileReader& files = {});

/// Checks what an opened file says about its world, and makes that. Refuses other generator versions and
/// fingerprints.
[[nodiscard]] Result<std::shared_ptr<const local::World>> world_of(const SaveFile& file);

/// Not thread-safe; any number of threads may use const methods while none modifies it.
class Save {
 public:
  /// Creates a save of a world with `edits`, which have the ids of `source.saved.materials`.
  [[nodiscard]] static Result<Save> create(const std::filesystem::path& file, const WorldSource& source,
                                           local::Edits edits = {}, std::uint64_t revision = 0);
  /// Reads all of a save, and compares S.
  [[nodiscard]] static Result<Save> open(const std::filesystem::path& file, Access access = Access::write);

  [[nodiscard]] const std::shared_ptr<const local::World>& world() const { return world_; }
  [[nodiscard]] const local::Edits& edits() const { return edits_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// True if edits were applied that commit() has not kept.
  [[nodiscard]] bool has_changes() const { return all_changed_ || !changed_.empty(); }
  [[nodiscard]] const SaveFile& file() const { return file_; }

  /// Applies an edit in memory: local::Edits::apply().
  tl::expected<local::EditOutcome, edits::EditError> apply(local::Workspace& workspace,
                                                           const edits::Edit& edit);
  /// Returns when all edits applied before are on the disk. After an error none of them is, all are still
  /// applied, and the next call tries again.
  [[nodiscard]] Result<void> commit();

 private:
  Save(SaveFile file, std::shared_ptr<const local::World> world, local::Edits edits, std::uint64_t revision);

  SaveFile file_;
  std::shared_ptr<const local::World> world_;
  local::Edits edits_;
  std::uint64_t revision_ = 0;
  std::set<ChunkCoord> changed_;  // since the last commit
  bool all_changed_ = false;      // memory for a chunk of changed_ ran out
};

}  // namespace talus::saves
