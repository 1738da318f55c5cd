#include "chunks/encoded_chunk.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <span>

#include <rapidcheck.h>

#include <talus/voxel/codec.h>

using namespace talus;
using namespace talus::server;

namespace {

using Bytes = std::vector<std::byte>;

Bytes any_payload() {
  const auto payload = *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
  const auto bytes = std::as_bytes(std::span{payload});
  return {bytes.begin(), bytes.end()};
}

Bytes copy(std::span<const std::byte> bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("a chunk's frame is the message that FlatBuffers would make for that request, key and revision") {
  CHECK(rc::check([] {
    const Bytes payload = any_payload();
    const auto hash =
        *rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::arbitrary<std::uint64_t>());
    const auto revision = *rc::gen::element<std::uint64_t>(0, 1, 0x0102030405060708, UINT64_MAX);
    const auto id = *rc::gen::element<std::uint32_t>(0, 1, 0x01020304, 0xFFFFFFFF);
    const auto at = *rc::gen::arbitrary<std::array<std::int32_t, 3>>();
    const ChunkKey key{{at[0], at[1], at[2]}, Lod::of(*rc::gen::inRange(0, Lod::kMax + 1))};

    const EncodedChunk chunk{{hash.first, hash.second}, payload, revision};
    Bytes output(8);  // frames of others lie before it
    chunk.append_frame(output, id, key);
    chunk.append_frame(output, 7, {});
    RC_ASSERT(output.size() == 8 + 2 * chunk.frame_bytes());
    const Bytes frame(output.begin() + 8, output.end() - static_cast<std::ptrdiff_t>(chunk.frame_bytes()));

    const auto message = protocol::read_message(frame);
    RC_ASSERT(message.has_value());
    const wire::Chunk& read = *(*message)->body_as_Chunk();
    RC_ASSERT(read.id() == id);
    RC_ASSERT((std::array{read.key()->x(), read.key()->y(), read.key()->z()}) == at);
    RC_ASSERT(read.key()->lod() == key.lod.value());
    RC_ASSERT(read.revision() == revision);
    RC_ASSERT(std::pair(read.hash()->low(), read.hash()->high()) == hash);
    RC_ASSERT(read.codec() == kCodecVersion);
    RC_ASSERT(copy(std::as_bytes(std::span{read.payload()->data(), read.payload()->size()})) == payload);
  }));
}

TEST_CASE("a chunk gives its payload exactly, whatever padding follows it in the frame") {
  CHECK(rc::check([] {
    const Bytes payload = any_payload();
    const EncodedChunk chunk{{}, payload, *rc::gen::arbitrary<std::uint64_t>()};
    RC_ASSERT(copy(chunk.payload()) == payload);
    RC_ASSERT(chunk.tail().data() == chunk.payload().data());
    RC_ASSERT(chunk.tail().size() - payload.size() < 8U);
  }));
}

TEST_CASE("a frame in two is the whole frame") {
  CHECK(rc::check([] {
    const EncodedChunk chunk{{1, 2}, any_payload(), 3};
    const ChunkKey key{{-4, 5, 6}, Lod::of(5)};
    Bytes whole;
    chunk.append_frame(whole, 8, key);
    Bytes two;
    chunk.append_head(two, 8, key);
    two.insert(two.end(), chunk.tail().begin(), chunk.tail().end());
    RC_ASSERT(two == whole);
  }));
}

TEST_CASE("a chunk encoded again has its voxels' hash, its payload, and the revision that it is given") {
  Chunk chunk = Chunk::uniform(MaterialId{3});
  Bytes payload;
  encode(chunk, payload);
  for (int again = 0; again < 2; ++again) {
    const EncodedChunkPtr encoded = encode_shared(chunk, 9);
    CHECK(copy(encoded->payload()) == payload);
    CHECK(encoded->hash() == content_hash(chunk));
    CHECK(encoded->revision() == 9);
  }
  CHECK(encode_shared(chunk)->revision() == kBaseRevision);
}

TEST_CASE("prefetching reads nothing outside of the frame, however small or large") {
  for (const std::size_t bytes : {0U, 1U, 1000U, 66'000U}) EncodedChunk{{}, Bytes(bytes)}.prefetch();
}
