#include <talus/protocol/message.h>

#include <algorithm>
#include <cassert>

#include <talus/protocol/limits.h>

namespace talus::protocol {
namespace {

// A Message, its body and the materials in Welcome nest three deep; a world has at most 255 materials, and
// 1,024 that may be placed.
constexpr flatbuffers::uoffset_t kMaxDepth = 4;
constexpr flatbuffers::uoffset_t kMaxTables = 2048;

// The verifier checks a vector's length, but not the alignment of its elements. Reading misaligned 64-bit
// members would be undefined behaviour.
template <typename Struct>
bool aligned(const flatbuffers::Vector<const Struct*>* vector) {
  return vector == nullptr || vector->size() == 0 ||
         reinterpret_cast<std::uintptr_t>(vector->Data()) % alignof(Struct) == 0;
}

bool vectors_aligned(const wire::Message& message) {
  switch (message.body_type()) {
    case wire::Body::GetChunks:
      return aligned(message.body_as_GetChunks()->requests());
    case wire::Body::View:
      return aligned(message.body_as_View()->known());
    case wire::Body::GetHeights:
      return aligned(message.body_as_GetHeights()->columns());
    case wire::Body::Edit: {
      const wire::Edit& edit = *message.body_as_Edit();
      return aligned(edit.writes()) && aligned(edit.guards()) && aligned(edit.fills());
    }
    case wire::Body::EditBroadcast:
      return aligned(message.body_as_EditBroadcast()->writes());
    default:
      return true;
  }
}

}  // namespace

std::string_view describe(MessageError error) {
  switch (error) {
    case MessageError::not_flatbuffers:
      return "a frame is not a valid FlatBuffers message of the Talus schema";
    case MessageError::no_body:
      return "a message has no body, or one of a kind that this protocol version does not know";
  }
  return "";
}

tl::expected<const wire::Message*, MessageError> read_message(std::span<const std::byte> frame) {
  assert(reinterpret_cast<std::uintptr_t>(frame.data()) % alignof(std::uint64_t) == 0);
  flatbuffers::Verifier::Options options;
  options.max_depth = kMaxDepth;
  options.max_tables = kMaxTables;
  flatbuffers::Verifier verifier{reinterpret_cast<const std::uint8_t*>(frame.data()), frame.size(), options};
  // Also compares the prefix with the frame's size.
  if (!wire::VerifySizePrefixedMessageBuffer(verifier)) return tl::unexpected{MessageError::not_flatbuffers};

  const wire::Message* message = wire::GetSizePrefixedMessage(frame.data());
  if (message->body() == nullptr || message->body_type() == wire::Body::NONE ||
      message->body_type() > wire::Body::MAX) {
    return tl::unexpected{MessageError::no_body};
  }
  if (!vectors_aligned(*message)) return tl::unexpected{MessageError::not_flatbuffers};
  return message;
}

std::uint16_t choose_protocol(std::uint16_t oldest, std::uint16_t newest) {
  const std::uint16_t common = std::min(newest, kProtocolVersion);
  return common >= std::max(oldest, kOldestProtocol) ? common : std::uint16_t{0};
}

}  // namespace talus::protocol
