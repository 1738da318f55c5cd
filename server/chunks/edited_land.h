// Finds edited land by place, without fetching chunks.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::server {

/// Edge of a region in columns of chunks. Regions are aligned, each of one level.
inline constexpr std::int32_t kRegionColumns = 32;

/// An edited column of chunks, by its place in its region.
struct EditedColumn {
  std::uint16_t place = 0;     // (z mod 32) * 32 + x mod 32
  std::uint64_t revision = 0;  // maximum of its chunks' revisions
  bool operator==(const EditedColumn&) const = default;
};

/// Callable from any thread; reads only memory.
class EditedLand {
 public:
  virtual ~EditedLand() = default;

  /// Revision of the newest edit; 0 without edits.
  [[nodiscard]] virtual std::uint64_t revision() const = 0;
  /// Returns true if edits are accepted now.
  [[nodiscard]] virtual bool takes_edits() const = 0;

  /// Maximum revision of the chunks of the key's column; 0 if it was never edited. Raised after all chunks of
  /// the edit, so a caller that sees it finds the edited chunks.
  [[nodiscard]] virtual std::uint64_t column_revision(ChunkKey key) const = 0;
  /// The range of rows that contains all edited chunks of the column; empty if it was never edited.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;
  /// The edited columns of the region that contains the key's column, by ascending place.
  [[nodiscard]] virtual std::vector<EditedColumn> edited_columns(ChunkKey key) const = 0;
};

}  // namespace talus::server
