// The input is what a WebSocket client sends, or a server. Read whole and in pieces, it gives the same bytes
// and the same end, and never more bytes than came.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <talus/websocket/frame_reader.h>

namespace {

using namespace talus::websocket;

std::string told(Sender sender, std::vector<std::byte> input, std::size_t piece) {
  FrameReader reader{sender};
  std::string all;
  for (std::size_t at = 0; at < input.size() && reader.end() == End::none; at += piece) {
    const auto part = std::span{input}.subspan(at, std::min(piece, input.size() - at));
    const std::size_t kept = reader.take(part);
    if (kept > part.size()) std::abort();
    all.append(reinterpret_cast<const char*>(part.data()), kept);
    if (reader.has_ping() && reader.ping().size() > FrameReader::kMaxControlBytes) std::abort();
  }
  return all + "|" + make_error_code(reader.end()).message();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span{data, size});
  const std::vector<std::byte> input{bytes.begin(), bytes.end()};
  for (const Sender sender : {Sender::client, Sender::server}) {
    const std::string whole = told(sender, input, SIZE_MAX / 2);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, std::size_t{16}}) {
      if (told(sender, input, piece) != whole) std::abort();
    }
  }
  return 0;
}
