#include <algorithm>
#include <random>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/client/chunk_store.h>

namespace talus::client {
namespace {

constexpr MaterialId kFiller{777};
constexpr int kEdge = 3 * kChunkSize;

ReceivedChunk received(const ChunkKey& key, Chunk chunk) {
  return {key, 0, content_hash(chunk), std::make_shared<const Chunk>(std::move(chunk))};
}

// 3 x 3 x 3 chunks as one dense array, the plainest thing that an apron can be compared with.
class Block {
 public:
  Block() : voxels_(static_cast<std::size_t>(kEdge) * kEdge * kEdge) {}
  MaterialId& at(int x, int y, int z) {
    return voxels_[static_cast<std::size_t>((y * kEdge + z) * kEdge + x)];
  }

 private:
  std::vector<MaterialId> voxels_;
};

// A chunk of one of the three forms, by `form`.
std::vector<MaterialId> voxels_of(int form, std::mt19937_64& random) {
  std::vector<MaterialId> voxels(kChunkVolume, MaterialId{static_cast<std::uint16_t>(random() % 5)});
  if (form == 0) return voxels;
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const auto top = static_cast<int>(random() % 33);
      for (int y = 0; y < kChunkSize; ++y) {
        const LocalPos pos{static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                           static_cast<std::uint8_t>(z)};
        auto& voxel = voxels[voxel_index(pos)];
        if (form == 1) voxel = y < top ? MaterialId{2} : kAir;
        if (form == 2) voxel = MaterialId{static_cast<std::uint16_t>(random() % 3)};
      }
    }
  }
  return voxels;
}

Chunk chunk_of(int form, const std::vector<MaterialId>& voxels) {
  if (form != 1) return Chunk::from_dense(std::span<const MaterialId, kChunkVolume>{voxels});
  Layers layers{{MaterialId{2}, kAir}, std::vector<std::uint8_t>(kChunkArea)};
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    std::size_t top = 0;
    while (top < kChunkSize && voxels[top * kChunkArea + column] == MaterialId{2}) ++top;
    layers.tops[column] = static_cast<std::uint8_t>(top);
  }
  return Chunk::from_layers(std::move(layers));
}

}  // namespace

TEST_CASE("an apron is the cut of one big array around the chunk") {
  const bool held = rc::check("apron equals array", [](std::uint64_t seed) {
    std::mt19937_64 random{seed};
    const ChunkKey middle{{static_cast<int>(random() % 100) - 50, -1, 7}, Lod::of(2)};
    ChunkStore store{std::size_t{64} << 20};
    Block block;
    ApronGaps missing;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) {
          const bool absent = random() % 4 == 0;
          const auto form = static_cast<int>(random() % 3);
          auto voxels = voxels_of(form, random);
          if (absent) {
            voxels.assign(kChunkVolume, kFiller);
            missing.set(neighbour_index(dx, dy, dz));
          } else {
            const ChunkKey key{{middle.coord.x + dx, middle.coord.y + dy, middle.coord.z + dz}, middle.lod};
            store.put(received(key, chunk_of(form, voxels)));
          }
          for (int i = 0; i < kChunkVolume; ++i) {
            block.at((dx + 1) * kChunkSize + i % kChunkSize, (dy + 1) * kChunkSize + i / kChunkArea,
                     (dz + 1) * kChunkSize + i / kChunkSize % kChunkSize) =
                voxels[static_cast<std::size_t>(i)];
          }
        }
      }
    }
    for (int width = 0; width <= kMaxApron; ++width) {
      std::vector<MaterialId> out(apron_volume(width));
      const auto gaps = store.apron(middle, width, kFiller, out);
      if (width > 0) RC_ASSERT(gaps == missing);
      if (width == 0) RC_ASSERT(gaps[neighbour_index(0, 0, 0)] == missing[neighbour_index(0, 0, 0)]);
      const int edge = kChunkSize + 2 * width;
      const int corner = kChunkSize - width;
      std::vector<MaterialId> cut;
      cut.reserve(out.size());
      for (int y = 0; y < edge; ++y) {
        for (int z = 0; z < edge; ++z) {
          for (int x = 0; x < edge; ++x) cut.push_back(block.at(corner + x, corner + y, corner + z));
        }
      }
      RC_ASSERT(out == cut);
    }
  });
  REQUIRE(held);
}

TEST_CASE("beyond the world's edge neighbours are missing") {
  ChunkStore store{std::size_t{64} << 20};
  const ChunkKey edge{{INT32_MAX, 0, INT32_MIN}, Lod{}};
  store.put(received(edge, Chunk::uniform(MaterialId{2})));
  std::vector<MaterialId> out(apron_volume(1));
  const auto gaps = store.apron(edge, 1, kFiller, out);
  CHECK(gaps.count() == 26);
  CHECK(out[0] == kFiller);
}

TEST_CASE("a full store lets go of what was unused for longest") {
  const auto key = [](int x) { return ChunkKey{{x, 0, 0}, Lod{}}; };
  const auto put = [&](ChunkStore& store, int x) {
    std::mt19937_64 random{static_cast<std::uint64_t>(x)};
    store.put(received(key(x), chunk_of(2, voxels_of(2, random))));
  };
  ChunkStore store{3 * (sizeof(DenseVoxels) + 1024)};
  for (int x = 0; x < 3; ++x) put(store, x);
  REQUIRE(store.size() == 3);
  REQUIRE(store.find(key(0)) != nullptr);
  put(store, 3);
  CHECK(store.contains(key(0)));
  CHECK_FALSE(store.contains(key(1)));
  CHECK(store.bytes() <= 3 * (sizeof(DenseVoxels) + 1024));
}

TEST_CASE("a store's bytes equal the bytes of its contents") {
  const bool held = rc::check("empty is zero", [](const std::vector<std::uint8_t>& xs) {
    ChunkStore store{std::size_t{1} << 20};
    for (const auto x : xs) store.put(received({{x % 8, 0, 0}, Lod{}}, Chunk::uniform(MaterialId{x})));
    for (int x = 0; x < 8; ++x) store.erase({{x, 0, 0}, Lod{}});
    RC_ASSERT(store.size() == 0U);
    RC_ASSERT(store.bytes() == 0U);
  });
  REQUIRE(held);
}

}  // namespace talus::client
