#include <talus/protocol/message.h>

#include <array>
#include <cstring>
#include <set>
#include <utility>
#include <vector>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/protocol/frame.h>
#include <talus/protocol/limits.h>

#include "sample_frames.h"
#include "walk.h"

namespace talus::protocol {
namespace {

using testing::sample_frames;

std::vector<std::uint64_t> distinct_digests() {
  std::set<std::uint64_t> digests;
  for (const auto& sample : sample_frames())
    digests.insert(testing::walk(*read_message(sample.frame).value()));
  return {digests.begin(), digests.end()};
}

}  // namespace

TEST_CASE("every kind of message is read as what it was written as") {
  const auto samples = sample_frames();
  REQUIRE(samples.size() == static_cast<std::size_t>(wire::Body::MAX));
  for (const auto& sample : samples) {
    const auto message = read_message(sample.frame);
    REQUIRE(message.has_value());
    CHECK((*message)->body_type() == sample.kind);
  }
  CHECK(distinct_digests().size() == samples.size());
}

TEST_CASE("fields come back as they were set") {
  const Frame frame = make_frame([](auto& b) {
    return wire::CreateError(b, wire::ErrorCode::out_of_range, b.CreateString("y is too high"), 77, 0);
  });
  const auto* error = read_message(frame).value()->body_as_Error();
  REQUIRE(error != nullptr);
  CHECK(error->code() == wire::ErrorCode::out_of_range);
  CHECK(error->text()->str() == "y is too high");
  CHECK(error->request_id() == 77);
}

TEST_CASE("a frame cut short or with bytes after its end is invalid") {
  for (const auto& sample : sample_frames()) {
    for (std::size_t size = 0; size < sample.frame.size(); ++size) {
      const Frame cut{sample.frame.begin(), sample.frame.begin() + static_cast<std::ptrdiff_t>(size)};
      REQUIRE_FALSE(read_message(cut).has_value());
    }
    Frame longer = sample.frame;
    longer.resize(longer.size() + 8);
    CHECK(read_message(longer).error() == MessageError::not_flatbuffers);
  }
}

TEST_CASE("a frame with any one byte changed is refused or can be read safely") {
  for (const auto& sample : sample_frames()) {
    Frame frame = sample.frame;
    for (auto& byte : frame) {
      const auto original = byte;
      for (unsigned value = 0; value < 256; ++value) {
        byte = static_cast<std::byte>(value);
        if (const auto message = read_message(frame)) (void)testing::walk(**message);
      }
      byte = original;
    }
  }
}

TEST_CASE("random changes to many bytes are refused or can be read safely") {
  const auto samples = sample_frames();
  const bool held = rc::check("verified means readable", [&samples] {
    Frame frame = samples[*rc::gen::inRange<std::size_t>(0, samples.size())].frame;
    const auto changes = *rc::gen::inRange(1, 12);
    for (int i = 0; i < changes; ++i) {
      frame[*rc::gen::inRange<std::size_t>(kPrefixBytes, frame.size())] =
          static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>());
    }
    if (const auto message = read_message(frame)) (void)testing::walk(**message);
  });
  REQUIRE(held);
}

TEST_CASE("a message without a body is refused") {
  flatbuffers::FlatBufferBuilder builder;
  builder.FinishSizePrefixed(wire::CreateMessage(builder));
  const auto* bytes = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
  const Frame frame{bytes, bytes + builder.GetSize()};
  CHECK(read_message(frame).error() == MessageError::no_body);
}

TEST_CASE("a body of a kind from the future is refused") {
  flatbuffers::FlatBufferBuilder builder;
  const auto ping = wire::CreatePing(builder, 1);
  const auto future = static_cast<wire::Body>(static_cast<int>(wire::Body::MAX) + 1);
  builder.FinishSizePrefixed(wire::CreateMessage(builder, future, ping.Union()));
  const auto* bytes = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
  const Frame frame{bytes, bytes + builder.GetSize()};
  CHECK(read_message(frame).error() == MessageError::no_body);
}

namespace {

/// Inserts four bytes before the list: its 64-bit elements are misaligned, and every length still fits.
template <typename List>
MessageError refusal_of_misaligned(Frame frame, List&& list_of) {
  const auto* vector = list_of(**read_message(frame));
  const auto list = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(vector) - frame.data());
  const auto read = [&](std::size_t at) { return flatbuffers::ReadScalar<std::uint32_t>(frame.data() + at); };
  const auto write = [&](std::size_t at, std::size_t value) {
    flatbuffers::WriteScalar(frame.data() + at, static_cast<std::uint32_t>(value));
  };
  std::size_t offset = kPrefixBytes;
  while (offset + read(offset) != list) offset += 4;
  write(offset, read(offset) + 4);
  frame.insert(frame.begin() + static_cast<std::ptrdiff_t>(list), 4, std::byte{0});
  write(0, frame.size() - kPrefixBytes);
  const auto message = read_message(frame);
  REQUIRE_FALSE(message.has_value());
  return message.error();
}

}  // namespace

