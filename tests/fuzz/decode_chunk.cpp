// Any bytes given to decode: an error, or a chunk that is sound and comes back from its own bytes.
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

namespace {

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_chunk: " << what << '\n';
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus;
  // An exact copy on the heap, so that a read past the end is one past an allocation too.
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> payload(first, first + size);
  const auto chunk = decode(payload);
  if (!chunk) {
    require(!describe(chunk.error()).empty(), "an error describes itself");
    return 0;
  }
  require(chunk->layers() == nullptr || chunk->layers()->valid(), "decoded layers are valid");

  auto voxels = std::make_unique<DenseVoxels>();
  chunk->copy_to(*voxels);
  require(Chunk::from_dense(*voxels) == *chunk, "a chunk equals its dense voxels");

  std::vector<std::byte> again;
  encode(*chunk, again);
  require(again.size() <= kMaxPayloadBytes, "no payload is larger than raw voxels");
  const auto twice = decode(again);
  require(twice.has_value(), "what encode wrote, decode reads");
  require(content_hash(*twice) == content_hash(*chunk), "a chunk comes back from its own bytes");
  return 0;
}
