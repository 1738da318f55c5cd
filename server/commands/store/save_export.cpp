#include "commands/store/save_export.h"

#include <unistd.h>

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <talus/edits/runs.h>
#include <talus/files/read_file.h>
#include <talus/progress/progress_bar.h>
#include <talus/saves/save.h>
#include <talus/store/store_swap.h>
#include <talus/toml/toml_bounds.h>
#include <talus/world_files/world_files.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

tl::expected<saves::WorldSource, std::string> read_world_file(const fs::path& file) {
  std::string text{terrain::default_world_toml()};
  if (!file.empty()) {
    auto read = files::read_regular_file(file, kMaxTomlBytes);
    if (!read) return tl::unexpected{fmt::format("world: {}", read.error().message())};
    text = *std::move(read);
  }
  auto source = saves::read_world(std::as_bytes(std::span{text}), world_files::bytes_beside(file));
  if (!source) return tl::unexpected{fmt::format("world: {}: {}", file.string(), source.error().message)};
  return *std::move(source);
}

/// Names of the save: those that the world generates, and all that the store ever gave an id.
edits::MaterialIds names_of(const terrain::World& world, const std::map<std::string, MaterialId>& stored) {
  edits::MaterialIds names;
  for (const terrain::Material& material : world.materials()) names.emplace(material.name, material.id);
  for (const auto& [name, id] : stored) {
    if (to_integer(id) >= edits::kFirstBound) names.emplace(name, id);
  }
  return names;
}

/// A file that goes away unless it is renamed.
struct Temporary {
  fs::path path;
  ~Temporary() {
    std::error_code code;
    fs::remove(path, code);
  }
};

}  // namespace

tl::expected<ExportResult, std::string> export_save(const store::ReadOnlyStore& store,
                                                    const fs::path& world_file, bool settles,
                                                    const fs::path& file) {
  auto source = read_world_file(world_file);
  if (!source) return tl::unexpected{std::move(source.error())};
  const store::StoreMeta& meta = store.meta();
  if (source->world->fingerprint() != meta.fingerprint) {
    return tl::unexpected{fmt::format(
        "the store is of the world with fingerprint {}, and {} has {}; give the store's world as --world",
        to_string(meta.fingerprint), world_file.empty() ? "the built-in world" : world_file.string(),
        to_string(source->world->fingerprint()))};
  }
  source->saved.settles = settles;
  source->saved.materials = names_of(*source->world, store.materials());
  const auto ids = local::placeable_ids(*source->world, source->saved.materials);
  if (!ids) return tl::unexpected<std::string>{"ids of materials that may be placed end"};
  std::set<MaterialId> named{ids->begin(), ids->end()};
  for (const terrain::Material& material : source->world->materials()) named.insert(material.id);
  for (std::size_t i = 0; i < ids->size(); ++i) {
    source->saved.materials.emplace(source->world->placeables()[i].name, (*ids)[i]);
  }
  std::error_code code;
  if (const auto status = fs::status(file, code); fs::exists(status) && !fs::is_regular_file(status)) {
    return tl::unexpected{fmt::format("{}: is no file that may be replaced", file.string())};
  }
  const Temporary temporary{file.string() + fmt::format(".new-{}", ::getpid())};
  ExportResult result;
  {
    auto save = saves::SaveFile::create(temporary.path, source->saved);
    if (!save) return tl::unexpected{std::move(save.error().message)};
    std::optional<std::string> fault;
    const auto check = [&](saves::Result<void> done) {
      if (!done && !fault) fault = std::move(done.error().message);
    };
    check(save->begin());
    edits::StateHash hash;
    ProgressBar progress{"export", "chunks"};
    progress.expect(store.estimated_keys());
    const auto read = store.for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
      progress.advance(1);
      if (fault || stored.voxels.empty()) return !fault;
      for (const Override& voxel : stored.voxels) {
        if (named.contains(voxel.material)) continue;
        const auto name = std::ranges::find(store.materials(), voxel.material,
                                            [](const auto& each) { return each.second; });
        fault = fmt::format(
            "chunk {} has material {}, \"{}\", which the world's file does not name; add a [[placeable]], or "
            "drop "
            "such voxels by talusd store rebase --drop-unknown",
            to_string(chunk), to_integer(voxel.material),
            name == store.materials().end() ? "" : escaped(name->first));
        return false;
      }
      std::vector<std::byte> runs;
      edits::encode_runs(stored.voxels, runs);
      check(save->put(chunk, runs));
      hash.add(chunk, stored.voxels);
      ++result.chunks;
      result.voxels += stored.voxels.size();
      return !fault;
    });
    if (!read && !fault) fault = read.error();
    if (!fault && hash != meta.head.hash) {
      fault = "the store's hash of all edits is wrong; talusd store verify says what is damaged";
    }
    if (!fault) check(save->commit({meta.head.revision, hash}));
    if (fault) return tl::unexpected{*std::move(fault)};
  }
  fs::rename(temporary.path, file, code);
  if (code) return tl::unexpected{fmt::format("{}: cannot be written: {}", file.string(), code.message())};
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
  if (const auto synced = store::sync_directory(folder); !synced) return tl::unexpected{synced.error()};
  return result;
}

}  // namespace talus::server
