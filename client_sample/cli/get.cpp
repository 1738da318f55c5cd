#include <chrono>
#include <iostream>
#include <map>

#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/client.h>

#include "commands.h"
#include "npy.h"
#include "output_file.h"
#include "patience.h"

namespace talus::cli {
namespace {

void summarise(const client::ReceivedChunk& received, const client::WorldInfo& world,
               const client::Stats& stats, double milliseconds) {
  std::map<MaterialId, int> counts;
  std::vector<MaterialId> voxels(kChunkVolume);
  received.chunk->copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  for (const MaterialId voxel : voxels) ++counts[voxel];

  std::cout << "chunk " << to_string(received.key) << "\nhash " << to_string(received.hash) << "\nrevision "
            << received.revision << "\nframe " << stats.chunk_bytes << " bytes, " << milliseconds << " ms\n";
  for (const auto& [id, count] : counts) {
    std::string name = "material " + std::to_string(to_integer(id));
    for (const auto& material : world.materials) {
      if (material.id == id) name = material.name;
    }
    std::cout << "  " << name << ' ' << count << '\n';
  }
}

}  // namespace

asio::awaitable<Outcome> get(Connecting connecting, GetOptions options) {
  const auto executor = co_await asio::this_coro::executor;
  client::Client client{executor, connecting.options};
  const Patience patience{executor, client, Patience::Seconds{options.timeout_seconds}};
  const auto world = co_await client.connect(connecting.server.host, connecting.server.port);
  if (!world) co_return tl::unexpected{patience.explain(world.error())};

  const auto asked = std::chrono::steady_clock::now();
  const auto chunk = co_await client.get(options.key);
  if (!chunk) co_return tl::unexpected{patience.explain(chunk.error())};
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - asked;

  if (options.output.empty()) {
    summarise(*chunk, *world, client.stats(), took.count());
    co_return Outcome{};
  }
  co_return write_file(options.output, npy_of(*chunk->chunk, world->materials));
}

}  // namespace talus::cli
