#include <talus/protocol/frame.h>

#include <algorithm>
#include <array>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/protocol/limits.h>

#include "sample_frames.h"

namespace talus::protocol {
namespace {

using Bytes = std::vector<std::byte>;

Bytes prefix(std::uint32_t length) {
  Bytes bytes(kPrefixBytes);
  for (unsigned i = 0; i < kPrefixBytes; ++i) bytes[i] = static_cast<std::byte>((length >> (8 * i)) & 0xFFU);
  return bytes;
}

Bytes framed(const Bytes& body) {
  const Bytes length = prefix(static_cast<std::uint32_t>(body.size()));
  Bytes frame(kPrefixBytes + body.size());
  std::copy(body.begin(), body.end(), std::copy(length.begin(), length.end(), frame.begin()));
  return frame;
}

Bytes concatenated(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Feeds `piece` as a socket's reader would, keeping every frame that becomes whole.
void feed_all(FrameReader& reader, std::span<const std::byte> piece, std::vector<Bytes>& frames) {
  while (!piece.empty()) {
    const auto taken = reader.feed(piece);
    REQUIRE(taken.has_value());
    piece = piece.subspan(*taken);
    if (reader.has_frame()) {
      const auto frame = reader.frame();
      frames.emplace_back(frame.begin(), frame.end());
      reader.pop();
    }
  }
}

std::vector<Bytes> sample_bodies() {
  return {Bytes(8, std::byte{1}), Bytes(9, std::byte{2}), Bytes(50, std::byte{3}), Bytes(8, std::byte{4})};
}

}  // namespace

TEST_CASE("cutting the stream in two at any byte gives the same frames") {
  std::vector<Bytes> expected;
  for (const auto& body : sample_bodies()) expected.push_back(framed(body));
  const Bytes stream = concatenated(expected);
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    FrameReader reader{kServerFrameBytes};
    std::vector<Bytes> frames;
    feed_all(reader, std::span{stream}.first(cut), frames);
    feed_all(reader, std::span{stream}.subspan(cut), frames);
    REQUIRE(frames == expected);
    REQUIRE_FALSE(reader.mid_frame());
  }
}

TEST_CASE("any cutting of any stream gives the same frames") {
  const bool held =
      rc::check("pieces do not matter", [](const std::vector<std::vector<std::uint8_t>>& bodies) {
        std::vector<Bytes> expected;
        for (const auto& values : bodies) {
          const auto bytes = std::as_bytes(std::span{values});
          Bytes body{bytes.begin(), bytes.end()};
          body.resize(std::max(body.size(), std::size_t{kMinFrameBytes} - kPrefixBytes));
          expected.push_back(framed(body));
        }
        const Bytes stream = concatenated(expected);
        FrameReader reader{kServerFrameBytes};
        std::vector<Bytes> frames;
        for (std::size_t at = 0; at < stream.size();) {
          const std::size_t size = std::min(*rc::gen::inRange<std::size_t>(1, 24), stream.size() - at);
          feed_all(reader, std::span{stream}.subspan(at, size), frames);
          at += size;
        }
        RC_ASSERT(frames == expected);
      });
  REQUIRE(held);
}

TEST_CASE("a length outside the limits is refused as soon as its prefix is whole") {
  constexpr std::uint32_t kLimit = 1000;
  const std::array<std::uint32_t, 8> lengths{
      0, 1, kMinFrameBytes - kPrefixBytes - 1, kLimit - 3, kLimit, 1U << 24, 0x7FFFFFFFU, 0xFFFFFFFFU};
  for (const std::uint32_t length : lengths) {
    FrameReader reader{kLimit};
    const Bytes bytes = prefix(length);
    REQUIRE(reader.feed(std::span{bytes}.first(3)) == 3U);
    const auto fed = reader.feed(std::span{bytes}.subspan(3));
    REQUIRE_FALSE(fed.has_value());
    CHECK(fed.error().claimed_bytes == std::uint64_t{length} + kPrefixBytes);
    CHECK(fed.error().limit_bytes == kLimit);
  }
}

TEST_CASE("the least and the greatest allowed length pass") {
  for (const std::size_t size : {std::size_t{kMinFrameBytes}, std::size_t{1000}}) {
    FrameReader reader{1000};
    std::vector<Bytes> frames;
    feed_all(reader, framed(Bytes(size - kPrefixBytes)), frames);
    CHECK(frames.size() == 1);
  }
}

TEST_CASE("after an error every call returns it") {
  FrameReader reader{1000};
  REQUIRE_FALSE(reader.feed(prefix(5000)).has_value());
  const auto again = reader.feed(framed(Bytes(20)));
  REQUIRE_FALSE(again.has_value());
  CHECK(again.error().message() == "a frame of 5004 bytes is announced; 12 to 1000 are allowed");
}

TEST_CASE("memory follows the bytes that came, not the length that was claimed") {
  FrameReader reader{kMaxFrameBytes};
  REQUIRE(reader.feed(prefix(kMaxFrameBytes - kPrefixBytes)) == 4U);
  REQUIRE(reader.feed(Bytes(1)) == 1U);
  CHECK(reader.held_bytes() <= 64);
  REQUIRE(reader.feed(Bytes(100'000)) == 100'000U);
  CHECK(reader.held_bytes() <= 200'010);
}

TEST_CASE("a popped large frame gives its memory back") {
  FrameReader reader{kMaxFrameBytes};
  std::vector<Bytes> frames;
  feed_all(reader, framed(Bytes(1'000'000)), frames);
  CHECK(reader.held_bytes() <= 16U * 1024);
}

TEST_CASE("a reader that holds a frame takes nothing more") {
  FrameReader reader{1000};
  REQUIRE(reader.feed(framed(Bytes(20))) == 24U);
  CHECK(reader.feed(framed(Bytes(20))) == 0U);
}

TEST_CASE("mid_frame distinguishes an early end from a clean one") {
  FrameReader reader{1000};
  CHECK_FALSE(reader.mid_frame());
  const Bytes frame = framed(Bytes(20));
  REQUIRE(reader.feed(std::span{frame}.first(2)).has_value());
  CHECK(reader.mid_frame());
  REQUIRE(reader.feed(std::span{frame}.subspan(2)).has_value());
  CHECK_FALSE(reader.mid_frame());
}

TEST_CASE("frames lie at aligned addresses, the next one too") {
  FrameReader reader{kServerFrameBytes};
  for (const auto& sample : testing::sample_frames()) {
    REQUIRE(reader.feed(sample.frame).has_value());
    CHECK(reinterpret_cast<std::uintptr_t>(reader.frame().data()) % 16 == 0);
    reader.pop();
  }
}

}  // namespace talus::protocol
