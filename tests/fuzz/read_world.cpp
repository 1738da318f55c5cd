// Any text as a world file: refused in one line, or a world that makes chunks without a seam.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>

namespace {

using namespace talus;
using namespace talus::terrain;

// More would make runs slow; other tests have such worlds.
constexpr int kMaxErosion = 4;
constexpr std::size_t kMaxStrata = 64;

void check(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  const auto world = World::parse(text, "world.toml");
  if (!world) {
    check(!world.error().message.empty());
    check(world.error().message.find('\n') == std::string::npos);
    return 0;
  }
  check(World::parse(text, "again.toml")->fingerprint() == world->fingerprint());
  if (world->spec().erosion_steps > kMaxErosion || world->strata().size() > kMaxStrata) return 0;
  const Lod lod = Lod::of(static_cast<int>(size % (Lod::kMax + 1)));
  const Region patch{-kChunkSize, 0, 2 * kChunkSize, kChunkSize, lod};
  const Stacks stacks = generate_stacks(*world, patch);
  const MixedRange rows = mixed_range(*world, stacks, 0, 0);
  if (rows.last < rows.first) return 0;
  const ChunkKey key{{0, rows.first, 0}, lod};
  check(extract_chunk(*world, stacks, key.coord) == generate_chunk(*world, key));
  return 0;
}
