// The kernels of every instruction set that this processor has do what the scalar ones do.
#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <tuple>
#include <vector>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "kernels.h"
#include "plane_scalar.h"
#include "runs.h"
#include "sample_chunks.h"
#include "volume.h"
#include "volume_scalar.h"

namespace talus {
namespace {

using Row = std::array<std::uint8_t, kChunkSize>;

std::vector<InstructionSet> vector_sets() {
  std::vector<InstructionSet> sets;
  // What is called scalar has vectors of sixteen bytes, emulated, where the compiler is clang.
  for (const auto set : kInstructionSets) {
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

/// Planes of all sorts, and what lies below the first: the ground.
std::vector<std::uint8_t> any_planes() {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const auto planes = *rc::gen::inRange<std::size_t>(1, 5);
  std::vector<std::uint8_t> tops(kChunkArea, 0);
  const auto layers = *rc::gen::inRange(0, 3) == 0
                          ? testing::leaping_layers(seed, planes)
                          : testing::random_layers(seed, planes, *rc::gen::inRange(0, 100));
  tops.insert(tops.end(), layers.tops.begin(), layers.tops.end());
  return tops;
}

}  // namespace

TEST_CASE("The set that runs is the fastest that the build and this processor have") {
  std::vector<std::string_view> here;
  for (const auto set : kInstructionSets) {
    if (runs_here(set)) here.push_back(to_string(set));
  }
  REQUIRE(!here.empty());
#if defined(__x86_64__)
  CHECK(here.front() == "scalar");
  CHECK(!runs_here(InstructionSet::neon));
#elif defined(__aarch64__)
  CHECK(here == std::vector<std::string_view>{"neon"});
#endif
  CHECK(runs_here(instruction_set()));
  if (std::getenv(kInstructionSetVariable) == nullptr) CHECK(to_string(instruction_set()) == here.back());
}

TEST_CASE("planes are modelled and written alike by every instruction set") {
  CHECK(rc::check([] {
    const auto tops = any_planes();
    for (std::size_t at = kChunkArea; at < tops.size(); at += kChunkArea) {
      codec::PlaneIntervals expected;
      codec::model_plane_scalar(tops.data() + at, tops.data() + at - kChunkArea, expected);
      const auto write = [&](const auto& kernel) {
        std::vector<std::uint8_t> bytes(codec::kMaxBytesOfPlane + codec::kScribbled);
        codec::RansSink sink{{}, bytes.data() + bytes.size()};
        sink.states.fill(codec::kMinState);
        kernel(expected, sink);
        const std::vector<std::uint8_t> written(sink.next, bytes.data() + bytes.size());
        return std::pair{written, sink.states};
      };
      const auto written = write(codec::encode_plane_scalar);
      for (const InstructionSet set : vector_sets()) {
        const codec::PlaneKernels kernels = codec::plane_kernels(set);
        codec::PlaneIntervals found;
        kernels.model(tops.data() + at, tops.data() + at - kChunkArea, found);
        RC_ASSERT(found.start == expected.start);
        RC_ASSERT(found.size == expected.size);
        RC_ASSERT(found.others == expected.others);
        RC_ASSERT(found.carried == expected.carried);
        for (std::size_t i = 0; i < kChunkArea; ++i) {
          const bool told = (expected.others[i / kChunkSize] >> i % kChunkSize & 1U) != 0;
          RC_ASSERT(!told || found.changes[i] == expected.changes[i]);
        }
        RC_ASSERT(write(kernels.encode) == written);
      }
    }
  }));
}

TEST_CASE("any bytes are read as the same plane, or the same fault, by every instruction set") {
  CHECK(rc::check([] {
    const auto tops = any_planes();
    const std::uint8_t* const plane_above = tops.data() + tops.size() - kChunkArea;
    const std::uint8_t* const below = plane_above - kChunkArea;
    codec::PlaneIntervals intervals;
    codec::model_plane_scalar(plane_above, below, intervals);
    std::vector<std::uint8_t> bytes(codec::kMaxBytesOfPlane + codec::kScribbled);
    codec::RansSink sink{{}, bytes.data() + bytes.size()};
    sink.states.fill(codec::kMinState);
    codec::encode_plane_scalar(intervals, sink);
    bytes.erase(bytes.begin(), bytes.begin() + (sink.next - bytes.data()));
    const bool cut = *rc::gen::inRange(0, 4) == 0;
    if (cut) bytes.resize(*rc::gen::inRange<std::size_t>(1, bytes.size() + 1));
    for (int flips = *rc::gen::inRange(0, 3); flips > 0; --flips) {
      const auto bit = *rc::gen::inRange(0, 8);
      bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] ^= static_cast<std::uint8_t>(1U << bit);
    }
    const std::size_t size = bytes.size();
    bytes.resize(size + codec::kReadAhead);
    const codec::RansSource source{sink.states, bytes.data(), bytes.data() + size};
    const auto read = [&](const auto& kernel) {
      codec::RansSource from = source;
      std::vector<std::uint8_t> plane(kChunkArea);
      const codec::PlaneFault fault = kernel(from, below, plane.data());
      if (fault != codec::PlaneFault::none) return std::tuple{fault, plane, from.states, std::ptrdiff_t{}};
      return std::tuple{fault, plane, from.states, from.next - bytes.data()};
    };
    const auto same = [](const auto& a, const auto& b) {
      if (std::get<0>(a) != std::get<0>(b)) return false;
      return std::get<0>(a) != codec::PlaneFault::none || a == b;
    };
    const auto expected = read(codec::decode_plane_scalar);
    RC_CLASSIFY(std::get<0>(expected) == codec::PlaneFault::none, "read");
    RC_CLASSIFY(std::get<0>(expected) == codec::PlaneFault::truncated, "truncated");
    RC_CLASSIFY(std::get<0>(expected) == codec::PlaneFault::bad_number, "bad number");
    for (const InstructionSet set : vector_sets()) {
      RC_ASSERT(same(read(codec::plane_kernels(set).decode), expected));
    }
  }));
}

TEST_CASE("volumes are analysed and written alike by every instruction set") {
  CHECK(rc::check([] {
    const auto voxels = testing::voxels_of(testing::any_chunk());
    const auto expected = std::make_unique<codec::VolumeEvents>();
    const auto found = std::make_unique<codec::VolumeEvents>();
    const bool orderly = codec::analyse_volume_scalar(*voxels, *expected);
    const codec::VolumeKernels& scalar = codec::kScalarVolume;
    std::vector<std::byte> payload;
    const bool written = codec::encode_volume(*voxels, payload, scalar);
    for (const InstructionSet set : vector_sets()) {
      const codec::VolumeKernels kernels = codec::volume_kernels(set);
      RC_ASSERT(kernels.analyse(*voxels, *found) == orderly);
      RC_ASSERT(found->surprises == expected->surprises);
      if (orderly) RC_ASSERT(found->changes == expected->changes);
      RC_ASSERT(found->coded == expected->coded);
      RC_ASSERT(found->escapes == expected->escapes);
      RC_ASSERT(found->exceptions == expected->exceptions);
      std::vector<std::byte> other;
      RC_ASSERT(codec::encode_volume(*voxels, other, kernels) == written);
      RC_ASSERT(other == payload);
    }
  }));
}

TEST_CASE("materials that share a byte are distinguished by every instruction set") {
  CHECK(rc::check([] {
    // Cubes of 4 x 4 x 4 voxels, of up to 299 materials, where a volume has at most 256. Many share their low
    // byte, and in some chunks every other cube has the high byte 255. Sizes are full from the first case on:
    // small ones have few materials, with low ids.
    const auto full = [](auto gen) { return rc::gen::resize(rc::kNominalSize, std::move(gen)); };
    const auto count = *full(rc::gen::inRange<std::size_t>(2, 300));
    const auto mask = *rc::gen::element<std::uint16_t>(0xFFFF, 0xFF03, 0x0101, 0xFF00);
    const auto high = *rc::gen::element<std::uint16_t>(0, 0, 0xFF00);
    const auto ids =
        *rc::gen::container<std::vector<std::uint16_t>>(count, full(rc::gen::arbitrary<std::uint16_t>()));
    const auto voxels = std::make_unique<DenseVoxels>();
    for (std::size_t i = 0; i < voxels->size(); ++i) {
      const std::size_t cube = i / 4096 * 64 + i / 128 % 8 * 8 + i / 4 % 8;
      const auto set = cube % 2 == 0 ? std::uint16_t{0} : high;
      (*voxels)[i] = MaterialId{static_cast<std::uint16_t>((ids[cube % count] & mask) | set)};
    }
    std::vector<std::byte> payload;
    const bool written = codec::encode_volume(*voxels, payload, codec::kScalarVolume);
    RC_CLASSIFY(written, "written");
    RC_CLASSIFY(!written, "refused");
    for (const InstructionSet set : vector_sets()) {
      std::vector<std::byte> other;
      RC_ASSERT(codec::encode_volume(*voxels, other, codec::volume_kernels(set)) == written);
      RC_ASSERT(other == payload);
    }
  }));
}

TEST_CASE("any bytes are read as the same volume, or the same fault, by every instruction set") {
  CHECK(rc::check([] {
    const codec::VolumeKernels& scalar = codec::kScalarVolume;
    std::vector<std::byte> payload;
    RC_PRE(codec::encode_volume(*testing::voxels_of(testing::any_chunk()), payload, scalar));
    for (int flips = *rc::gen::inRange(0, 3); flips > 0; --flips) {
      const auto bit = *rc::gen::inRange(0, 8);
      payload[*rc::gen::inRange<std::size_t>(0, payload.size())] ^= std::byte{1} << bit;
    }
    if (*rc::gen::inRange(0, 4) == 0) payload.resize(*rc::gen::inRange<std::size_t>(0, payload.size() + 1));
    const auto expected = codec::decode_volume(payload, scalar);
    RC_CLASSIFY(expected.has_value(), "read");
    for (const InstructionSet set : vector_sets()) {
      const auto found = codec::decode_volume(payload, codec::volume_kernels(set));
      RC_ASSERT(found.has_value() == expected.has_value());
      if (!expected.has_value()) RC_ASSERT(found.error() == expected.error());
      if (expected.has_value()) RC_ASSERT(*found == *expected);
    }
  }));
}

TEST_CASE("any bytes are read as the same runs, or the same fault, by every instruction set") {
  CHECK(rc::check([] {
    std::vector<std::byte> payload;
    const auto voxels = testing::voxels_of(testing::any_chunk());
    RC_PRE(codec::encode_runs(*voxels, kMaxPayloadBytes, payload, codec::kScalarVolume));
    for (const InstructionSet set : vector_sets()) {
      std::vector<std::byte> other;
      RC_ASSERT(codec::encode_runs(*voxels, kMaxPayloadBytes, other, codec::volume_kernels(set)));
      RC_ASSERT(other == payload);
    }
    for (int flips = *rc::gen::inRange(0, 3); flips > 0; --flips) {
      const auto bit = *rc::gen::inRange(0, 8);
      payload[*rc::gen::inRange<std::size_t>(0, payload.size())] ^= std::byte{1} << bit;
    }
    if (*rc::gen::inRange(0, 4) == 0) payload.resize(*rc::gen::inRange<std::size_t>(0, payload.size() + 1));
    const auto expected = codec::decode_runs(payload, codec::kScalarVolume);
    for (const InstructionSet set : vector_sets()) {
      const auto found = codec::decode_runs(payload, codec::volume_kernels(set));
      RC_ASSERT(found.has_value() == expected.has_value());
      if (!expected.has_value()) RC_ASSERT(found.error() == expected.error());
      if (expected.has_value()) RC_ASSERT(*found == *expected);
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