TEST_CASE("a misaligned list of structs is refused") {
  const Frame heights = make_frame([](auto& b) {
    const std::array columns{wire::ColumnPos{1, 2}, wire::ColumnPos{3, 4}};
    return wire::CreateGetHeights(b, 1, b.CreateVectorOfStructs(columns.data(), columns.size()));
  });
  CHECK(refusal_of_misaligned(heights, [](const wire::Message& message) {
          return message.body_as_GetHeights()->columns();
        }) == MessageError::not_flatbuffers);
  const Frame view = make_frame([](auto& b) {
    const std::array known{wire::KnownChunk{{1, 2, 3, 0}, {4, 5}}};
    const wire::Voxel centre{};
    return wire::CreateView(b, &centre, nullptr, 1, 1, 0,
                            b.CreateVectorOfStructs(known.data(), known.size()));
  });
  CHECK(refusal_of_misaligned(view, [](const wire::Message& message) {
          return message.body_as_View()->known();
        }) == MessageError::not_flatbuffers);
}

TEST_CASE("a message aligned from behind its length is refused where it holds a 64-bit field") {
  // What a client makes that finishes the message alone and writes a length before it.
  const auto behind_length = [](auto&& build) {
    flatbuffers::FlatBufferBuilder builder;
    const auto [kind, body] = build(builder);
    builder.Finish(wire::CreateMessage(builder, kind, body));
    Frame frame(kPrefixBytes + builder.GetSize());
    flatbuffers::WriteScalar(frame.data(), builder.GetSize());
    std::memcpy(frame.data() + kPrefixBytes, builder.GetBufferPointer(), builder.GetSize());
    return frame;
  };
  const auto refused = [&](auto&& build) { return !read_message(behind_length(build)).has_value(); };
  using Body = std::pair<wire::Body, flatbuffers::Offset<void>>;
  CHECK(refused([](auto& b) { return Body{wire::Body::Ping, wire::CreatePing(b, 1).Union()}; }));
  CHECK(refused([](auto& b) { return Body{wire::Body::Credit, wire::CreateCredit(b, 1).Union()}; }));
  CHECK(refused([](auto& b) {
    const wire::Voxel centre{};
    return Body{wire::Body::View, wire::CreateView(b, &centre).Union()};
  }));
  CHECK(refused([](auto& b) {
    const auto requests = b.CreateVectorOfStructs(std::vector{wire::ChunkRequest{1, {}, false, {}}});
    return Body{wire::Body::GetChunks, wire::CreateGetChunks(b, requests).Union()};
  }));
  CHECK(refused([](auto& b) {
    const auto columns = b.CreateVectorOfStructs(std::vector{wire::ColumnPos{0, 0}});
    return Body{wire::Body::GetHeights, wire::CreateGetHeights(b, 1, columns).Union()};
  }));
  CHECK(refused([](auto& b) {
    const auto writes = b.CreateVectorOfStructs(std::vector{wire::VoxelWrite{{}, 1}});
    return Body{wire::Body::Edit, wire::CreateEdit(b, 1, writes).Union()};
  }));
  CHECK(refused([](auto& b) {
    return Body{wire::Body::Hello, wire::CreateHello(b, 1, 1, 0, 0, 0, 1000).Union()};
  }));
  CHECK_FALSE(refused([](auto& b) { return Body{wire::Body::Hello, wire::CreateHello(b, 1, 1).Union()}; }));
  CHECK_FALSE(refused([](auto& b) {
    const auto ids = b.CreateVector(std::vector<std::uint32_t>{1});
    return Body{wire::Body::Cancel, wire::CreateCancel(b, ids).Union()};
  }));
}

TEST_CASE("elements of lists have the sizes that PROTOCOL.md says") {
  CHECK(sizeof(wire::ChunkRequest) == 40);
  CHECK(sizeof(wire::KnownChunk) == 32);
  CHECK(sizeof(wire::ColumnPos) == 16);
  CHECK(sizeof(wire::VoxelWrite) == 32);
  CHECK(sizeof(wire::Fill) == 56);
}

TEST_CASE("the newest common version is chosen") {
  struct Case {
    std::uint16_t oldest, newest, chosen;
  };
  static_assert(kOldestProtocol == 2 && kProtocolVersion == 2, "extend the table with the new version");
  constexpr std::array kCases{Case{1, 1, 0},    Case{1, 9, 2}, Case{0, 1, 0},         Case{0, 65535, 2},
                              Case{2, 9, 2},    Case{2, 2, 2}, Case{1, 2, 2},         Case{3, 9, 0},
                              Case{0, 0, 0},    Case{2, 1, 0}, Case{65535, 65535, 0}, Case{1, 0, 0},
                              Case{65535, 1, 0}};
  for (const auto& c : kCases) {
    INFO(c.oldest << " to " << c.newest);
    CHECK(choose_protocol(c.oldest, c.newest) == c.chosen);
  }
}

}  // namespace talus::protocol
