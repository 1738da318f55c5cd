#include <talus/edits/chunk_overrides.h>

#include <array>
#include <map>
#include <memory>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::edits {
namespace {

using Map = std::map<std::uint16_t, MaterialId>;

std::vector<Override> list(const Map& map) {
  std::vector<Override> voxels;
  for (const auto& [index, material] : map) voxels.push_back({index, material});
  return voxels;
}

MaterialId any_material() {
  return MaterialId{*rc::gen::inRange<std::uint16_t>(0, 5)};
}

/// Up to `most` voxels among the first 64 and the last, so that they meet.
Map any_map(std::size_t most) {
  Map map;
  for (std::size_t left = *rc::gen::inRange<std::size_t>(0, most + 1); left > 0; --left) {
    const auto index =
        *rc::gen::oneOf(rc::gen::inRange<std::uint16_t>(0, 64), rc::gen::just<std::uint16_t>(32767));
    map[index] = any_material();
  }
  return map;
}

}  // namespace

TEST_CASE("overrides are as writes leave them, be they few or many") {
  CHECK(rc::check([] {
    Map model = any_map(64);
    ChunkOverrides overrides{list(model)};
    for (int round = 0; round < 4; ++round) {
      const std::size_t most = *rc::gen::element<std::size_t>(2, 64);
      std::vector<OverrideWrite> writes;
      for (const auto& [index, material] : any_map(most)) {
        const bool removes = *rc::gen::arbitrary<bool>();
        writes.push_back(removes ? OverrideWrite{index, {}} : OverrideWrite{index, material});
        if (removes) {
          model.erase(index);
        } else {
          model[index] = material;
        }
      }
      overrides.apply(writes);
      RC_ASSERT(overrides == ChunkOverrides{list(model)});
      RC_ASSERT(overrides.size() == model.size());
      for (std::uint16_t index = 0; index < 66; ++index) {
        const auto found = model.find(index);
        RC_ASSERT(overrides.find(index) ==
                  (found == model.end() ? std::nullopt : std::optional{found->second}));
      }
    }
  }));
}

TEST_CASE("one write among very many overrides moves only itself") {
  Map model;
  for (int index = 0; index < kChunkVolume; index += 2)
    model[static_cast<std::uint16_t>(index)] = MaterialId{7};
  ChunkOverrides overrides{list(model)};
  const std::array<OverrideWrite, 3> writes{
      {{1, MaterialId{3}}, {16384, std::nullopt}, {32766, MaterialId{9}}}};
  overrides.apply(writes);
  model[1] = MaterialId{3};
  model.erase(16384);
  model[32766] = MaterialId{9};
  CHECK(overrides == ChunkOverrides{list(model)});
}

TEST_CASE("writing the base's material removes the override, air as any") {
  CHECK(OverrideWrite::of(5, MaterialId{2}, MaterialId{2}) == OverrideWrite{5, std::nullopt});
  CHECK(OverrideWrite::of(5, kAir, kAir) == OverrideWrite{5, std::nullopt});
  CHECK(OverrideWrite::of(5, kAir, MaterialId{2}) == OverrideWrite{5, kAir});
}

TEST_CASE("merged over a base, overridden voxels are theirs and all others the base's") {
  CHECK(rc::check([] {
    const Map map = any_map(40);
    const MaterialId ground = any_material();
    Layers layers{{ground, kAir}, std::vector<std::uint8_t>(kChunkArea, 1)};
    const Chunk base = *rc::gen::arbitrary<bool>()
                           ? Chunk::from_layers(layers)
                           : Chunk::from_layers(layers).with_overrides(list(any_map(9)));
    const auto under = std::make_unique<DenseVoxels>();
    const auto merged = std::make_unique<DenseVoxels>();
    base.copy_to(*under);
    ChunkOverrides{list(map)}.merged_over(base).copy_to(*merged);
    for (const auto& [index, material] : map) (*under)[index] = material;
    RC_ASSERT(*merged == *under);
  }));
}

}  // namespace talus::edits
