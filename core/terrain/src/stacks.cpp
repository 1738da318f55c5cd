#include <talus/terrain/stacks.h>

#include <algorithm>
#include <utility>

#include <talus/terrain/surface.h>

#include "ground.h"
#include "kernels/columns.h"
#include "layers_of_rock.h"
#include "loose_cells.h"
#include "surface_rows.h"

namespace talus::terrain {
namespace {

void base_columns(std::int64_t first, int count, Lod lod, std::vector<std::int64_t>& columns) {
  columns.clear();
  for (int i = 0; i < count; ++i) columns.push_back((first + i) * (std::int64_t{1} << lod.value()));
}

void lower(const ColumnKernels& kernels, std::span<const std::int32_t> top, const std::int16_t* thickness,
           std::span<std::int32_t> lowered) {
  kernels.lower_int16(top.data(), thickness, top.size(), lowered.data());
}

void lower(const ColumnKernels& kernels, std::span<const std::int32_t> top, const std::int32_t* thickness,
           std::span<std::int32_t> lowered) {
  kernels.lower_int32(top.data(), thickness, top.size(), lowered.data());
}

void shift_right(Field& field, int shift) {
  if (shift == 0) return;
  for (std::int32_t& value : field.values) value >>= shift;
}

}  // namespace

struct Generator::Scratch {
  explicit Scratch(const World& world)
      : set{instruction_set()},
        ground{surface_of(world.spec()), set},
        rock{world, set},
        cells{set},
        columns{column_kernels(set)} {}

  InstructionSet set;
  Ground ground;
  LayersOfRock rock;
  LooseCells cells;
  const ColumnKernels& columns;
  std::vector<std::int64_t> xs;
  std::vector<std::int64_t> zs;
  Field limit;
  std::vector<Field> loose_tops;  // bottom up
  std::vector<Field> spare;
};

std::size_t Stacks::bytes() const {
  std::size_t bytes = sizeof(Stacks) + materials.size() * sizeof(MaterialId) + tops.size() * sizeof(Field);
  for (const Field& plane : tops) bytes += plane.values.size() * sizeof(std::int32_t);
  return bytes;
}

int halo_columns(const World& world, Lod lod) {
  int halo = 0;
  for (const LooseSpec& loose : world.loose()) halo = std::max(halo, loose.halo_at(lod));
  return halo;
}

Generator::Generator(const World& world) : world_{&world}, scratch_{std::make_unique<Scratch>(world)} {}
Generator::~Generator() = default;
Generator::Generator(Generator&&) noexcept = default;
Generator& Generator::operator=(Generator&&) noexcept = default;

void Generator::generate(const Region& region, Terrain& terrain) {
  generate_with_halo(region, std::max(1, halo_columns(*world_, region.lod)), terrain);
}

void Generator::generate_with_halo(const Region& region, int halo, Terrain& terrain) {
  Scratch& s = *scratch_;
  const int ring = halo - 1;  // the outermost column of the halo serves the slope alone
  const int shift = region.lod.value();
  s.ground.cover(region.grown(ring));
  terrain.region = region;
  s.ground.height().copy_inside(ring, terrain.surface);
  s.ground.slope().copy_inside(ring, terrain.slope);

  base_columns(region.x, region.width, region.lod, s.xs);
  base_columns(region.z, region.depth, region.lod, s.zs);
  Planes strata{terrain.strata_materials, terrain.strata, s.spare};
  s.rock.lay(s.xs, s.zs, terrain.surface, LayersOfRock::Extent::all, strata);
  for (Field& plane : terrain.strata) shift_right(plane, shift);
  shift_right(terrain.surface, shift);

  terrain.loose.resize(world_->loose().size());
  for (std::size_t m = 0; m < terrain.loose.size(); ++m) {
    const LooseSpec& loose = world_->loose()[m];
    s.cells.start(s.ground.slope(), loose.thickness_at(region.lod), loose.S_fx);
    s.cells.settle(loose.c_fx);
    terrain.loose[m].reshape(region.width, region.depth);
    for (int z = 0; z < region.depth; ++z) {
      s.cells.with_row(z + ring, [&](const auto* row) {
        std::copy_n(row + ring, region.width, terrain.loose[m].row(z).begin());
      });
    }
  }
}

void Generator::generate(const Region& region, Stacks& stacks) {
  Scratch& s = *scratch_;
  const int ring = std::max(1, halo_columns(*world_, region.lod)) - 1;
  const int shift = region.lod.value();
  s.ground.cover(region.grown(ring));
  stacks.region = region;

  // `limit` walks down from H: the top of the loose material whose turn it is, lightest first, then of rock.
  s.ground.height().copy_inside(ring, s.limit);
  shift_right(s.limit, shift);
  const std::vector<std::size_t>& bottom_up = world_->loose_bottom_up();
  s.loose_tops.resize(bottom_up.size());
  for (std::size_t i = bottom_up.size(); i-- > 0;) {
    const LooseSpec& loose = world_->loose()[bottom_up[i]];
    s.cells.start(s.ground.slope(), loose.thickness_at(region.lod), loose.S_fx);
    s.cells.settle(loose.c_fx);
    std::swap(s.loose_tops[i], s.limit);
    s.limit.reshape(region.width, region.depth);
    for (int z = 0; z < region.depth; ++z) {
      s.cells.with_row(z + ring, [&](const auto* row) {
        lower(s.columns, s.loose_tops[i].row(z), row + ring, s.limit.row(z));
      });
    }
  }

  base_columns(region.x, region.width, region.lod, s.xs);
  base_columns(region.z, region.depth, region.lod, s.zs);
  // Rock is laid in subvoxels of level 0.
  if (shift > 0) {
    for (std::int32_t& value : s.limit.values) value <<= shift;
  }
  Planes planes{stacks.materials, stacks.tops, s.spare};
  s.rock.lay(s.xs, s.zs, s.limit, LayersOfRock::Extent::until_full, planes);
  for (Field& plane : stacks.tops) shift_right(plane, shift);
  for (std::size_t i = 0; i < bottom_up.size(); ++i) {
    std::swap(planes.add(world_->loose()[bottom_up[i]].material), s.loose_tops[i]);
  }
}

Terrain generate_terrain(const World& world, const Region& region) {
  Terrain terrain;
  Generator{world}.generate(region, terrain);
  return terrain;
}

Stacks generate_stacks(const World& world, const Region& region) {
  Stacks stacks;
  Generator{world}.generate(region, stacks);
  return stacks;
}

std::vector<std::int32_t> surface_heights(const World& world, std::span<const BaseColumn> columns) {
  const auto rows = make_surface_rows(surface_of(world.spec()), instruction_set());
  std::vector<std::int32_t> heights(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    rows->start({&columns[i].x, 1});
    rows->row(columns[i].z, &heights[i]);
  }
  return heights;
}

}  // namespace talus::terrain
