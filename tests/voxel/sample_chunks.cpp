#include "sample_chunks.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

#include <rapidcheck.h>

#include <talus/voxel/codec.h>

namespace talus::testing {
namespace {

/// std::mt19937_64 is the same everywhere; the standard's distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_{seed} {}
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }
  int within(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1)));
  }

 private:
  std::mt19937_64 engine_;
};

std::uint8_t row(int y) {
  return static_cast<std::uint8_t>(std::clamp(y, 0, kChunkSize));
}

}  // namespace

Layers random_layers(std::uint64_t seed, std::size_t planes, int smoothness) {
  Random random{seed};
  Layers layers;
  for (std::size_t i = 0; i <= planes; ++i) {
    layers.materials.push_back(MaterialId{static_cast<std::uint16_t>(random.below(5))});
  }
  std::vector<std::uint8_t> floor(kChunkArea, 0);
  for (std::size_t p = 0; p < planes; ++p) {
    int thickness = random.within(0, 8);
    for (std::uint8_t& top : floor) {
      if (random.within(0, smoothness) == 0) thickness = random.within(0, 8);
      top = row(top + thickness);
    }
    layers.tops.insert(layers.tops.end(), floor.begin(), floor.end());
  }
  return layers;
}

Layers with_large_ids(Layers layers) {
  for (MaterialId& material : layers.materials) {
    material = MaterialId{static_cast<std::uint16_t>(to_integer(material) + 20000)};
  }
  return layers;
}

Layers leaping_layers(std::uint64_t seed, std::size_t planes) {
  Random random{seed};
  Layers layers;
  for (std::size_t i = 0; i <= planes; ++i) {
    layers.materials.push_back(MaterialId{static_cast<std::uint16_t>(i % 2 == 0 ? 7 : random.below(5))});
  }
  std::vector<std::uint8_t> floor(kChunkArea, 0);
  for (std::size_t p = 0; p < planes; ++p) {
    const std::size_t leaps = 1 + random.below(40);
    int height = 0;
    for (std::uint8_t& top : floor) {
      if (random.below(leaps) == 0) {
        height = random.below(2) == 0 ? random.within(0, kChunkSize) : kChunkSize * random.within(0, 1);
      }
      top = std::max(top, row(height));
    }
    layers.tops.insert(layers.tops.end(), floor.begin(), floor.end());
  }
  return layers;
}

Layers hill(std::uint64_t seed) {
  Random random{seed};
  const int foot = random.within(2, 12);
  const int rise = random.within(4, 24);
  const int peak_x = random.within(0, kChunkSize - 1);
  const int peak_z = random.within(0, kChunkSize - 1);
  const int sea = random.within(0, 16);
  Layers layers{{MaterialId{4}, MaterialId{3}, MaterialId{4}, MaterialId{7}, kWater, kAir}, {}};
  layers.tops.resize(layers.plane_count() * kChunkArea);
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const int away = std::abs(x - peak_x) + 2 * std::abs(z - peak_z);
      const int surface = foot + rise * 16 / (16 + away);
      const int loose = std::clamp((away - 8) / 6, 0, 2);
      const int tops[] = {foot / 2 + (x + z) / 16, foot / 2 + 3 + x / 8, surface - loose, surface,
                          std::max(surface, sea)};
      int floor = 0;
      for (std::size_t p = 0; p < std::size(tops); ++p) {
        const bool loose_or_water = p >= 3;
        floor = std::max(floor, loose_or_water ? tops[p] : std::min(tops[p], surface - loose));
        layers.tops[p * kChunkArea + column_index(x, z)] = row(floor);
      }
    }
  }
  return layers;
}

std::unique_ptr<DenseVoxels> random_voxels(std::uint64_t seed, std::size_t materials, std::size_t run) {
  Random random{seed};
  auto voxels = std::make_unique<DenseVoxels>();
  MaterialId material{};
  for (MaterialId& voxel : *voxels) {
    // Ids spread over all 65,536, so that their numbers take one to three bytes.
    if (random.below(run) == 0) {
      material = MaterialId{static_cast<std::uint16_t>(random.below(materials) * (0xFFFF / materials))};
    }
    voxel = material;
  }
  return voxels;
}

