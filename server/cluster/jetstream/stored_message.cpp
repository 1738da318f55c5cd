#include "cluster/jetstream/stored_message.h"

#include <cstring>

#include "cluster/jetstream/json_member.h"
#include "config/access/base64url.h"

namespace talus::server::jetstream {

tl::expected<StoredMessage, ApiError> parse_stored_message(std::string_view text) {
  const auto answer = parse_answer(text);
  if (!answer) return tl::unexpected{answer.error()};
  const auto message = answer->find("message");
  if (message == answer->end() || !message->is_object()) {
    return tl::unexpected{ApiError{0, "the answer has no message"}};
  }
  const auto bytes = base64_decode(json_member<std::string>(*message, "data"));
  const auto time = nanoseconds_of(json_member<std::string>(*message, "time"));
  const auto sequence = json_member<std::uint64_t>(*message, "seq");
  if (!bytes || !time || sequence == 0) {
    return tl::unexpected{ApiError{0, "the answer lacks the message's seq, time or data"}};
  }
  StoredMessage stored{sequence, std::vector<std::byte>(bytes->size()), *time};
  if (!bytes->empty()) std::memcpy(stored.bytes.data(), bytes->data(), bytes->size());
  return stored;
}

}  // namespace talus::server::jetstream
