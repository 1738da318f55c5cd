#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <map>
#include <vector>

#include <asio/this_coro.hpp>
#include <asio/use_awaitable.hpp>

#include <talus/client/client.h>
#include <talus/files/npy_file.h>

#include "commands.h"
#include "output.h"
#include "request_timeout.h"

namespace talus::cli {
namespace {

void summarise(const client::ReceivedChunk& received, const client::WorldInfo& world,
               const client::Stats& stats, double waited_ms) {
  std::map<MaterialId, int> counts;
  std::vector<MaterialId> voxels(kChunkVolume);
  received.chunk->copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  for (const MaterialId voxel : voxels) ++counts[voxel];

  std::cout << "chunk " << to_string(received.key) << "\nhash " << to_string(received.hash) << "\nrevision "
            << received.revision << "\nframe " << stats.chunk_bytes << " bytes, " << waited_ms << " ms\n";
  for (const auto& [id, count] : counts) {
    std::string name = "material " + std::to_string(to_integer(id));
    for (const auto& material : world.materials) {
      if (material.id == id) name = material.name;
    }
    std::cout << "  " << name << ' ' << count << '\n';
  }
}

/// Shape (32, 32, 32), axes y, z, x: uint8 if every material of the world has an id below 256, as talus-gen
/// export writes it, otherwise uint16.
tl::expected<void, files::FileError> write_npy(const std::filesystem::path& path, const Chunk& chunk,
                                               const std::vector<client::Material>& materials) {
  const bool narrow = std::all_of(materials.begin(), materials.end(),
                                  [](const auto& material) { return to_integer(material.id) < 256; });
  auto file = files::NpyFile::create(path, narrow ? files::NpyType::uint8 : files::NpyType::uint16);
  if (!file) return tl::unexpected{file.error()};
  std::vector<MaterialId> voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  const auto write = [&](auto id) {
    std::vector<decltype(id)> ids(voxels.size());
    std::transform(voxels.begin(), voxels.end(), ids.begin(),
                   [](MaterialId voxel) { return static_cast<decltype(id)>(to_integer(voxel)); });
    return file->write(0, ids);
  };
  if (auto written = narrow ? write(std::uint8_t{}) : write(std::uint16_t{}); !written) return written;
  constexpr std::array<std::size_t, 3> kShape{kChunkSize, kChunkSize, kChunkSize};
  if (auto finished = file->finish(kShape); !finished) return finished;
  return file->commit();
}

}  // namespace

asio::awaitable<CommandResult> get(ConnectTarget target, GetOptions options) {
  if (const auto checked = check_output(options.output); !checked) co_return checked;
  const auto executor = co_await asio::this_coro::executor;
  client::Client client{executor, target.options};
  const RequestTimeout timeout{executor, *target.options.clock, client,
                               RequestTimeout::Seconds{options.timeout_seconds}};
  const auto world = co_await client.connect(target.server.host, std::to_string(target.server.port));
  if (!world) co_return tl::unexpected{timeout.explain(world.error())};

  const auto asked = std::chrono::steady_clock::now();
  const auto chunk = co_await client.get(options.key);
  if (!chunk) co_return tl::unexpected{timeout.explain(chunk.error())};
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - asked;

  if (options.output.empty()) {
    summarise(*chunk, *world, client.stats(), took.count());
    co_return CommandResult{};
  }
  co_return write_npy(options.output, *chunk->chunk, world->materials).map_error([](const auto& error) {
    return error.message();
  });
}

}  // namespace talus::cli
