// Messages: verified views over received frames, and frames made from values.
//
// Nothing of a frame may be read before read_message has verified it. The views that it returns point
// into the frame and live as long as the frame does. Pure functions, callable from any thread.
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

/// Why a frame is no message that may be read.
enum class MessageError : std::uint8_t {
  not_flatbuffers,  // the verifier found offsets, lengths or nesting out of bounds
  no_body,          // a Message without a body, or with a kind this version does not know
};
[[nodiscard]] std::string_view describe(MessageError error);

/// Verifies a whole frame (prefix included, aligned as FrameReader gives it) and returns its message,
/// whose body() is present and of a known kind. Required strings and vectors may still be null: absent
/// means empty.
[[nodiscard]] tl::expected<const wire::Message*, MessageError> read_message(std::span<const std::byte> frame);

/// A frame ready to be written, prefix included.
using Frame = std::vector<std::byte>;

/// Closes `builder` over a message whose body is `body`, and returns the frame.
template <typename Table>
[[nodiscard]] Frame finish_frame(flatbuffers::FlatBufferBuilder& builder, flatbuffers::Offset<Table> body) {
  builder.FinishSizePrefixed(wire::CreateMessage(builder, wire::BodyTraits<Table>::enum_value, body.Union()));
  const auto* bytes = reinterpret_cast<const std::byte*>(builder.GetBufferPointer());
  return {bytes, bytes + builder.GetSize()};
}

/// A message of one body as a frame; `build(builder)` makes the body's table:
///
///   Frame frame = make_frame([&](auto& b) { return wire::CreatePing(b, nonce); });
template <typename Build>
[[nodiscard]] Frame make_frame(Build&& build) {
  flatbuffers::FlatBufferBuilder builder{256};
  const auto body = build(builder);
  return finish_frame(builder, body);
}

/// The newest version both sides speak, or 0: `oldest` to `newest` as a Hello offers them.
[[nodiscard]] std::uint16_t choose_protocol(std::uint16_t oldest, std::uint16_t newest);

}  // namespace talus::protocol
