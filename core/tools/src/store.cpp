#include <algorithm>
#include <utility>

#include <talus/store/stored_edits.h>

#include "land_edits.h"

namespace talus::tools {
namespace {

/// For a material with a permanent id that the world's file no longer contains.
constexpr terrain::Colour kForgotten{128, 128, 128};

class StoreOfEdits final : public LandEdits {
 public:
  StoreOfEdits(std::unique_ptr<store::StoredEdits> store, const terrain::World& world)
      : store_{std::move(store)} {
    for (const auto& [name, id] : store_->materials()) {
      if (to_integer(id) < world.materials().size()) continue;  // the world generates it
      const auto& placeables = world.placeables();
      const auto named = std::ranges::find(placeables, name, &terrain::Placeable::name);
      materials_.push_back(named == placeables.end()
                               ? terrain::Material{id, name, kForgotten, terrain::MaterialKind::stratified}
                               : terrain::Material{id, name, named->colour, named->kind});
    }
    std::ranges::sort(materials_, {}, &terrain::Material::id);
  }

  ContentHash store_id() const override { return store_->store_id(); }
  std::uint64_t revision() const override { return store_->revision(); }
  const std::vector<terrain::Material>& materials() const override { return materials_; }
  ChunkRange edited_rows(ChunkKey key) const override { return store_->edited_rows(key); }
  Expected<edits::ChunkOverrides> overrides(ChunkKey key) const override {
    auto found = store_->overrides(key);
    if (!found) return failed(std::move(found.error()));
    return *std::move(found);
  }

 private:
  const std::unique_ptr<store::StoredEdits> store_;
  std::vector<terrain::Material> materials_;
};

}  // namespace

Expected<std::unique_ptr<const LandEdits>> open_store(const std::string& directory,
                                                      const terrain::World& world) {
  auto store = store::StoredEdits::open(directory, world.fingerprint());
  if (!store) return failed(std::move(store.error()));
  return std::make_unique<const StoreOfEdits>(*std::move(store), world);
}

}  // namespace talus::tools
