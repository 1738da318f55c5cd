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

/// Keeps a file that is to be replaced from other programs, with its journal finished: SQLite would write
/// one that is left into the file that gets its name.
tl::expected<std::optional<saves::SaveFile>, std::string> lock_old(const fs::path& file) {
  std::error_code code;
  const auto status = fs::status(file, code);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return tl::unexpected{fmt::format("{}: is not a regular file; give another name", file.string())};
  }
  if (saves::is_database(file)) {
    auto old = saves::SaveFile::open(file, saves::Access::write);
    if (!old) return tl::unexpected{old.error().message + "; or give another name"};
    return *std::move(old);
  }
  const std::string journal = file.string() + "-journal";
  if (!fs::exists(journal, code)) return std::nullopt;
  return tl::unexpected{
      fmt::format("{}: is the journal of a save that is gone; remove it, or give another name", journal)};
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
        "the store is of the world with fingerprint {}, and {} has {}; give the store's world as --world; if "
        "it has [secret], there is no save of it: export without --save",
        to_string(meta.fingerprint), world_file.empty() ? "the built-in world" : world_file.string(),
        to_string(source->world->fingerprint()))};
  }
  source->saved.settles = settles;
  auto ids = local::material_ids(*source->world, store.materials());
  if (!ids) {
    return tl::unexpected<std::string>{
        "no ids are left for placeable materials; give a world that names fewer new ones"};
  }
  std::set<MaterialId> named;
  for (const auto& [name, id] : *ids) named.insert(id);
  source->saved.materials = *std::move(ids);
  for (const auto& [name, id] : store.materials()) {  // all that the store ever gave an id
    if (to_integer(id) >= edits::kFirstBound) source->saved.materials.emplace(name, id);
  }
  std::error_code code;
  fs::path target = fs::canonical(file, code);  // of a symlink
  if (code) target = file;
  auto old = lock_old(target);
  if (!old) return tl::unexpected{std::move(old.error())};
  const Temporary temporary{target.string() + fmt::format(".new-{}", ::getpid())};
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
    // Both are locked until the old one's journal is gone: nobody else makes one of that name.
    fs::rename(temporary.path, target, code);
    if (code) return tl::unexpected{fmt::format("{}: cannot be written: {}", file.string(), code.message())};
    old->reset();
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path{"."};
  if (const auto synced = store::sync_directory(folder); !synced) return tl::unexpected{synced.error()};
  return result;
}

}  // namespace talus::server
