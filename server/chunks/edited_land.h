// Which land was edited, for those who ask by place before they ask for chunks.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/view_shape.h>

namespace talus::server {

/// Columns of chunks along each side of a region. Regions are aligned, each of one level.
inline constexpr std::int32_t kRegionColumns = 32;

/// A column of chunks that was edited, in its region.
struct EditedColumn {
  std::uint16_t place = 0;     // (z mod 32) * 32 + x mod 32
  std::uint64_t revision = 0;  // the greatest of its chunks'
  bool operator==(const EditedColumn&) const = default;
};

/// Callable from any thread; reads memory alone.
class EditedLand {
 public:
  virtual ~EditedLand() = default;

  /// Of the newest edit of all; 0: there was none.
  [[nodiscard]] virtual std::uint64_t revision() const = 0;
  /// Whether edits are taken now.
  [[nodiscard]] virtual bool takes_edits() const = 0;

  /// The greatest revision of the chunks of the key's column; 0: none was ever edited. It is raised after all
  /// chunks of its edit: who finds it here finds those.
  [[nodiscard]] virtual std::uint64_t column_revision(ChunkKey key) const = 0;
  /// Rows of the column's chunks that were ever edited lie in this span; empty: none was.
  [[nodiscard]] virtual ChunkRange edited_rows(ChunkKey key) const = 0;
  /// The edited columns of the region that has the key's column, by rising place.
  [[nodiscard]] virtual std::vector<EditedColumn> edited_columns(ChunkKey key) const = 0;
};

}  // namespace talus::server
