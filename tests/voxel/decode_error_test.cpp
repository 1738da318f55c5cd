#include <algorithm>
#include <array>
#include <random>

#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "layered.h"
#include "plane_scalar.h"
#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;
using Payload = std::vector<std::byte>;

Payload bytes(std::initializer_list<int> values) {
  Payload payload;
  for (const int value : values) payload.push_back(static_cast<std::byte>(value));
  return payload;
}

std::vector<Payload> sample_payloads() {
  return {encoded(Chunk::uniform(MaterialId{300})),
          encoded(Chunk::from_layers(hill(1))),
          encoded(Chunk::from_layers(hill(2))),
          encoded(Chunk::from_layers(random_layers(3, 5, 100))),
          encoded(Chunk::from_dense(*random_voxels(4, 3, 400))),
          encoded(with_random_overrides(Chunk::from_layers(hill(5)), 5))};
}

DecodeError fault_of(const Payload& payload) {
  const auto chunk = decode(payload);
  REQUIRE_FALSE(chunk.has_value());
  return chunk.error();
}

}  // namespace

TEST_CASE("every truncation of a payload is an error") {
  for (const Payload& whole : sample_payloads()) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      CAPTURE(whole.size(), size);
      REQUIRE_FALSE(decode(std::span{whole}.first(size)).has_value());
    }
  }
}

TEST_CASE("every flipped bit gives an error or another chunk") {
  for (Payload payload : sample_payloads()) {
    for (std::byte& byte : payload) {
      for (unsigned bit = 0; bit < 8; ++bit) {
        byte ^= std::byte{1} << bit;
        const auto chunk = decode(payload);
        if (chunk && chunk->layers() != nullptr) REQUIRE(chunk->layers()->valid());
        byte ^= std::byte{1} << bit;
      }
    }
  }
}

TEST_CASE("bytes after a payload's end are an error") {
  for (Payload payload : sample_payloads()) {
    payload.push_back(std::byte{0});
    CHECK(fault_of(payload) == DecodeError::too_long);
  }
}

TEST_CASE("no bytes") {
  CHECK(fault_of({}) == DecodeError::empty);
}

TEST_CASE("a version that this library does not read") {
  CHECK(fault_of(bytes({2, 0, 1, 0})) == DecodeError::unknown_version);
  CHECK(fault_of(bytes({5})) == DecodeError::unknown_version);
}

TEST_CASE("an encoding that does not exist") {
  for (const int encoding : {1, 2, 3})
    CHECK(fault_of(bytes({3, encoding, 1, 0})) == DecodeError::unknown_encoding);
  CHECK(fault_of(bytes({4, 0, 1, 0})) == DecodeError::unknown_encoding);
  CHECK(fault_of(bytes({4, 4, 1, 0})) == DecodeError::unknown_encoding);
}

TEST_CASE("headers that end early") {
  CHECK(fault_of(bytes({3})) == DecodeError::truncated);
  CHECK(fault_of(bytes({3, 0})) == DecodeError::truncated);
  CHECK(fault_of(bytes({3, 0, 2, 5})) == DecodeError::truncated);
  CHECK(fault_of(bytes({3, 0, 1, 0x85})) == DecodeError::truncated);
  CHECK(fault_of(bytes({3, 0, 2, 5, 6})) == DecodeError::truncated);
  CHECK(fault_of(bytes({4})) == DecodeError::truncated);
  CHECK(fault_of(bytes({4, 1})) == DecodeError::truncated);
  CHECK(fault_of(bytes({4, 1, 2, 5, 6, 127})) == DecodeError::truncated);             // sizes
  CHECK(fault_of(bytes({4, 1, 2, 5, 6, 127, 127})) == DecodeError::truncated);        // count of exceptions
  CHECK(fault_of(bytes({4, 1, 2, 5, 6, 127, 127, 0})) == DecodeError::truncated);     // table
  CHECK(fault_of(bytes({4, 1, 2, 5, 6, 127, 127, 0, 0})) == DecodeError::truncated);  // states
  CHECK(fault_of(bytes({4, 2, 0, 0})) == DecodeError::truncated);
  CHECK(fault_of(bytes({4, 3, 1, 5, 255})) == DecodeError::truncated);
}

TEST_CASE("more bytes than any payload has") {
  CHECK(fault_of(Payload(kMaxPayloadBytes + 1, std::byte{4})) == DecodeError::too_long);
}

