// native FILE ROUNDS: of each payload that collect.js wrote, microseconds to decode it to dense voxels, as
// JSON; - for ROUNDS: its voxels' hash, or the number of its DecodeError. For comparison with decode.js.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <vector>

#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file{argv[1], std::ios::binary};
  std::vector<std::vector<std::byte>> payloads;
  std::uint32_t size = 0;
  while (file.read(reinterpret_cast<char*>(&size), sizeof size)) {
    payloads.emplace_back(size);
    file.read(reinterpret_cast<char*>(payloads.back().data()), size);
  }
  if (argv[2][0] == '-') {
    for (const auto& payload : payloads) {
      const auto chunk = talus::decode(payload);
      if (chunk) {
        const talus::ContentHash hash = talus::content_hash(*chunk);
        std::printf("%016jx%016jx\n", static_cast<std::uintmax_t>(hash.high),
                    static_cast<std::uintmax_t>(hash.low));
      } else {
        std::printf("error %d\n", static_cast<int>(chunk.error()));
      }
    }
    return 0;
  }
  const auto voxels = std::make_unique<talus::DenseVoxels>();
  std::vector<double> best(payloads.size(), 1e9);
  for (int round = std::atoi(argv[2]); round > 0; --round) {
    for (std::size_t i = 0; i < payloads.size(); ++i) {
      const auto began = std::chrono::steady_clock::now();
      talus::decode(payloads[i])->copy_to(*voxels);
      const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
      best[i] = std::min(best[i], took.count());
    }
  }
  for (std::size_t i = 0; i < best.size(); ++i) std::printf("%c%.2f", i == 0 ? '[' : ',', best[i]);
  std::printf("]\n");
}
