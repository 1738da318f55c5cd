// Prints hashes of fixed regions of the sample worlds and compares them with golden.txt, which changes only
// together with the generator or the codec version. `--write` prints without comparing. `golden.txt N` makes
// and compares every Nth region, in each world others.
#include <xxhash.h>

#include <charconv>
#include <cstdint>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/vectors/instruction_set.h>
#include <talus/vectors/little_endian.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

#include "golden_worlds.h"
#include "made_height_map.h"
#include "random_regions.h"

namespace {

using namespace talus;
using namespace talus::test;

/// Hashes of all chunks' voxels, and all payloads.
struct PlaceData {
  std::vector<std::uint64_t> content;
  std::vector<std::byte> payloads;
  int decoded_otherwise = 0;
};

void make_place(const terrain::World& world, const Place& place, PlaceData& made) {
  const Lod lod = Lod::of(place.lod);
  const int width = place.tiles * kChunkSize;
  const terrain::Stacks stacks = terrain::generate_stacks(
      world, {place.chunk_x * kChunkSize, place.chunk_z * kChunkSize, width, width, lod});
  for (int tz = 0; tz < place.tiles; ++tz) {
    for (int tx = 0; tx < place.tiles; ++tx) {
      const auto x = static_cast<std::int32_t>(place.chunk_x + tx);
      const auto z = static_cast<std::int32_t>(place.chunk_z + tz);
      const terrain::MixedRange rows = terrain::mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first - 1; y <= rows.last + 1; ++y) {
        const Chunk chunk = terrain::extract_chunk(world, stacks, {x, y, z});
        const ContentHash hash = content_hash(chunk);
        made.content.insert(made.content.end(), {hash.low, hash.high});
        const std::size_t begin = made.payloads.size();
        encode(chunk, made.payloads);
        const auto decoded = decode(std::span{made.payloads}.subspan(begin));
        if (!decoded || content_hash(*decoded) != hash) ++made.decoded_otherwise;
      }
    }
  }
}

void print(const std::string& what, const PlaceData& made, std::ostream& out) {
  const auto digest = [](const void* data, std::size_t bytes) {
    const XXH128_hash_t hash = XXH3_128bits(data, bytes);
    return to_string(ContentHash{hash.low64, hash.high64});
  };
  std::vector<std::byte> scratch;
  const auto content = little_endian_bytes(std::span{made.content}, scratch);
  out << "  " << what << ": voxels " << digest(content.data(), content.size()) << " payloads "
      << digest(made.payloads.data(), made.payloads.size());
  if (made.decoded_otherwise != 0) out << ", " << made.decoded_otherwise << " payloads decoded otherwise";
  out << '\n';
}

// A tile of each.
void print_random_regions(std::ostream& out) {
  PlaceData made;
  int worlds = 0;
  for (int i = 0; i < kRandomWorlds; ++i) {
    const auto world =
        terrain::World::parse(test::random_regions_text(static_cast<std::uint64_t>(i)), "random");
    if (!world) continue;  // it asks for too many layers
    ++worlds;
    make_place(*world, random_place(i), made);
  }
  out << "random regions, " << worlds << " worlds\n";
  print("a tile of each", made, out);
}

// The line of a region that was not made.
constexpr std::string_view kNotMade = "-";

bool same(const std::string& text, const std::string& expected) {
  std::istringstream lines{text}, expected_lines{expected};
  std::string line, other;
  while (std::getline(lines, line)) {
    if (!std::getline(expected_lines, other) || (line != kNotMade && line != other)) return false;
  }
  return !std::getline(expected_lines, other);
}

}  // namespace

int main(int argc, char** argv) {
#if defined(__AVX2__)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    std::cout << "skipped: this machine has no AVX2\n";
    return 77;
  }
#endif
  const auto forced = forced_instruction_set();
  if (!forced) {
    std::cout << "skipped: " << forced.error() << '\n';
    return 77;
  }
  int every = 1;
  const std::string_view number = argc == 3 ? argv[2] : "1";
  const auto read = std::from_chars(number.data(), number.data() + number.size(), every);
  const bool writes = argc == 2 && std::string_view{argv[1]} == "--write";
  if (argc < 2 || argc > 3 || read.ec != std::errc{} || read.ptr != number.data() + number.size() ||
      every < 1) {
    return std::cerr << "usage: golden GOLDEN.TXT [N] | --write\n", 2;
  }
  std::ostringstream text;
  int index = 0;
  text << "generator " << to_integer(terrain::kNewestGeneratorVersion) << " codec " << int{kCodecVersion}
       << '\n';
  for (const auto& [name, spec, more] : kWorlds) {
    const std::string file = std::string{TALUS_SOURCE_DIR} + "/" + spec + ".toml";
    const auto world = terrain::World::parse(more + read_file(file), file, test::made_height_maps());
    if (!world) {
      std::cerr << world.error().message << '\n';
      return 1;
    }
    text << name << ' ' << to_string(world->fingerprint()) << '\n';
    for (const Place& place : kPlaces) {
      if (index++ % every != 0) {
        text << kNotMade << '\n';
        continue;
      }
      PlaceData made;
      make_place(*world, place, made);
      print(place.what, made, text);
    }
  }
  if (every == 1) {
    print_random_regions(text);
  } else {
    text << kNotMade << '\n' << kNotMade << '\n';
  }
  if (writes) return std::cout << text.str(), 0;
  const std::string expected = read_file(argv[1]);
  if (same(text.str(), expected)) {
    std::cout << "as in " << argv[1] << ", by " << to_string(instruction_set()) << '\n';
    return 0;
  }
  std::cout << text.str() << "differs from " << argv[1] << ":\n" << expected;
  return 1;
}
