// A save's file: a database of SQLite, as ../../../FORMAT.md specifies it. Knows no world: Save (save.h)
// does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/edits/materials.h>
#include <talus/edits/state_hash.h>
#include <talus/saves/save_error.h>
#include <talus/voxel/coords.h>

namespace talus::saves {

inline constexpr int kSaveVersion = 1;

/// True if a file begins as those of SQLite do: it may be a save.
[[nodiscard]] bool is_database(const std::filesystem::path& file);

/// The world of a save, which never changes.
struct SavedWorld {
  std::string spec;                                     // the world's file
  std::map<std::string, std::vector<std::byte>> files;  // that it names
  int generator = 0;                                    // World::generator_version()
  std::string fingerprint;                              // 32 hexadecimal digits
  bool settles = false;                                 // loose material settles after an edit
  edits::MaterialIds materials;                         // all of them
  bool operator==(const SavedWorld&) const = default;
};

struct SaveState {
  std::uint64_t revision = 0;  // raised by each edit that changes something
  edits::StateHash hash;       // S, of all chunks
  bool operator==(const SaveState&) const = default;
};

struct SavedChunk {
  ChunkCoord chunk;
  std::vector<std::byte> runs;
};

enum class Access : std::uint8_t { read, write };

/// An open save. Not thread-safe. With Access::write no other process can open it, with Access::read none can
/// write it, until this object goes.
class SaveFile {
 public:
  /// Creates a save without chunks. A file that is there already is refused, unless it is empty.
  [[nodiscard]] static Result<SaveFile> create(const std::filesystem::path& file, const SavedWorld& world);
  /// Opens a save, completing or undoing what a killed process left. Reads any file safely.
  [[nodiscard]] static Result<SaveFile> open(const std::filesystem::path& file, Access access);
  ~SaveFile();
  SaveFile(SaveFile&&) noexcept;
  SaveFile& operator=(SaveFile&&) noexcept;

  [[nodiscard]] const SavedWorld& world() const;
  [[nodiscard]] const SaveState& state() const;
  [[nodiscard]] const std::filesystem::path& path() const;

  /// Reads the chunks one after another by rising x, z, y; nullopt after the last, then again from the first.
  /// Their runs are not checked.
  [[nodiscard]] Result<std::optional<SavedChunk>> next_chunk();

  /// Chunks put from here on are written together by commit(), durably, or not at all: after an error, or if
  /// the process is killed before commit() returned, the save is as before.
  [[nodiscard]] Result<void> begin();
  /// Sets a chunk's overrides (core/edits/FORMAT.md, Runs); the empty set removes the chunk.
  [[nodiscard]] Result<void> put(ChunkCoord chunk, std::span<const std::byte> runs);
  /// Removes all chunks.
  [[nodiscard]] Result<void> clear();
  [[nodiscard]] Result<void> commit(const SaveState& state);
  /// Drops what was put since begin(), if anything was.
  void roll_back() noexcept;

 private:
  struct Parts;
  explicit SaveFile(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::saves
