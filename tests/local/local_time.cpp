// For client_sample/web/talus-js/bench/world.js: the milliseconds of CPU of opening a world, and of the mixed
// chunks of a View of radius 8, in a fresh Workspace each time. local_time WORLD.toml ROUNDS
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <string>

#include <talus/local/local.h>

namespace {

using namespace talus;

double now_ms() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Counted final : local::ChunkSink {
  void take(ChunkKey /*key*/, const Chunk& /*chunk*/) override { ++chunks; }
  int chunks = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: local_time WORLD.toml ROUNDS\n", stderr), 2;
  std::ifstream file{argv[1], std::ios::binary};
  const std::string toml{std::istreambuf_iterator<char>{file}, {}};
  double open_ms = std::numeric_limits<double>::max();
  double view_ms = open_ms;
  int chunks = 0;
  for (int round = 0; round < std::atoi(argv[2]); ++round) {
    double began = now_ms();
    const auto world = local::open_world(std::as_bytes(std::span{toml}));
    if (!world) return std::fprintf(stderr, "%s\n", world.error().message.c_str()), 1;
    open_ms = std::min(open_ms, now_ms() - began);
    local::Workspace workspace{*world};
    Counted counted;
    began = now_ms();
    constexpr int kPatch = local::Workspace::kPatchTiles;
    for (int patch_z = -8; patch_z < 12; patch_z += kPatch) {
      for (int patch_x = -8; patch_x < 12; patch_x += kPatch) {
        for (int z = patch_z; z < patch_z + kPatch && z <= 8; ++z) {
          for (int x = patch_x; x < patch_x + kPatch && x <= 8; ++x) {
            const terrain::MixedRange rows = workspace.rows({{x, 0, z}, {}});
            for (std::int32_t y = rows.first; y <= rows.last; ++y) {
              const ChunkKey key{{x, y, z}, {}};
              local::generate(workspace, {&key, 1}, counted);
            }
          }
        }
      }
    }
    view_ms = std::min(view_ms, now_ms() - began);
    chunks = counted.chunks;
  }
  std::printf("{\"openMs\":%.2f,\"viewMs\":%.2f,\"chunks\":%d}\n", open_ms, view_ms, chunks);
}