TEST_CASE("lists of materials that cannot be") {
  CHECK(fault_of(bytes({3, 0, 0})) == DecodeError::bad_materials);
  CHECK(fault_of(bytes({3, 0, 65})) == DecodeError::bad_materials);
  CHECK(fault_of(bytes({3, 0, 2, 5, 5})) == DecodeError::bad_materials);
  for (const int encoding : {1, 3}) {
    CHECK(fault_of(bytes({4, encoding, 0})) == DecodeError::bad_materials);
    CHECK(fault_of(bytes({4, encoding, 0x81, 2})) == DecodeError::bad_materials);
    CHECK(fault_of(bytes({4, encoding, 2, 5, 5})) == DecodeError::bad_materials);
    CHECK(fault_of(bytes({4, encoding, 3, 5, 7, 6})) == DecodeError::bad_materials);
    CHECK(fault_of(bytes({4, encoding, 3, 5, 4, 5})) == DecodeError::bad_materials);
  }
}

TEST_CASE("numbers longer than they need be or past 65,535") {
  CHECK(fault_of(bytes({3, 0, 1, 0x80, 0})) == DecodeError::bad_number);
  CHECK(fault_of(bytes({3, 0, 0x81, 0, 7})) == DecodeError::bad_number);
  CHECK(fault_of(bytes({3, 0, 1, 0xFF, 0xFF, 4})) == DecodeError::bad_number);
  CHECK(fault_of(bytes({3, 0, 1, 0xFF, 0xFF, 0x83, 0})) == DecodeError::bad_number);
  CHECK(decode(bytes({3, 0, 1, 0xFF, 0xFF, 3})).value() == Chunk::uniform(MaterialId{0xFFFF}));
}

TEST_CASE("probabilities that do not add up to 256") {
  for (const int encoding : {1, 3}) {
    CHECK(fault_of(bytes({4, encoding, 2, 5, 6, 127, 128})) == DecodeError::bad_number);
    CHECK(fault_of(bytes({4, encoding, 2, 5, 6, 127, 126})) == DecodeError::bad_number);
  }
  Payload runs = encoded(Chunk::from_dense(*random_voxels(4, 3, 40)));
  REQUIRE(runs[1] == std::byte{3});
  // Behind the header, the list of ids 0, 21845 and 43690, their sizes and the count of runs.
  const std::size_t sizes = 2 + 1 + 7 + 3 + 2;
  runs[sizes] = static_cast<std::byte>(std::to_integer<int>(runs[sizes]) + 1);
  CHECK(fault_of(runs) == DecodeError::bad_number);
}

/// A payload of one material and `rest`, then states that end at once.
Payload of_one_material(int encoding, std::initializer_list<int> rest) {
  Payload payload = bytes({4, encoding, 1, 5, 255});
  for (const int byte : rest) payload.push_back(static_cast<std::byte>(byte));
  for (std::size_t lane = 0; lane < codec::kLanes; ++lane) {
    payload.push_back(std::byte{0});
    payload.push_back(std::byte{1});
  }
  return payload;
}

TEST_CASE("a table of probabilities that does not exist") {
  CHECK(decode(of_one_material(1, {0, 7})).value() == Chunk::uniform(MaterialId{5}));
  CHECK(fault_of(of_one_material(1, {0, 8})) == DecodeError::bad_number);
}

TEST_CASE("exceptions that are left over") {
  // Its gap is 0 digits long, so that it would be the first voxel; the second one has no voxel left.
  Payload payload = of_one_material(1, {0xFF, 0xFF, 3, 0});
  CHECK_FALSE(decode(payload).has_value());
}

