// The input is a stream from a peer. It is cut in two at every byte and fed to a reader; every frame that
// comes out is verified and, if it is a message, read whole. Where the cut lies must not matter.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include <talus/protocol/frame.h>
#include <talus/protocol/limits.h>
#include <talus/protocol/message.h>

#include "protocol/walk.h"

namespace {

using namespace talus::protocol;

// What a connection would see: digests of the messages up to the first error.
std::vector<std::uint64_t> messages(std::span<const std::byte> first, std::span<const std::byte> second) {
  FrameReader reader{kDefaultClientFrameBytes};
  std::vector<std::uint64_t> digests;
  for (auto piece : {first, second}) {
    while (!piece.empty()) {
      const auto taken = reader.feed(piece);
      if (!taken) return digests;
      piece = piece.subspan(*taken);
      if (!reader.has_frame()) continue;
      const auto message = read_message(reader.frame());
      if (!message) return digests;
      digests.push_back(testing::walk(**message));
      reader.pop();
    }
  }
  return digests;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream = std::as_bytes(std::span{data, size});
  const auto whole = messages(stream, {});
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    if (messages(stream.first(cut), stream.subspan(cut)) != whole) std::abort();
    // Long streams cost a pass per cut; beyond the first messages a coarse step sees the same code.
    if (cut >= 512) cut += stream.size() / 64;
  }
  return 0;
}
