#include "fixtures.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string_view>
#include <utility>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

void talus_counted_work(const std::function<void()>& work) {
  work();
  asm volatile("");  // else the call is a jump, and this function does not see its end
}

namespace talus::bench {

std::vector<std::int64_t> line(std::int64_t first, int count) {
  std::vector<std::int64_t> columns;
  for (int i = 0; i < count; ++i) columns.push_back(first + i);
  return columns;
}

std::vector<Chunk> mixed_chunks(const terrain::World& world, Lod lod) {
  constexpr int kTiles = 4;
  std::vector<Chunk> chunks;
  for (const std::int32_t place : {0, 40, 1000, -77}) {
    const terrain::Region patch{std::int64_t{place} * kChunkSize, std::int64_t{place} * kChunkSize,
                                kTiles * kChunkSize, kTiles * kChunkSize, lod};
    const terrain::Stacks stacks = generate_stacks(world, patch);
    for (std::int32_t i = 0; i < kTiles * kTiles; ++i) {
      const std::int32_t x = place + i % kTiles;
      const std::int32_t z = place + i / kTiles;
      const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first; y <= rows.last; ++y) {
        chunks.push_back(extract_chunk(world, stacks, {x, y, z}));
      }
    }
  }
  std::erase_if(chunks, [](const Chunk& chunk) { return chunk.is_uniform(); });
  return chunks;
}

std::string text_of(const std::string& path) {
  std::ifstream file{TALUS_SOURCE_DIR "/" + path};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::string text_of_world(const std::string& name) {
  return text_of("core/worlds/" + name + ".toml");
}

const terrain::World& classic_world() {
  static const terrain::World world = terrain::World::parse(text_of_world("classic"), "classic").value();
  return world;
}

terrain::World classic_world_with(const std::string& sections) {
  return terrain::World::parse(text_of_world("classic") + "\n" + sections, "classic").value();
}

terrain::World sample_world(const std::string& name) {
  return terrain::World::parse(text_of_world(name), name).value();
}

terrain::World rough_world(std::uint32_t seed, int times) {
  std::string text = text_of("tests/load/rough.toml");
  const auto replace = [&text](std::string_view key, const std::string& value) {
    const std::size_t from = text.find("\n" + std::string{key} + " =") + 1;
    text.replace(from, text.find('\n', from) - from, std::string{key} + " = " + value);
  };
  const std::string wavelength = "0." + std::string(times < 5 ? 1 : 0, '0') + std::to_string(2 * times);
  replace("seed", std::to_string(seed));
  replace("wavelength", wavelength);
  replace("strata_wavelength", wavelength);
  return terrain::World::parse(text, "rough").value();
}

terrain::World without_caves(const std::string& name) {
  std::string text = text_of_world(name);
  const std::size_t from = text.find("\n[caves]") + 1;
  text.erase(from, text.find("\n[", from) - from);
  return terrain::World::parse(text, name).value();
}

std::vector<Chunk> cave_chunks(bool with_caves) {
  constexpr int kTiles = 8;
  const terrain::World world = sample_world("features");
  const terrain::World twin = without_caves("features");
  const terrain::Region patch{0, 0, kTiles * kChunkSize, kTiles * kChunkSize, Lod{}};
  const terrain::Stacks stacks = generate_stacks(world, patch);
  const terrain::Stacks twin_stacks = generate_stacks(twin, patch);
  std::vector<Chunk> chunks;
  for (std::int32_t i = 0; i < kTiles * kTiles; ++i) {
    const std::int32_t x = i % kTiles;
    const std::int32_t z = i / kTiles;
    const terrain::MixedRange rows = mixed_range(world, stacks, x, z);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      Chunk chunk = extract_chunk(world, stacks, {x, y, z});
      Chunk whole = extract_chunk(twin, twin_stacks, {x, y, z});
      if (chunk == whole) continue;
      chunks.push_back(std::move(with_caves ? chunk : whole));
    }
  }
  return chunks;
}