TEST_CASE("runs that are not the whole chunk") {
  // One run of one voxel, which takes a byte.
  Payload one = of_one_material(3, {1, 255, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  one.push_back(std::byte{0});
  CHECK(fault_of(one) == DecodeError::bad_number);
  // No run.
  CHECK(fault_of(of_one_material(3, {0, 255, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})) ==
        DecodeError::bad_number);
}

TEST_CASE("planes that leave the chunk or pass one another") {
  // Whatever bytes follow, what is read from them is layers or an error, and some of them step out.
  std::mt19937 random{7};
  const auto some = [&random](Payload& payload, int count, std::uint32_t least) {
    for (int i = 0; i < count; ++i)
      payload.push_back(
          static_cast<std::byte>(std::max(static_cast<std::uint32_t>(random()) & 0xFFU, least)));
  };
  int outside = 0;
  for (int i = 0; i < 2000; ++i) {
    Payload payload = bytes({3, 0, 3, 5, 6, 7});
    some(payload, 32, 1);             // states of 256 and more
    payload.push_back(std::byte{0});  // no carried rows
    some(payload, 400, 0);
    const auto chunk = decode(payload);
    if (!chunk && chunk.error() == DecodeError::bad_number) ++outside;
    if (chunk && chunk->layers() != nullptr) REQUIRE(chunk->layers()->valid());
  }
  CHECK(outside > 100);
}

TEST_CASE("rows of kinds that are not") {
  Payload payload = bytes({3, 0, 2, 5, 6});
  payload.resize(payload.size() + 32, std::byte{1});
  Payload first_carried = payload;
  for (const int byte : {1, 1}) first_carried.push_back(static_cast<std::byte>(byte));
  CHECK(fault_of(first_carried) == DecodeError::bad_number);
  payload.push_back(std::byte{16});
  CHECK(fault_of(payload) == DecodeError::bad_number);
}

TEST_CASE("a state that no encoder begins with") {
  for (const int encoding : {1, 3}) {
    Payload payload = encoding == 1
                          ? of_one_material(1, {0, 0})
                          : of_one_material(3, {1, 255, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    payload.back() = std::byte{0};
    CHECK(fault_of(payload) == DecodeError::bad_ending);
  }
  Payload payload = bytes({3, 0, 2, 5, 6});
  payload.resize(payload.size() + 32, std::byte{1});
  payload[payload.size() - 1] = std::byte{0};
  CHECK(fault_of(payload) == DecodeError::bad_ending);
}

TEST_CASE("materials in the states") {
  const Chunk chunk = Chunk::from_layers(hill(1));
  const Layers& layers = *chunk.layers();
  const Payload payload = encoded(chunk);
  REQUIRE(std::to_integer<int>(payload[2]) == 64 + static_cast<int>(layers.materials.size()));
  SECTION("are as many as the list says") {
    for (const int count : {65, 129}) {
      Payload other = payload;
      other[2] = static_cast<std::byte>(count);
      if (count > 127) other.insert(other.begin() + 3, std::byte{1});
      CHECK(fault_of(other) == DecodeError::bad_materials);
    }
  }
  SECTION("are at most sixteen bytes of the states") {
    Payload other = payload;
    other[2] = std::byte{81};
    CHECK(fault_of(other) == DecodeError::bad_materials);
  }
  SECTION("are of version 3 alone") {
    Payload other = payload;
    other[0] = std::byte{4};
    CHECK(fault_of(other) == DecodeError::unknown_encoding);
  }
  SECTION("differ from their neighbours") {
    // Ids are the ends of states, and these come out as they went in.
    Layers alike = layers;
    for (MaterialId& material : alike.materials) material = MaterialId{9};
    std::vector<std::byte> body;
    REQUIRE(codec::encode_layered(alike, 1024, body));
    body.insert(body.begin(), {std::byte{3}, std::byte{0}});
    CHECK(fault_of(body) == DecodeError::bad_materials);
  }
}

/// A level plane of 0 rows above the ground, written from the states on with which it ends.
Payload ended_with(const std::array<std::uint16_t, codec::kLanes>& states,
                   std::initializer_list<int> list = {3, 0, 66}) {
  const std::vector<std::uint8_t> ground(kChunkArea, 0);
  std::vector<std::uint8_t> plane(kChunkArea, 5);
  codec::PlaneIntervals intervals;
  codec::model_plane_scalar(plane.data(), ground.data(), intervals);
  std::vector<std::uint8_t> written(codec::kMaxBytesOfPlane + codec::kScribbled);
  codec::RansSink sink{states, written.data() + written.size()};
  codec::encode_plane_scalar(intervals, sink);
  Payload payload = bytes(list);
  for (const std::uint16_t state : sink.states) {
    payload.push_back(static_cast<std::byte>(state & 0xFF));
    payload.push_back(static_cast<std::byte>(state >> 8));
  }
  for (const std::uint8_t* next = sink.next; next != written.data() + written.size(); ++next) {
    payload.push_back(std::byte{*next});
  }
  return payload;
}

TEST_CASE("states without materials end at 256") {
  std::array<std::uint16_t, codec::kLanes> states;
  states.fill(codec::kMinState);
  REQUIRE(decode(ended_with(states, {3, 0, 2, 7, 9})).has_value());
  for (std::uint16_t& state : states) {
    ++state;
    CHECK(fault_of(ended_with(states, {3, 0, 2, 7, 9})) == DecodeError::bad_ending);
    --state;
  }
}

TEST_CASE("states that end at no materials") {
  std::array<std::uint16_t, codec::kLanes> states;
  states.fill(codec::kMinState);
  states[0] += 7;
  states[1] += 9;
  REQUIRE(decode(ended_with(states)).has_value());
  CHECK(decode(ended_with(states))->layers()->materials == std::vector{MaterialId{7}, MaterialId{9}});
  SECTION("a state whose last byte is missing") {
    states[1] = 2 * codec::kMinState;
  }
  SECTION("an id that is too long") {
    states[1] = states[2] = states[3] = codec::kMinState + 0xFF;
  }
  SECTION("bytes behind the ids") {
    states[15] += 1;
  }
  CHECK(fault_of(ended_with(states)) == DecodeError::bad_ending);
}

TEST_CASE("every error describes itself") {
  for (int error = 0; error <= static_cast<int>(DecodeError::bad_ending); ++error) {
    CHECK(describe(static_cast<DecodeError>(error)).size() > 20);
  }
}

}  // namespace talus
