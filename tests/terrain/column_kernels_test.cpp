// What is done to the columns of a patch and to the planes of a chunk, by the kernels of every instruction
// set that this processor has.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/vectors/instruction_set.h>

#include "any_field.h"
#include "kernels/chunk_planes.h"
#include "kernels/columns.h"
#include "loose/settle_grid.h"
#include "overlay.h"

namespace talus::terrain {
namespace {

TEST_CASE("Tops are cut into voxel rows by every instruction set as by the definition") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(kChunkSize, 150);
    const int first = *rc::gen::inRange(0, width - kChunkSize + 1);
    Field top = any_field(width, kChunkSize, 1 << 23);
    // Where the difference passes 15 or 16 bits, and half of the columns together.
    const std::int32_t floor_row = *rc::gen::oneOf(
        rc::gen::inRange(-16, 1 << 15), rc::gen::element(0, -32768, -32767, -65536, -(1 << 24), 1 << 24));
    const std::int32_t edge_fx = *rc::gen::element(0, 127, 128, 31 << 8, 1 << 22, (1 << 23) - 256, 1 << 23);
    for (std::size_t i = 0; i < top.values.size(); i += 2) {
      top.values[i] = edge_fx + static_cast<std::int32_t>(i % (40 << 8));
    }
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      ChunkPlane rows;
      column_kernels(set).cut(top.row(0).data() + first, static_cast<std::size_t>(width), floor_row,
                              rows.data());
      for (int z = 0; z < kChunkSize; ++z) {
        for (int x = 0; x < kChunkSize; ++x) {
          RC_ASSERT(rows[column_index(x, z)] ==
                    std::clamp(boundary_row(top.at(first + x, z)) - floor_row, 0, kChunkSize));
        }
      }
    }
  }));
}

TEST_CASE("A chunk's planes are put together by every instruction set as by the definition") {
  CHECK(rc::check([] {
    const auto any_plane = [] {
      const auto rows = *rc::gen::container<std::vector<std::uint8_t>>(
          64, rc::gen::inRange<std::uint8_t>(0, kChunkSize + 1));
      ChunkPlane plane;
      for (std::size_t i = 0; i < kChunkArea; ++i) plane[i] = rows[i * i / 7 % rows.size()];
      return plane;
    };
    const ChunkPlane from = any_plane();
    const ChunkPlane to = *rc::gen::arbitrary<bool>() ? any_plane() : from;
    const ChunkPlane bottom = any_plane();
    const ChunkPlane top = any_plane();
    constexpr std::size_t kStride = 77;
    std::vector<std::uint8_t> looks(kStride * kChunkSize);
    for (std::size_t i = 0; i < looks.size(); ++i) looks[i] = top[i % kChunkArea] % 3;
    ChunkPlane lower, higher, low, high, raised{bottom};
    std::size_t inside = 0;
    bool any = false;
    for (std::size_t i = 0; i < kChunkArea; ++i) {
      const bool here = from[i] < to[i];
      lower[i] = std::min(from[i], bottom[i]);
      higher[i] = std::max(from[i], bottom[i]);
      inside += here && bottom[i] <= from[i] && to[i] <= top[i] ? 1 : 0;
      any = any || here;
      low[i] = here ? from[i] : top[i];
      high[i] = here ? to[i] : top[i];
      if (looks[i / kChunkSize * kStride + i % kChunkSize] == 2) raised[i] = from[i];
    }
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      const ChunkPlaneKernels& kernels = chunk_plane_kernels(set);
      ChunkPlane a, b, c{bottom};
      kernels.lower_of(from.data(), bottom.data(), a.data());
      kernels.higher_of(from.data(), bottom.data(), b.data());
      RC_ASSERT(a == lower);
      RC_ASSERT(b == higher);
      RC_ASSERT(kernels.count_inside(from.data(), to.data(), bottom.data(), top.data()) == inside);
      RC_ASSERT(kernels.any(from.data(), to.data()) == any);
      kernels.interval(from.data(), to.data(), top.data(), a.data(), b.data());
      RC_ASSERT(a == low);
      RC_ASSERT(b == high);
      kernels.raise_where(looks.data(), kStride, 2, from.data(), c.data());
      RC_ASSERT(c == raised);
    }
  }));
}

TEST_CASE("Tops are lowered by every instruction set as by the definition") {
  CHECK(rc::check([] {
    const int width = *rc::gen::inRange(1, 150);
    const auto count = static_cast<std::size_t>(width);
    const Field top = any_field(width, 1, 1 << 23);
    const Field thickness = any_field(width, 1, *rc::gen::element(1 << 8, 32767, 1 << 20));
    const Field thin = any_field(width, 1, 32767);
    const std::vector<std::int16_t> thickness_16(thin.values.begin(), thin.values.end());
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      const ColumnKernels& kernels = column_kernels(set);
      std::array<std::vector<std::int32_t>, 2> lowered;
      lowered.fill(std::vector<std::int32_t>(count));
      kernels.lower_int32(top.values.data(), thickness.values.data(), count, lowered[0].data());
      kernels.lower_int16(top.values.data(), thickness_16.data(), count, lowered[1].data());
      for (std::size_t i = 0; i < count; ++i) {
        RC_ASSERT(lowered[0][i] == std::max(top.values[i] - thickness.values[i], 0));
        RC_ASSERT(lowered[1][i] == std::max(top.values[i] - thin.values[i], 0));
      }
      const int shift = *rc::gen::inRange(0, 7);
      std::vector<std::int32_t> cut(thickness.values.begin(), thickness.values.end());
      kernels.cut_at(top.values.data(), shift, count, cut.data());
      for (std::size_t i = 0; i < count; ++i) {
        RC_ASSERT(cut[i] == std::min(thickness.values[i], top.values[i] >> shift));
      }
    }
  }));
}

TEST_CASE("Walls are found by every instruction set as by the definition") {
  CHECK(rc::check([] {
    const int ring = *rc::gen::inRange(0, 3);
    const int width = *rc::gen::inRange(1, 150);
    const Field slope = any_field(width + 2 * ring, 1 + 2 * ring, 1 << 12);
    const std::int32_t wall_fx = *rc::gen::element(0, 1 << 11, 1 << 12);
    const std::int32_t elsewhere = *rc::gen::element(4096, 32766, 1 << 20);
    bool any = false;
    for (int x = 0; x < width; ++x) any = any || slope.at(ring + x, ring) > wall_fx;
    for (const auto set : kInstructionSets) {
      if (!runs_here(set)) continue;
      SettleGrid grid{set};
      RC_ASSERT(grid.start_at_walls(slope, ring, wall_fx, elsewhere) == any);
      grid.with_row(0, [&](const auto* row) {
        for (int x = 0; x < width; ++x) {
          RC_ASSERT(row[x] == (slope.at(ring + x, ring) > wall_fx ? 0 : elsewhere));
        }
      });
    }
  }));
}

}  // namespace
}  // namespace talus::terrain