Chunk with_hole(const Chunk& chunk) {
  const Layers& whole = *chunk.layers();
  Layers holed;
  std::array<std::uint8_t, kChunkArea> floor{};
  for (std::size_t m = 0; m < whole.materials.size(); ++m) {
    const bool top = m + 1 == whole.materials.size();
    std::array<std::uint8_t, kChunkArea> ceiling;
    for (std::size_t i = 0; i < kChunkArea; ++i) ceiling[i] = top ? kChunkSize : whole.plane(m)[i];
    if (whole.materials[m] != kAir) {
      for (const bool high : {false, true}) {
        holed.materials.push_back(high ? kAir : whole.materials[m]);
        for (int i = 0; i < kChunkArea; ++i) {
          const int x = i % kChunkSize;
          const int middle_z = 10 + x * x / 37 % 13;
          const int half = std::max(0, 5 - std::abs(i / kChunkSize - middle_z));
          const int edge = half == 0 ? 0 : 12 + x / 8 + (high ? half : -half);
          const auto column = static_cast<std::size_t>(i);
          holed.tops.push_back(
              static_cast<std::uint8_t>(std::clamp<int>(edge, floor[column], ceiling[column])));
        }
      }
    }
    holed.materials.push_back(whole.materials[m]);
    if (!top) holed.tops.insert(holed.tops.end(), ceiling.begin(), ceiling.end());
    floor = ceiling;
  }
  return Chunk::from_layers(std::move(holed));
}

Chunk edited(const Chunk& chunk) {
  constexpr MaterialId kPlanks{200};
  const auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  const auto at = [&voxels](int x, int y, int z) -> MaterialId& {
    return (*voxels)[static_cast<std::size_t>((y * kChunkSize + z) * kChunkSize + x)];
  };
  for (int y = 0; y < kChunkSize; ++y) {
    for (int z = 0; z < kChunkSize; ++z) {
      for (int x = 0; x < kChunkSize; ++x) {
        const int dx = x - 9;
        const int dy = y - 18;
        const int dz = z - 11;
        if (dx * dx + dy * dy + dz * dz < 36) at(x, y, z) = kAir;
        const bool in_house = x >= 18 && x < 25 && y >= 14 && y < 19 && z >= 17 && z < 23;
        const bool inside = x > 18 && x < 24 && y > 14 && y < 18 && z > 17 && z < 22;
        if (in_house) at(x, y, z) = inside ? kAir : kPlanks;
      }
    }
  }
  return Chunk::from_dense(*voxels);
}

Chunk random_chunk(std::uint32_t seed, unsigned materials, unsigned run) {
  std::mt19937 random{seed};
  const auto voxels = std::make_unique<DenseVoxels>();
  MaterialId material{};
  for (MaterialId& voxel : *voxels) {
    if (random() % run == 0) material = MaterialId{static_cast<std::uint16_t>(random() % materials)};
    voxel = material;
  }
  return Chunk::from_dense(*voxels);
}

std::vector<terrain::Region> patches_of_view(int radius, int patch_tiles) {
  const int columns = patch_tiles * kChunkSize;
  const auto first = static_cast<int>(floor_div(-radius, patch_tiles));
  const auto last = static_cast<int>(floor_div(radius, patch_tiles));
  std::vector<terrain::Region> patches;
  for (int z = first; z <= last; ++z) {
    for (int x = first; x <= last; ++x) {
      patches.push_back({std::int64_t{x} * columns, std::int64_t{z} * columns, columns, columns, Lod{}});
    }
  }
  std::stable_sort(patches.begin(), patches.end(), [](const terrain::Region& a, const terrain::Region& b) {
    return a.x * a.x + a.z * a.z < b.x * b.x + b.z * b.z;
  });
  return patches;
}

}  // namespace talus::bench
