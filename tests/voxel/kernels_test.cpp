// The kernels of every instruction set that this processor has do what the scalar ones do.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "kernels.h"

namespace talus {
namespace {

using Row = std::array<std::uint8_t, kChunkSize>;

std::vector<InstructionSet> vector_sets() {
  std::vector<InstructionSet> sets;
  for (const auto set : {InstructionSet::sse4, InstructionSet::avx2, InstructionSet::avx512}) {
    if (runs_here(set)) sets.push_back(set);
  }
  return sets;
}

/// Rows that often are alike, as a plane's are, and reach 0 and 32.
Row any_row() {
  Row row{};
  int top = *rc::gen::inRange(0, kChunkSize + 1);
  for (std::uint8_t& place : row) {
    const int step = *rc::gen::weightedElement<int>({{8, 0}, {2, 1}, {2, -1}, {1, 9}, {1, -9}});
    top = std::clamp(top + step, 0, kChunkSize);
    place = static_cast<std::uint8_t>(top);
  }
  return row;
}

codec::Steps any_steps() {
  codec::Steps steps;
  for (std::size_t x = 0; x < kChunkSize; ++x) {
    steps.data()[x] = static_cast<std::int8_t>(
        *rc::gen::weightedElement<int>({{8, 0}, {2, 1}, {2, -1}, {1, 5}, {1, -5}, {1, 32}, {1, -32}}));
  }
  return steps;
}

}  // namespace

TEST_CASE("rows are guessed, classified and applied alike by every instruction set") {
  const VoxelKernels& scalar = voxel_kernels(InstructionSet::scalar);
  CHECK(rc::check([&scalar] {
    const Row north = any_row();
    const Row floor = any_row();
    const Row floor_north = *rc::gen::arbitrary<bool>() ? north : any_row();
    const Row row = any_row();
    const codec::Steps before = any_steps();
    const codec::Steps after = any_steps();
    const codec::RowsBefore rows{north.data(), &before, floor.data(), floor_north.data()};
    for (const InstructionSet set : vector_sets()) {
      const VoxelKernels& kernels = voxel_kernels(set);
      codec::RowGuess expected;
      codec::RowGuess found;
      scalar.guess(rows, expected);
      kernels.guess(rows, found);
      RC_ASSERT(found.predicted == expected.predicted);
      RC_ASSERT(found.context == expected.context);

      std::array<codec::Steps, 2> steps;
      std::array<codec::RowSymbols, 2> symbols;
      scalar.classify(row.data(), expected, steps[0], symbols[0]);
      kernels.classify(row.data(), expected, steps[1], symbols[1]);
      RC_ASSERT(steps[0].padded == steps[1].padded);
      RC_ASSERT(symbols[0].context == symbols[1].context);
      RC_ASSERT(symbols[0].symbol == symbols[1].symbol);

      std::array<Row, 2> tops{};
      const bool inside = scalar.apply(expected, after, floor.data(), tops[0].data());
      RC_ASSERT(kernels.apply(expected, after, floor.data(), tops[1].data()) == inside);
      RC_ASSERT(tops[0] == tops[1]);
    }
  }));
}

TEST_CASE("slices are put together alike by every instruction set") {
  const VoxelKernels& scalar = voxel_kernels(InstructionSet::scalar);
  CHECK(rc::check([&scalar] {
    std::vector<std::uint8_t> tops;
    const auto planes = *rc::gen::inRange<std::size_t>(0, 6);
    while (tops.size() < planes * kChunkArea) {
      const Row row = any_row();
      tops.insert(tops.end(), row.begin(), row.end());
    }
    const std::array<std::uint8_t, 7> bytes{9, 0, 255, 3, 128, 1, 2};
    const CutSlice slice{tops.data(), planes, bytes.data(),
                         static_cast<std::uint8_t>(*rc::gen::inRange(0, kChunkSize))};
    std::array<MaterialId, kChunkArea> expected;
    scalar.slice(slice, expected.data());
    for (const InstructionSet set : vector_sets()) {
      std::array<MaterialId, kChunkArea> voxels;
      std::array<std::uint8_t, kChunkArea> places;
      voxel_kernels(set).slice(slice, voxels.data());
      voxel_kernels(set).slice_bytes(slice, places.data());
      RC_ASSERT(voxels == expected);
      for (std::size_t i = 0; i < kChunkArea; ++i) RC_ASSERT(places[i] == to_integer(expected[i]));
      for (std::size_t p = 0; p < planes; ++p) {
        const auto at = voxel_kernels(set).extent(tops.data() + p * kChunkArea);
        const auto is = scalar.extent(tops.data() + p * kChunkArea);
        RC_ASSERT(at.low == is.low);
        RC_ASSERT(at.high == is.high);
      }
    }
  }));
}

}  // namespace talus
