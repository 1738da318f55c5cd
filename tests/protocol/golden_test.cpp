// Frozen bytes. What is written here is on the wire between programs that were built years apart: if a
// case fails, the schema has changed in a way that old clients cannot read.
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include <talus/protocol/message.h>

#include "hex.h"
#include "sample_frames.h"

namespace talus::protocol {
namespace {

using testing::hex;
using testing::unhex;

constexpr std::string_view kHello =
    "6c0000000c00000008000c000700080008000000000000011400000010001c000400060008000c001000140010000000"
    "0100020034000000200000000c00000000001000000000000a00000073616d706c6520312e3000000b0000006f70656e"
    "20736573616d65000100000001000000";

constexpr std::string_view kChunk =
    "740000000c00000008000c0007000800080000000000000a140000001000400008000c0034001c000700300010000000"
    "0000000107000000fdffffff010000000000008002000000efcdab89674523011032547698badcfe0000000010000000"
    "2a0000000000000000000000050000000102030405000000";

// From before View had `horizon`.
constexpr std::string_view kView =
    "9c0000000c00000008000e0007000800080000000000000218000000000012003c000800240004000600300034003800"
    "120000000800040000000000f0ffffff46000000000000000c000000000000000000000000000000000000bf0000803f"
    "34000000080000000c00000001000000fdffffff010000000000008002000000efcdab89674523011032547698badcfe"
    "00000000020000000100100002002000";

}  // namespace

TEST_CASE("a Hello is these bytes") {
  CHECK(hex(testing::sample_hello()) == kHello);
}

TEST_CASE("a Chunk is these bytes") {
  CHECK(hex(testing::sample_chunk()) == kChunk);
}

TEST_CASE("a View without a horizon is these bytes") {
  CHECK(hex(testing::sample_view(false)) == kView);
  CHECK(hex(testing::sample_view(true)) != kView);
}

TEST_CASE("the frozen View is read, and has no horizon") {
  const Frame frame = unhex(kView);
  const auto* view = read_message(frame).value()->body_as_View();
  REQUIRE(view != nullptr);
  CHECK(view->centre()->y() == 70);
  CHECK(view->horizontal_radius() == 8);
  CHECK(view->rings()->size() == 2);
  CHECK(view->known()->size() == 1);
  CHECK(view->number() == 12);
  CHECK_FALSE(view->horizon());
}

TEST_CASE("the frozen Hello is read") {
  const Frame frame = unhex(kHello);
  const auto* hello = read_message(frame).value()->body_as_Hello();
  REQUIRE(hello != nullptr);
  CHECK(hello->protocol_min() == 1);
  CHECK(hello->protocol_max() == 2);
  CHECK(hello->codecs()->Get(0) == 1);
  CHECK(hello->token()->str() == "open sesame");
  CHECK(hello->client()->str() == "sample 1.0");
  CHECK(hello->window_bytes() == 1U << 20);
}

TEST_CASE("the frozen Chunk is read") {
  const Frame frame = unhex(kChunk);
  const auto* chunk = read_message(frame).value()->body_as_Chunk();
  REQUIRE(chunk != nullptr);
  CHECK(chunk->id() == 7);
  CHECK(chunk->key()->x() == -3);
  CHECK(chunk->key()->z() == -2147483647 - 1);
  CHECK(chunk->key()->lod() == 2);
  CHECK(chunk->revision() == 42);
  CHECK(chunk->hash()->low() == 0x0123456789ABCDEFU);
  CHECK(chunk->codec() == 1);
  CHECK(chunk->payload()->size() == 5);
  CHECK(chunk->payload()->Get(4) == 5);
}

}  // namespace talus::protocol
