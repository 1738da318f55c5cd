#include "chunks/generation/patch_size.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include <talus/terrain/world.h>

#include "runtime/clock.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

/// Every tile that is timed takes as long as the list says, its terrain and its chunks; the last one for
/// ever.
class ScriptedClock final : public Clock {
 public:
  struct Tile {
    std::chrono::nanoseconds terrain;
    std::chrono::nanoseconds chunks{};
  };
  explicit ScriptedClock(std::vector<Tile> tiles) : tiles_{std::move(tiles)} {}
  [[nodiscard]] time_point now() const override { return {}; }
  [[nodiscard]] std::chrono::sys_seconds wall() const override { return {}; }
  [[nodiscard]] std::chrono::nanoseconds thread_cpu() const override {
    const Tile& tile = tiles_[std::min(calls_ / 3, tiles_.size() - 1)];
    if (calls_ % 3 == 1) time_ += tile.terrain;
    if (calls_ % 3 == 2) time_ += tile.chunks;
    ++calls_;
    return time_;
  }
  [[nodiscard]] std::size_t measured() const { return calls_ / 3; }

 private:
  std::vector<Tile> tiles_;
  mutable std::size_t calls_ = 0;
  mutable std::chrono::nanoseconds time_{};
};

}  // namespace

TEST_CASE("a patch has the most tiles with which it takes no longer than 50 ms") {
  // Without a halo four times the tiles take four times as long.
  CHECK(choose_patch_size(100us, 0).tiles == 4);
  CHECK(choose_patch_size(3125us, 0).tiles == 4);
  CHECK(choose_patch_size(3126us, 0).tiles == 2);
  CHECK(choose_patch_size(12500us, 0).tiles == 2);
  CHECK(choose_patch_size(12501us, 0).tiles == 1);
  CHECK(choose_patch_size(10s, 0).tiles == 1);
  CHECK(choose_patch_size(0ns, 0).tiles == 4);
  for (const auto time : {1us, 1000us, 3000us, 12000us, 49000us}) {
    for (const int halo : {0, 9, 48})
      CHECK(choose_patch_size(time, halo).patch_time <= std::max<std::chrono::nanoseconds>(50ms, 2 * time));
  }
}

TEST_CASE("a patch may take twice as long as a lone tile if the halo is most of the work") {
  // 64 steps: 288 x 288 columns for one tile, 320 x 320 for four, 384 x 384 for sixteen.
  const PatchSize size = choose_patch_size(300ms, 128);
  CHECK(size.tiles == 4);
  CHECK(size.patch_time > 500ms);
  CHECK(size.patch_time <= 600ms);
  CHECK(size.expensive);
  CHECK(size.ns_a_column() == 300'000'000ULL * 384 * 384 / (288 * 288) / (128 * 128));
}

TEST_CASE("a world is expensive if a patch of four tiles along each edge takes longer than 50 ms") {
  CHECK_FALSE(patch_size(16, 1ms, 0).expensive);
  CHECK(patch_size(1, 4ms, 0).expensive);
  CHECK_FALSE(patch_size(1, 3ms, 0).expensive);
}

TEST_CASE("a configured number of tiles is kept, whatever they cost") {
  CHECK(patch_size(8, 1s, 10).tiles == 8);
  CHECK(patch_size(8, 1s, 0).patch_time == 64s);
}

TEST_CASE("a patch has fewer tiles if generators lack room, unless halos would double its cost") {
  PatchSize size = patch_size(4, 100us, 8);
  size.tile_bytes = 100'000;
  size.chunk_time = 7us;
  CHECK(size.bytes_at_work() == 5 * 16 * 100'000);
  CHECK(reduced_to(size.bytes_at_work(), size).tiles == 4);
  CHECK_FALSE(reduced_to(size.bytes_at_work(), size).reduced);
  const PatchSize half = reduced_to(size.bytes_at_work() - 1, size);
  CHECK(half.tiles == 2);
  CHECK(half.reduced);
  CHECK(half.bytes_at_work() == 5 * 4 * 100'000);
  CHECK(half.patch_time < size.patch_time);
  CHECK(half.chunk_time == 7us);
  CHECK(reduced_to(500'000, size).tiles == 1);
  CHECK(reduced_to(499'999, size).tiles == 1);  // none fits
  size = patch_size(4, 300ms, 128);             // of a halo of 128 columns most are the halo's
  CHECK(reduced_to(patch_size(2, 300ms, 128).bytes_at_work(), size).tiles == 4);
  size = patch_size(4, 300ms, 32);  // two tiles for each edge still keep within twice the time, one does not
  CHECK(reduced_to(patch_size(1, 300ms, 32).bytes_at_work(), size).tiles == 2);
  CHECK(reduced_to(0, size).tiles == 2);
}

TEST_CASE("the dearest of the places counts, but for the first, whose memory is cold") {
  const ScriptedClock clock{{{9ms, 900us}, {1ms, 30us}, {3ms, 60us}, {2ms, 90us}, {1ms, 30us}}};
  const TileCost cost = measure_tile(terrain::default_world(), clock);
  CHECK(cost.terrain == 3ms);
  CHECK(cost.chunk == 30us);  // of three
  CHECK(clock.measured() == 5);
  CHECK(cost.bytes > 32 * 32 * 16);
}

TEST_CASE("measuring ends early if a tile takes long") {
  const ScriptedClock slow{{{400ms, 3ms}}};
  CHECK(measure_tile(terrain::default_world(), slow).terrain == 400ms);
  CHECK(measure_tile(terrain::default_world(), slow).chunk == 1ms);
  CHECK(slow.measured() == 2);
  const ScriptedClock slower_later{{{90ms}, {60ms}}};
  CHECK(measure_tile(terrain::default_world(), slower_later).terrain == 60ms);
  CHECK(slower_later.measured() == 2);
  const ScriptedClock slow_chunks{{{1ms, 120ms}}};
  CHECK(measure_tile(terrain::default_world(), slow_chunks).chunk == 40ms);
  CHECK(slow_chunks.measured() == 1);
}
