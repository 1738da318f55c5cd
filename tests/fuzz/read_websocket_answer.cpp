// The input is what a server sends to a WebSocket client, from the handshake's answer on. However it is cut,
// the client sees the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <talus/websocket/client_side.h>

namespace {

using namespace talus::websocket;

std::string told(std::vector<std::byte> input, std::size_t piece) {
  // The RFC's example: a corpus can hold the answer that it wants.
  constexpr std::string_view kNonce = "the sample nonce";
  ClientSide side{"host", "/", std::as_bytes(std::span<const char, kNonceBytes>{kNonce.data(), kNonceBytes})};
  std::string all;
  for (std::size_t at = 0; at < input.size() && !side.failure(); at += piece) {
    const auto part = std::span{input}.subspan(at, std::min(piece, input.size() - at));
    const std::size_t kept = side.take(part);
    if (kept > part.size()) std::abort();
    all.append(reinterpret_cast<const char*>(part.data()), kept);
  }
  return all + (side.is_open() ? "|open|" : "|") + (side.failure() ? side.failure()->text : "");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span{data, size});
  const std::vector<std::byte> input{bytes.begin(), bytes.end()};
  const std::string whole = told(input, SIZE_MAX / 2);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, std::size_t{16}}) {
    if (told(input, piece) != whole) std::abort();
  }
  return 0;
}
