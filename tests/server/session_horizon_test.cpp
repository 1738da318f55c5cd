// A session's View with a horizon.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

constexpr auto kRock = MaterialId{2};

}  // namespace

TEST_CASE("a horizon's rows count to the limit of chunks") {
  // Rows -1 to 63 of level 1 in 4 x 4 columns, and one chunk of level 0.
  const auto chunks = GENERATE(1041U, 1040U);
  SessionBench bench{{.heights = {0, 4096}}};
  bench.limits.view_chunks = chunks;
  const auto see = [&](bool horizon) {
    bench.receive([&](auto& builder) {
      const wire::Voxel centre{};
      const auto rings = builder.CreateVectorOfStructs(std::vector{wire::LodRing{1, 3}});
      return wire::CreateView(builder, &centre, nullptr, 0, 0, rings, 0, 0, horizon);
    });
    return bench.output();
  };
  CHECK(see(false).empty());
  const auto said = see(true);
  CHECK(said.size() == (chunks == 1040 ? 1 : 0));
  for (const SessionFrame& each : said) CHECK(each.code == wire::ErrorCode::too_large);
}

TEST_CASE("a horizon brings each chunk that is not uniform once as a Chunk, and names the others once") {
  const bool known_before = GENERATE(true, false);
  SessionBench bench{{.heights = {-100, 900}}};
  bench.view_number = 5;
  // Mountains and chasms: each column has rows of its own, which the server learns with its first chunk.
  const auto land = [](ChunkKey key) {
    const int level = key.lod.value();
    if (level == 0) return MixedRows{-2, 1, kRock};
    const int first = ((key.coord.x * 7 + key.coord.z * 3) & 3) - 2;
    const int height = ((key.coord.x * 5 - key.coord.z * 11) & 15) >> (level - 1);
    return MixedRows{first, first + height - 1, kRock};
  };
  std::set<ChunkKey> learned;
  const auto column_of = [](ChunkKey key) { return ChunkKey{{key.coord.x, 0, key.coord.z}, key.lod}; };
  bench.source.rows_of = [&](ChunkKey key) {
    return known_before || learned.contains(column_of(key)) ? land(key) : MixedRows{};
  };
  bench.receive([&](auto& builder) {
    const wire::Voxel centre{100, 20, -70};
    const auto rings = builder.CreateVectorOfStructs(std::vector{wire::LodRing{1, 5}, wire::LodRing{3, 30}});
    return wire::CreateView(builder, &centre, nullptr, 1, 2, rings, 0, bench.view_number, true);
  });
  bench.apply_view();

  std::set<ChunkKey> by_chunk;
  std::set<ChunkKey> named;
  std::size_t complete = 0;
  for (bool more = true; more;) {
    while (!bench.source.waiting.empty()) {
      const ChunkKey key = bench.source.waiting.begin()->first;
      learned.insert(column_of(key));
      bench.source.answer(key);
    }
    bench.take_mail();
    const auto said = bench.output();
    more = !said.empty();
    for (const SessionFrame& each : said) {
      if (each.kind == Body::Chunk) CHECK(by_chunk.insert(each.key).second);
      if (each.kind == Body::ViewComplete) ++complete;
      for (const auto& [first, last, material] : each.runs) {
        for (int y = first; y <= last; ++y) {
          const ChunkKey key{{each.key.coord.x, y, each.key.coord.z}, each.key.lod};
          CHECK(named.insert(key).second);
          CHECK(land(key).uniform_at(y) == MaterialId{static_cast<std::uint16_t>(material)});
        }
      }
    }
  }
  CHECK(complete == 1);

  std::set<ChunkKey> mixed;
  std::set<ChunkKey> uniform;
  for (const LevelBox& box :
       level_boxes({{3, 0, -3}, 1, 2, {{Lod::of(1), 5}, {Lod::of(3), 30}}, HeightRange{-100, 900}})) {
    box.for_each_column([&](std::int64_t x, std::int64_t z) {
      for (std::int64_t y = box.y.first; y <= box.y.last; ++y) {
        const ChunkKey key{
            {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)},
            box.lod};
        (land(key).uniform_at(key.coord.y) ? uniform : mixed).insert(key);
      }
    });
  }
  CHECK(mixed.size() > 100);
  CHECK(by_chunk == mixed);
  CHECK(named == uniform);
  // The highest land of level 1 lies above all rows of the View without a horizon, and the lowest below.
  CHECK(std::any_of(by_chunk.begin(), by_chunk.end(),
                    [](ChunkKey key) { return key.lod == Lod::of(1) && key.coord.y > 1; }));
  CHECK(std::any_of(by_chunk.begin(), by_chunk.end(),
                    [](ChunkKey key) { return key.lod == Lod::of(1) && key.coord.y < -1; }));
}
