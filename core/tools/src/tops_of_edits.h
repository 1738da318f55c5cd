// Changes by edits to the land as seen from above.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include <talus/map/edited_tops.h>
#include <talus/terrain/world.h>
#include <talus/tools/failure.h>

#include "land_edits.h"

namespace talus::tools {

class TopsOfEdits final : public map::EditedTops {
 public:
  /// Both must outlive this object.
  TopsOfEdits(const terrain::World& world, const LandEdits& edits) : world_{world}, edits_{edits} {}

  const std::vector<terrain::Material>& materials() const override { return edits_.materials(); }
  /// Generates the columns of edited chunks.
  std::vector<map::EditedTop> find(const terrain::Region& region) const override;

  /// The first chunk that could not be read, or that shows an unnamed material; its columns are reported as
  /// generated.
  [[nodiscard]] std::optional<Failure> failure() const;

 private:
  struct ColumnTop;
  using Column = std::vector<ColumnTop>;  // of 32 x 32 columns, z slowest
  void fail(Failure failure) const;
  void add_tops(ChunkKey column, const terrain::Region& region, std::vector<map::EditedTop>& tops) const;

  const terrain::World& world_;
  const LandEdits& edits_;
  mutable std::mutex mutex_;
  mutable std::optional<Failure> failure_;
};

}  // namespace talus::tools
