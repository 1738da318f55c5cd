#include <talus/terrain/stacks.h>

#include <algorithm>
#include <array>
#include <utility>

#include <talus/terrain/settle.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/strata.h>
#include <talus/terrain/surface.h>

namespace talus::terrain {
namespace {

std::vector<std::int64_t> base_columns(std::int64_t first, int count, Lod lod) {
  std::vector<std::int64_t> columns(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i] = (first + static_cast<std::int64_t>(i)) * (std::int64_t{1} << lod.value());
  }
  return columns;
}

// LOD 0 heights and slopes at the columns of a region.
struct Ground {
  Field height;
  Field slope;
};

Ground ground_of(const Surface& surface, const Region& region) {
  if (region.lod.value() == 0) {
    const Region around = region.grown(1);
    Field heights{around.width, around.depth};
    sample_surface(surface, base_columns(around.x, around.width, around.lod),
                   base_columns(around.z, around.depth, around.lod), heights.values);
    return {heights.without_ring(1), slope_inside(heights)};
  }
  // Coarse columns lie apart: each row takes three base rows, each column three base columns.
  const std::vector<std::int64_t> xs = base_columns(region.x, region.width, region.lod);
  const std::vector<std::int64_t> zs = base_columns(region.z, region.depth, region.lod);
  std::vector<std::int64_t> triple_xs;
  for (const std::int64_t x : xs) triple_xs.insert(triple_xs.end(), {x - 1, x, x + 1});
  Ground ground{Field{region.width, region.depth}, Field{region.width, region.depth}};
  Field triple{3 * region.width, 3};
  for (int z = 0; z < region.depth; ++z) {
    const std::int64_t base_z = zs[static_cast<std::size_t>(z)];
    sample_surface(surface, triple_xs, std::array{base_z - 1, base_z, base_z + 1}, triple.values);
    const Field slopes = slope_inside(triple);  // of base columns 1 to 3 * width - 2
    for (int x = 0; x < region.width; ++x) {
      ground.height.at(x, z) = triple.at(3 * x + 1, 1);
      ground.slope.at(x, z) = slopes.at(3 * x, 0);
    }
  }
  return ground;
}

// The settled thickness of one material over the inside of `slope`, which reaches `ring` columns past it.
Field settled(const LooseSpec& loose, Lod lod, const Field& slope, int ring) {
  Field thickness = starting_thickness(slope, loose.thickness_at(lod), loose.S_fx);
  settle(thickness, loose.c_fx);
  return thickness.without_ring(ring);
}

}  // namespace

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

Terrain generate_terrain_with_halo(const World& world, const Region& region, int halo) {
  const Surface surface = surface_of(world.spec());
  const int ring = halo - 1;  // the outermost column of the halo serves the slope alone
  const Ground ground = ground_of(surface, region.grown(ring));
  const int shift = region.lod.value();

  Terrain terrain;
  terrain.region = region;
  terrain.surface = ground.height.without_ring(ring);
  Strata strata = lay_strata(world, base_columns(region.x, region.width, region.lod),
                             base_columns(region.z, region.depth, region.lod), terrain.surface, shift);
  terrain.strata_materials = std::move(strata.materials);
  terrain.strata = std::move(strata.tops);
  for (std::int32_t& height : terrain.surface.values) height >>= shift;
  terrain.slope = ground.slope.without_ring(ring);
  for (const LooseSpec& loose : world.loose()) {
    terrain.loose.push_back(settled(loose, region.lod, ground.slope, ring));
  }
  return terrain;
}

Terrain generate_terrain(const World& world, const Region& region) {
  return generate_terrain_with_halo(world, region, std::max(1, halo_columns(world, region.lod)));
}

Stacks stack_layers(const World& world, const Terrain& terrain) {
  // `lowered` walks down from H: the top of the material whose turn it is, lightest first.
  Field lowered = terrain.surface;
  std::vector<Field> loose_tops;  // top down
  std::vector<MaterialId> loose_materials;
  for (auto m = world.loose_bottom_up().rbegin(); m != world.loose_bottom_up().rend(); ++m) {
    const Field& thickness = terrain.loose[*m];
    loose_tops.push_back(lowered);
    loose_materials.push_back(world.loose()[*m].material);
    for (std::size_t i = 0; i < lowered.values.size(); ++i) {
      lowered.values[i] = std::max(lowered.values[i] - thickness.values[i], 0);
    }
  }

  Stacks stacks;
  stacks.region = terrain.region;
  const auto add_plane = [&](MaterialId material, Field top) {
    // The first plane stays even where it is empty: its material goes on below y = 0.
    if (!stacks.tops.empty() && top.values == stacks.tops.back().values) return;
    stacks.materials.push_back(material);
    stacks.tops.push_back(std::move(top));
  };
  for (std::size_t p = 0; p < terrain.strata.size(); ++p) {
    Field top = terrain.strata[p];
    for (std::size_t i = 0; i < top.values.size(); ++i) {
      top.values[i] = std::min(top.values[i], lowered.values[i]);
    }
    add_plane(terrain.strata_materials[p], std::move(top));
  }
  for (std::size_t p = loose_tops.size(); p-- > 0;) add_plane(loose_materials[p], std::move(loose_tops[p]));
  return stacks;
}

Stacks generate_stacks(const World& world, const Region& region) {
  return stack_layers(world, generate_terrain(world, region));
}

std::vector<std::int32_t> surface_heights(const World& world, std::span<const BaseColumn> columns) {
  const Surface surface = surface_of(world.spec());
  std::vector<std::int32_t> heights(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    sample_surface(surface, {&columns[i].x, 1}, {&columns[i].z, 1}, {&heights[i], 1});
  }
  return heights;
}

}  // namespace talus::terrain
