#include "local/land.h"

#include <utility>

#include <talus.h>
#include <talus/terrain/heights.h>

namespace talus::c_api {
namespace {

std::uint32_t phase_of(terrain::MaterialKind kind) {
  switch (kind) {
    case terrain::MaterialKind::air:
      return TALUS_GAS;
    case terrain::MaterialKind::water:
      return TALUS_LIQUID;
    default:
      return TALUS_SOLID;
  }
}

template <typename Listed>
LandMaterial material_of(MaterialId id, const Listed& material) {
  const terrain::Colour colour = material.colour;
  const std::uint32_t rgb = static_cast<std::uint32_t>(colour.red) << 16 |
                            static_cast<std::uint32_t>(colour.green) << 8 | colour.blue;
  return {id, material.name, rgb, phase_of(material.kind)};
}

}  // namespace

Land::Land(saves::WorldSource source, bool settles)
    : world_{source.world}, source_{std::move(source)}, edits_{{settles, {}}} {
  list_materials();
}

Land::Land(saves::Save save) : world_{save.world()}, save_{std::move(save)} {
  list_materials();
}

void Land::list_materials() {
  for (const terrain::Material& material : world_->materials()) {
    materials_.push_back(material_of(material.id, material));
  }
  const std::vector<MaterialId>& ids = edits().settings().placeables;
  std::size_t index = 0;
  for (const terrain::Placeable& placeable : world_->placeables()) {
    const MaterialId id = ids.empty() ? local::placeable_id(index) : ids[index];
    materials_.push_back(material_of(id, placeable));
    ++index;
  }
}

VoxelPos Land::spawn() const {
  std::call_once(spawn_once_, [this] { spawn_ = terrain::find_spawn(*world_); });
  return spawn_;
}

Land::State Land::state() const {
  const std::shared_lock lock{reading_};
  State state{revision_, edits().hash(), edits().settings().settles, save_.has_value(), unsaved_};
  if (save_) state.revision = save_->revision();
  return state;
}

Chunk Land::merged_over(ChunkKey key, const Chunk& generated) const {
  const std::shared_lock lock{reading_};
  return edits().merged_over(key, generated);
}

std::vector<ChunkCoord> Land::changed_chunks() const {
  const std::shared_lock lock{reading_};
  return edits().changed_chunks();
}

tl::expected<Land::Applied, edits::EditError> Land::apply(local::Workspace& workspace,
                                                          const edits::Edit& edit) {
  const std::lock_guard changes{changing_};
  const std::lock_guard lock{reading_};
  const bool was_unsaved = std::exchange(unsaved_, true);  // stays so if memory runs out after the edit
  auto outcome = save_ ? save_->apply(workspace, edit) : edits_.apply(workspace, edit);
  if (!outcome || outcome->changed == 0) unsaved_ = was_unsaved;
  if (!outcome) return tl::unexpected{std::move(outcome.error())};
  if (!save_ && outcome->changed > 0) ++revision_;
  return Applied{*std::move(outcome), save_ ? save_->revision() : revision_};
}

std::optional<saves::Result<void>> Land::create_save(const std::filesystem::path& file) {
  const std::lock_guard changes{changing_};
  if (save_) return std::nullopt;
  auto save = saves::Save::create(file, *source_, edits_, revision_);
  if (!save) return saves::Result<void>{tl::unexpected{std::move(save.error())}};
  const std::lock_guard lock{reading_};
  save_ = *std::move(save);
  edits_ = {};
  source_.reset();
  unsaved_ = false;
  return saves::Result<void>{};
}

std::optional<saves::Result<void>> Land::commit() {
  const std::lock_guard changes{changing_};
  if (!save_) return std::nullopt;
  auto done = save_->commit();
  if (done) {
    const std::lock_guard lock{reading_};
    unsaved_ = false;
  }
  return done;
}

}  // namespace talus::c_api
