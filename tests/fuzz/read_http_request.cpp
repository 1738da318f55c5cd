// The input is what a client sends on an HTTP connection. It is read whole and cut in two at every byte of a
// short input, and both must give the same requests; what is kept stays within the bounds.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "net/http/request_parser.h"
#include "net/http/response.h"

namespace {

using namespace talus::server::http;

constexpr RequestBounds kBounds{64, 4, 48, 256};

/// Everything that the parser tells of `input`, fed in pieces of `piece` bytes.
std::string told(std::span<const std::byte> input, std::size_t piece) {
  RequestParser parser{kBounds};
  std::string all;
  while (!input.empty()) {
    const auto bytes = input.first(std::min(piece, input.size()));
    const auto taken = parser.feed(bytes);
    if (!taken) {
      const Response response = response_to(taken.error());
      if (response.status < 400 || response.status > 499) std::abort();
      // Which bound is broken first depends on how much is read at once; that one is does not.
      return all + "error";
    }
    if (*taken > bytes.size() || (*taken == 0 && !parser.has_request())) std::abort();
    input = input.subspan(*taken);
    if (!parser.has_request()) continue;
    const Request& request = parser.request();
    if (request.target.size() > kBounds.target_bytes || request.fields.size() > kBounds.fields) std::abort();
    all +=
        std::to_string(static_cast<int>(request.method)) + request.target + (request.keep_alive ? "+" : "-");
    for (const Field& field : request.fields) {
      if (field.name.size() + field.value.size() > kBounds.field_bytes) std::abort();
      all += field.name + ":" + field.value + ";";
    }
    parser.pop();
  }
  return all + (parser.mid_request() ? "..." : "");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto input = std::as_bytes(std::span{data, size});
  const std::string whole = told(input, SIZE_MAX);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{2}, std::size_t{7}}) {
    if (told(input, piece) != whole) std::abort();
  }
  return 0;
}
