#include "player/view/credit.h"

#include <fmt/format.h>

namespace talus::server {

tl::expected<void, CreditError> Credit::taken(std::uint64_t total_bytes) {
  if (total_bytes < taken_bytes_) {
    return tl::make_unexpected(CreditError{
        fmt::format("Credit.total_bytes {} is less than the {} given before; it is a running total",
                    total_bytes, taken_bytes_)});
  }
  if (total_bytes > sent_bytes_) {
    return tl::make_unexpected(
        CreditError{fmt::format("Credit.total_bytes {} is more than the {} bytes of Chunk frames sent so far",
                                total_bytes, sent_bytes_)});
  }
  taken_bytes_ = total_bytes;
  return {};
}

}  // namespace talus::server