Chunk with_random_overrides(const Chunk& chunk, std::uint64_t seed) {
  Random random{seed};
  std::vector<Override> overrides;
  for (int lumps = random.within(1, 9); lumps > 0; --lumps) {
    auto index = random.below(kChunkVolume);
    const MaterialId material{static_cast<std::uint16_t>(1000 + random.below(7))};
    for (int size = random.within(1, 100); size > 0; --size) {
      overrides.push_back({static_cast<std::uint16_t>(index % kChunkVolume), material});
      constexpr std::size_t kSteps[] = {1, kChunkSize, kChunkArea};
      index += kSteps[random.below(3)];
    }
  }
  return chunk.with_overrides(overrides);
}

std::unique_ptr<DenseVoxels> voxels_of(const Chunk& chunk) {
  auto voxels = std::make_unique<DenseVoxels>();
  chunk.copy_to(*voxels);
  return voxels;
}

std::vector<std::byte> encoded(const Chunk& chunk) {
  std::vector<std::byte> payload;
  encode(chunk, payload);
  return payload;
}

std::vector<std::byte> frozen(int version, const std::string& name) {
  std::ifstream file{TALUS_SOURCE_DIR "/tests/voxel/golden/v" + std::to_string(version) + "/" + name + ".bin",
                     std::ios::binary};
  if (!file) throw std::runtime_error("no golden payload " + name);
  std::vector<std::byte> payload;
  for (std::istreambuf_iterator<char> byte{file}, end; byte != end; ++byte) {
    payload.push_back(static_cast<std::byte>(*byte));
  }
  return payload;
}

Chunk any_chunk() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>().as("seed of the chunk");
  switch (*rc::gen::inRange(0, 9).as("kind of chunk")) {
    case 0:
      return Chunk::uniform(MaterialId{static_cast<std::uint16_t>(seed)});
    case 1:
      return Chunk::from_layers(hill(seed));
    case 2: {
      const auto planes = *rc::gen::inRange<std::size_t>(1, Layers::kMaxMaterials).as("planes");
      return Chunk::from_layers(random_layers(seed, planes, *rc::gen::inRange(0, 64).as("smoothness")));
    }
    case 5:
      return Chunk::from_layers(leaping_layers(seed, *rc::gen::inRange<std::size_t>(1, 9).as("planes")));
    case 6:
      return with_random_overrides(Chunk::from_layers(hill(seed)), seed);
    case 7:
      return Chunk::from_dense(*voxels_of(with_random_overrides(Chunk::from_layers(hill(seed)), seed)));
    case 3:
      return Chunk::from_dense(*random_voxels(seed, *rc::gen::inRange<std::size_t>(1, 9).as("materials"),
                                              *rc::gen::inRange<std::size_t>(1, 200).as("run")));
    case 8: {
      // Whole waves of one material behind noise, or before it.
      const auto voxels = std::make_shared<DenseVoxels>(
          *random_voxels(seed, *rc::gen::inRange<std::size_t>(2, 300).as("materials"), 1));
      const auto plane = *rc::gen::inRange<std::size_t>(0, kChunkSize).as("plane");
      std::fill(voxels->begin() + static_cast<std::ptrdiff_t>(plane * kChunkArea), voxels->end(),
                MaterialId{1});
      if (seed % 2 == 0) std::reverse(voxels->begin(), voxels->end());
      return Chunk::from_dense(std::shared_ptr<const DenseVoxels>{voxels});
    }
    default:
      return Chunk::from_dense(*random_voxels(seed, *rc::gen::inRange<std::size_t>(1, 40000).as("materials"),
                                              *rc::gen::inRange<std::size_t>(1, 4).as("run")));
  }
}

}  // namespace talus::testing
