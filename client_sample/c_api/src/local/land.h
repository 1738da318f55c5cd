// Definition of talus_local_world: a world, the edits made in it, and their save.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>
#include <vector>

#include <talus/local/edits.h>
#include <talus/saves/save.h>
#include <talus/voxel/coords.h>

namespace talus::c_api {

struct LandMaterial {
  MaterialId id{};
  std::string name;
  std::uint32_t colour = 0;  // 0xRRGGBB
  std::uint32_t phase = 0;   // TALUS_GAS, TALUS_LIQUID, TALUS_SOLID
};

/// Any thread may call anything at any time.
class Land {
 public:
  Land(saves::WorldSource source, bool settles);
  explicit Land(saves::Save save);

  [[nodiscard]] const std::shared_ptr<const local::World>& world() const { return world_; }
  [[nodiscard]] const std::vector<LandMaterial>& materials() const { return materials_; }
  [[nodiscard]] VoxelPos spawn() const;

  struct State {
    std::uint64_t revision = 0;
    edits::StateHash hash;
    bool settles = false;
    bool has_save = false;
    bool unsaved = false;
  };
  [[nodiscard]] State state() const;
  [[nodiscard]] Chunk merged_over(ChunkKey key, const Chunk& generated) const;
  [[nodiscard]] std::vector<ChunkCoord> changed_chunks() const;

  struct Applied {
    local::EditOutcome outcome;
    std::uint64_t revision = 0;
  };
  [[nodiscard]] tl::expected<Applied, edits::EditError> apply(local::Workspace& workspace,
                                                              const edits::Edit& edit);
  /// nullopt: it has a save already.
  [[nodiscard]] std::optional<saves::Result<void>> create_save(const std::filesystem::path& file);
  /// nullopt: it has no save.
  [[nodiscard]] std::optional<saves::Result<void>> commit();

 private:
  [[nodiscard]] const local::Edits& edits() const { return save_ ? save_->edits() : edits_; }
  void list_materials();

  std::shared_ptr<const local::World> world_;
  std::vector<LandMaterial> materials_;
  mutable std::once_flag spawn_once_;
  mutable VoxelPos spawn_;
  // Who changes edits or the save holds `changing_`, and `reading_` exclusively while edits change: the disk
  // is waited for while others read.
  std::mutex changing_;
  mutable std::shared_mutex reading_;
  std::optional<saves::WorldSource> source_;  // for a save to come
  local::Edits edits_;                        // while there is no save
  std::uint64_t revision_ = 0;
  std::optional<saves::Save> save_;
  bool unsaved_ = false;  // commit() has not kept all edits
};

}  // namespace talus::c_api
