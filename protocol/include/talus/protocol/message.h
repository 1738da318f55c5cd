// Messages: received frames are verified and read in place; frames to send are built from values.
//
// read_message() must verify a frame before its contents are used. Its result points into the frame and is
// valid as long as the frame. Pure functions, callable from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <flatbuffers/flatbuffers.h>
#include <tl/expected.hpp>

#include <talus/protocol/talus_generated.h>

namespace talus::protocol {

/// Reason to reject a frame.
enum class MessageError : std::uint8_t {
  not_flatbuffers,  // invalid offsets, lengths, nesting or alignment
  no_body,          // a Message without a body, or with a body type unknown to this version
};
[[nodiscard]] std::string_view describe(MessageError error);

/// Verifies a complete frame, prefix included, aligned like FrameReader::frame(). The body() of the returned
/// message is present and of a known type. Strings, vectors and structs may be null: an absent string or
/// vector is empty.
[[nodiscard]] tl::expected<const wire::Message*, MessageError> read_message(std::span<const std::byte> frame);

/// A frame to send, prefix included.
using Frame = std::vector<std::byte>;

/// Finishes a message with `body` and returns its frame.
template <typename Table>
[[nodiscard]] Frame finish_frame(flatbuffers::FlatBufferBuilder& builder, flatbuffers::Offset<Table> body) {
  builder.FinishSizePrefixed(wire::CreateMessage(builder, wire::BodyTraits<Table>::enum_value, body.Union()));
  const auto* bytes = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
  return {bytes, bytes + builder.GetSize()};
}

/// Builds a frame; `build(builder)` returns the offset of the body's table:
///
///   Frame frame = make_frame([&](auto& b) { return wire::CreatePing(b, nonce); });
template <typename Build>
[[nodiscard]] Frame make_frame(Build&& build) {
  flatbuffers::FlatBufferBuilder builder{256};
  const auto body = build(builder);
  return finish_frame(builder, body);
}

/// Newest protocol version that both sides support, or 0. The Hello offers `oldest` to `newest`.
[[nodiscard]] std::uint16_t choose_protocol(std::uint16_t oldest, std::uint16_t newest);

}  // namespace talus::protocol
