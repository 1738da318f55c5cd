// Writes what payload_vectors.h has: write_vectors SOURCE_DIRECTORY. For whoever adds a vector, or changes
// the codec together with its version.
#include <cstdio>
#include <fstream>
#include <string>

#include "payload_vectors.h"
#include "sample_chunks.h"

int main(int argc, char** argv) {
  using namespace talus::testing;
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_vectors SOURCE_DIRECTORY\n");
    return 2;
  }
  const std::string source = argv[1];
  std::ofstream{source + "/core/voxel/vectors/payloads.txt"} << payload_vectors();
  for (const FrozenChunk& chunk : frozen_chunks()) {
    const auto payload = encoded(chunk.chunk);
    std::ofstream file{source + "/tests/voxel/golden/v4/" + chunk.name + ".bin", std::ios::binary};
    file.write(reinterpret_cast<const char*>(payload.data()), static_cast<std::streamsize>(payload.size()));
  }
  for (const WorkedExample& example : worked_examples()) {
    std::printf("%s:", example.name.c_str());
    for (const std::byte byte : example.payload) std::printf(" %02x", std::to_integer<unsigned>(byte));
    std::printf("\n");
  }
}
