// Any bytes given as runs: an error of one line, or voxels in order that come back as these very bytes.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string_view>
#include <vector>

#include <talus/edits/chunk_overrides.h>
#include <talus/edits/runs.h>

namespace {

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_runs: " << what << '\n';
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace talus;
  // An exact copy on the heap, so that a read past the end is one past an allocation too.
  const auto* first = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> block(first, first + size);
  const auto voxels = edits::decode_runs(block);
  if (!voxels) {
    const std::string_view text = edits::describe(voxels.error());
    require(!text.empty() && text.find('\n') == std::string_view::npos, "an error is one line");
    return 0;
  }
  require(voxels->size() <= kChunkVolume, "a chunk has 32,768 voxels");
  require(voxels->empty() || voxels->back().index < kChunkVolume, "indices lie in the chunk");
  const auto falls = [](Override a, Override b) { return a.index >= b.index; };
  require(std::adjacent_find(voxels->begin(), voxels->end(), falls) == voxels->end(),
          "indices rise, each once");
  std::vector<std::byte> again;
  edits::encode_runs(*voxels, again);
  require(again == block, "a set of voxels has one encoding");
  if (!voxels->empty()) {
    const auto fewer = edits::decode_runs(block, voxels->size() - 1);
    require(!fewer && fewer.error() == edits::RunsError::too_many, "the caller's limit holds");
  }
  return 0;
}
