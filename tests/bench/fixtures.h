// What benchmarks work on: the same for the clock and for the instruction counter.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>

/// Calls `work`. Named for the instruction counter's --toggle-collect: not mangled, and in a file of its own
/// callers' sight so that no caller takes it in.
extern "C" void talus_counted_work(const std::function<void()>& work);

namespace talus::bench {

/// `count` neighbouring columns from `first` on.
[[nodiscard]] std::vector<std::int64_t> line(std::int64_t first, int count);

/// core/worlds/classic.toml: what codecs and stages are measured by.
[[nodiscard]] const terrain::World& classic_world();

/// The mixed chunks over 8 x 8 tiles of a world, spread over four places far apart.
[[nodiscard]] std::vector<Chunk> mixed_chunks(const terrain::World& world = classic_world(), Lod lod = {});

/// Sections to add to the classic world: what may lie in its ground.
inline constexpr const char* kFolds =
    "[folds]\namplitude = 0.16\nwavelength = 1.1\nstrike = 30\nstretch = 5\n";
inline constexpr const char* kFaults =
    "[[faults]]\nstrike = 20\nspacing = 0.7\nthrow = 0.14\nwaviness = 0.05\n"
    "[[faults]]\nstrike = 110\nspacing = 1.6\nthrow = 0.2\nwaviness = 0.08\n";
inline constexpr const char* kOre =
    "[[veins]]\nname = \"coal\"\ncolour = \"#101014\"\nshape = \"vein\"\nlow = 0.1\nhigh = 1.4\nsize = 0.5\n"
    "thickness = 0.025\nabundance = 0.5\n"
    "[[veins]]\nname = \"silver\"\ncolour = \"#dfe8f5\"\nshape = \"vein\"\nlow = 0.0\nhigh = 0.9\nsize = "
    "0.35\n"
    "thickness = 0.015\nabundance = 0.35\n"
    "[[veins]]\nname = \"copper\"\ncolour = \"#2fb39a\"\nshape = \"pocket\"\nlow = 0.0\nhigh = 0.8\nsize = "
    "0.12\n"
    "abundance = 0.06\n"
    "[[veins]]\nname = \"gold\"\ncolour = \"#ffcf26\"\nshape = \"pocket\"\nlow = 0.0\nhigh = 1.2\nsize = "
    "0.06\n"
    "abundance = 0.03\n";
[[nodiscard]] terrain::World classic_world_with(const std::string& sections);

/// The text of core/worlds/NAME.toml, and its world.
[[nodiscard]] std::string text_of_world(const std::string& name);
[[nodiscard]] terrain::World sample_world(const std::string& name);

/// tests/load/rough.toml by another seed, its features `times` as wide: layers that swell and fade within two
/// voxels or some more.
[[nodiscard]] terrain::World rough_world(std::uint32_t seed, int times);

/// A sample world without its [caves].
[[nodiscard]] terrain::World without_caves(const std::string& name);

/// The chunks over 8 x 8 tiles of the features world that its caves change; or what they would be without.
[[nodiscard]] std::vector<Chunk> cave_chunks(bool with_caves);

/// The chunk with a winding tunnel through everything but air: still layers, with air between them.
[[nodiscard]] Chunk with_hole(const Chunk& chunk);

/// The chunk after somebody dug a pit and built a small house: dense voxels.
[[nodiscard]] Chunk edited(const Chunk& chunk);

/// Voxels of `materials` materials in runs of `run` on average.
[[nodiscard]] Chunk random_chunk(std::uint32_t seed, unsigned materials, unsigned run);

/// The patches that a view of `radius` chunks around the origin needs, nearest first.
[[nodiscard]] std::vector<terrain::Region> patches_of_view(int radius, int patch_tiles);

}  // namespace talus::bench
