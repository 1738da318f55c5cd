#include "commands/store/store_figures.h"

#include <vector>

#include <fmt/format.h>

#include <talus/edits/levels.h>

namespace talus::server {
namespace {

void expect_coarse(ChunkCoord chunk, const store::StoredChunk& stored, StoreFigures& figures) {
  std::vector<edits::OverrideWrite> writes;
  writes.reserve(stored.voxels.size());
  for (const Override& voxel : stored.voxels) writes.push_back({voxel.index, voxel.material});
  for (const edits::ChunkWrites& coarse : edits::coarse_writes(chunk, writes)) {
    auto& level = figures.levels[static_cast<std::size_t>(coarse.key.lod.value())];
    for (const edits::OverrideWrite& write : coarse.writes) {
      level.expected.add(coarse.key.coord, Override{write.index, *write.material});
    }
  }
}

}  // namespace

tl::expected<StoreFigures, std::string> read_figures(const store::ReadOnlyStore& store,
                                                     ProgressBar& progress) {
  StoreFigures figures;
  progress.expect(store.estimated_keys());
  const auto read = store.for_each_chunk([&](ChunkKey key, const store::StoredChunk& chunk) {
    progress.advance(1);
    if (chunk.voxels.empty()) {
      ++figures.emptied_chunks;
      return true;
    }
    auto& level = figures.levels[static_cast<std::size_t>(key.lod.value())];
    ++level.chunks;
    level.voxels += chunk.voxels.size();
    level.hash.add(key.coord, chunk.voxels);
    if (key.lod == Lod{}) {
      for (const Override& voxel : chunk.voxels) ++figures.materials[voxel.material];
      expect_coarse(key.coord, chunk, figures);
    }
    return true;
  });
  if (!read) return tl::unexpected{read.error()};
  const auto editors = store.count_editors();
  if (!editors) return tl::unexpected{editors.error()};
  figures.editors = *editors;
  return figures;
}

tl::expected<std::map<MaterialId, std::uint64_t>, std::string> voxels_by_material(
    const store::ReadOnlyStore& store) {
  std::map<MaterialId, std::uint64_t> voxels;
  ProgressBar progress{"counting materials", "chunks"};
  progress.expect(store.estimated_keys());
  const auto read = store.for_each_base_chunk([&](ChunkCoord, const store::StoredChunk& chunk) {
    progress.advance(1);
    for (const Override& voxel : chunk.voxels) ++voxels[voxel.material];
    return true;
  });
  if (!read) return tl::unexpected{read.error()};
  return voxels;
}

tl::expected<void, std::string> verify(const store::ReadOnlyStore& store, const StoreFigures& figures) {
  const store::StoreReader reader = store.reader();
  const store::StoreMeta& meta = store.meta();
  if (figures.levels[0].hash != meta.head.hash) {
    return reader.failure(fmt::format("its overrides hash to {}, and its record is {}; {}",
                                      edits::to_string(figures.levels[0].hash),
                                      edits::to_string(meta.head.hash), store::kStoreLost));
  }
  for (std::size_t level = 1; level < figures.levels.size(); ++level) {
    if (figures.levels[level].hash != figures.levels[level].expected) {
      return reader.failure(fmt::format("level {} does not match level 0; {}", level, store::kStoreLost));
    }
  }
  std::uint64_t last = store.first_record() - 1;
  const auto read = reader.for_each_record(meta, last + 1, [&](store::LogRecord&& record) {
    if (record.position != last + 1) return false;
    last = record.position;
    return true;
  });
  if (!read) return read;
  if (last != meta.head.position) {
    return reader.failure(fmt::format("entry {} of its log is lost; {}", last + 1, store::kStoreLost));
  }
  return store.verify_files();
}

}  // namespace talus::server
