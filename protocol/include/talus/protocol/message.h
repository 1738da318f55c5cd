// Messages: received frames are verified and read in place; sent frames are built from values.
//
// read_message() must verify a frame before anything of it is read. What it returns points into the frame and
// lives as long as the frame. Pure functions, callable from any thread.
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

namespace talus::wire {

/// Their names in 0.1; they go with 0.3.
using Column2 [[deprecated("its name is ColumnPos")]] = ColumnPos;
using Column [[deprecated("its name is UniformColumn")]] = UniformColumn;

}  // namespace talus::wire

namespace talus::protocol {

/// Why a frame may not be read.
enum class MessageError : std::uint8_t {
  not_flatbuffers,  // offsets, lengths, nesting or alignment are wrong
  no_body,          // a Message without a body, or with a kind this version does not know
};
[[nodiscard]] std::string_view describe(MessageError error);

/// Verifies a whole frame, prefix included, aligned as FrameReader::frame() is. Returns its message, whose
/// body() is present and of a known kind. Strings, vectors and structs may be null: an absent string or
/// vector is empty.
[[nodiscard]] tl::expected<const wire::Message*, MessageError> read_message(std::span<const std::byte> frame);

/// A frame to be written, prefix included.
using Frame = std::vector<std::byte>;

/// Finishes the message whose body is `body`, and returns its frame.
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

/// The newest protocol version that both sides speak, or 0. A Hello offers `oldest` to `newest`.
[[nodiscard]] std::uint16_t choose_protocol(std::uint16_t oldest, std::uint16_t newest);

}  // namespace talus::protocol
