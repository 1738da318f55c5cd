#include "commands/store/transfer.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/files/file_layer.h>
#include <talus/progress/progress_bar.h>
#include <talus/store/edit_database.h>
#include <talus/store/regular_files.h>
#include <talus/store/store_builder.h>
#include <talus/store/store_swap.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/voxel/material_name.h>

#include "commands/store/opened_store.h"
#include "commands/store/portable_file.h"
#include "commands/store/store_figures.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> of_file(const fs::path& file, std::string_view what) {
  return tl::unexpected{fmt::format("{}: {}", file.string(), what)};
}

/// Ids for placed materials that none has, the lowest first.
class FreeIds {
 public:
  /// `taken` outlives it, and loses none.
  explicit FreeIds(const std::set<MaterialId>& taken) : taken_{taken} {}
  [[nodiscard]] tl::expected<MaterialId, std::string> next() {
    while (next_ <= UINT16_MAX && taken_.contains(MaterialId{static_cast<std::uint16_t>(next_)})) ++next_;
    if (next_ <= UINT16_MAX) return MaterialId{static_cast<std::uint16_t>(next_)};
    return tl::unexpected{
        fmt::format("all ids of materials that may be placed, {} to {}, are taken for ever; "
                    "begin with a new data directory",
                    edits::kFirstBound, UINT16_MAX)};
  }

 private:
  const std::set<MaterialId>& taken_;
  std::uint32_t next_ = edits::kFirstBound;
};

/// A file that is read from the front, in large pieces.
class InputFile {
 public:
  explicit InputFile(const fs::path& path)
      : file_{files::system_files().open_to_read(path, files::FileLayer::Waiting::never)} {}
  ~InputFile() {
    if (file_) files::system_files().close(*file_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  tl::expected<std::size_t, std::string> read(std::span<std::byte> into) {
    if (!file_) return tl::unexpected{"cannot be read: " + file_.error().message()};
    std::size_t done = 0;
    while (done < into.size()) {
      const auto got = files::system_files().read(*file_, into.subspan(done));
      if (!got) return tl::unexpected{"cannot be read: " + got.error().message()};
      if (*got == 0) break;
      done += *got;
    }
    bytes_ += done;
    return done;
  }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  files::FileLayer::Result<int> file_;
  std::uint64_t bytes_ = 0;
};

/// Refuses names that no world gives: the log has no room for long ones, and the others are printed as they
/// are.
tl::expected<void, std::string> check_names_of_file(const std::map<std::string, MaterialId>& materials) {
  for (const auto& [name, id] : materials) {
    if ((name == "air" && id == kAir) || (name == "water" && id == kWater)) continue;
    if (const auto fault = material_name_fault(name)) {
      return tl::unexpected{
          fmt::format("its material {} is called \"{}\": {}", to_integer(id), escaped(name), *fault)};
    }
  }
  return {};
}

/// What the file's materials are in the store, and the store's table with what is new in it.
struct MaterialMap {
  std::map<MaterialId, MaterialId> to;
  std::map<std::string, MaterialId> all;
  /// Placed in the file, while the store's world generates one of that name. It is an override only where the
  /// ground is another, which takes the world to tell.
  std::map<MaterialId, std::string> generated_now;
  /// Generated in the file, while it is known what its world generates, and not that.
  std::map<MaterialId, std::string> not_generated;
};

using GeneratedIds = std::optional<std::set<MaterialId>>;  // none: it is not known

/// What the world with that fingerprint generates, by `world` where it is that one, else by a store of it.
GeneratedIds generated_by(const terrain::World* world, ContentHash fingerprint,
                          const std::map<std::string, MaterialId>& stored) {
  std::set<MaterialId> ids;
  if (world != nullptr && world->fingerprint() == fingerprint) {
    for (const terrain::Material& material : world->materials()) ids.insert(material.id);
    return ids;
  }
  for (const auto& [name, id] : stored) {
    if (to_integer(id) < edits::kFirstBound) ids.insert(id);
  }
  return ids.empty() ? GeneratedIds{} : ids;
}

/// Both are of one world: what that generates has one id in both, whatever its name was then.
tl::expected<MaterialMap, std::string> map_materials(const std::map<std::string, MaterialId>& from,
                                                     const std::map<std::string, MaterialId>& into,
                                                     const GeneratedIds& by_world) {
  MaterialMap map{{}, into, {}, {}};
  std::set<MaterialId> taken;
  for (const auto& [name, id] : into) taken.insert(id);
  FreeIds free{taken};
  for (const auto& [name, id] : from) {
    const auto held = into.find(name);
    const bool generated = to_integer(id) < edits::kFirstBound;
    if (!generated && held != into.end() && to_integer(held->second) < edits::kFirstBound) {
      map.generated_now.emplace(id, name);
      continue;
    }
    if (generated && by_world && id != kAir && !by_world->contains(id)) {
      map.not_generated.emplace(id, name);
      continue;
    }
    MaterialId mapped = id;
    if (!generated && held != into.end()) mapped = held->second;
    if (!generated && held == into.end() && taken.contains(id)) {
      const auto other = free.next();
      if (!other) return tl::unexpected{other.error()};
      mapped = *other;
    }
    map.to.emplace(id, mapped);
    if (taken.insert(mapped).second) map.all.emplace(name, mapped);
  }
  return map;
}

/// Of both, by rising index; of a voxel that both have that of `winner`.
std::vector<Override> united(std::span<const Override> of_file, std::span<const Override> of_store,
                             Winner winner, std::uint64_t& both) {
  std::vector<Override> all;
  all.reserve(of_file.size() + of_store.size());
  auto file = of_file.begin();
  auto store = of_store.begin();
  while (file != of_file.end() || store != of_store.end()) {
    if (store == of_store.end() || (file != of_file.end() && file->index < store->index)) {
      all.push_back(*file++);
    } else if (file == of_file.end() || store->index < file->index) {
      all.push_back(*store++);
    } else {
      ++both;
      all.push_back(winner == Winner::file ? *file : *store);
      ++file;
      ++store;
    }
  }
  return all;
}

}  // namespace

tl::expected<Exported, std::string> export_edits(const store::ReadOnlyStore& store, const fs::path& file) {
  auto target = files::AtomicFile::create(file);
  if (!target) return tl::unexpected{target.error().message()};
  std::uint64_t offset = 0;
  PortableWriter writer{[&](std::span<const std::byte> bytes) -> PortableWriter::Done {
    auto written = target->write_at(offset, bytes);
    if (!written) return tl::unexpected{written.error().message()};
    offset += bytes.size();
    return {};
  }};
  const store::StoreMeta& meta = store.meta();
  const auto begun = writer.begin({meta.fingerprint, meta.store_id, meta.head, store.materials()});
  if (!begun) return tl::unexpected{begun.error()};
  std::set<MaterialId> named;
  for (const auto& [name, id] : store.materials()) named.insert(id);
  ProgressBar progress{"export", "chunks"};
  progress.expect(store.estimated_keys());
  PortableWriter::Done added;
  const auto read = store.for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
    progress.advance(1);
    for (const Override& voxel : stored.voxels) {
      if (named.contains(voxel.material)) continue;
      added = tl::unexpected{fmt::format(
          "material {} has no name in the store; start talusd once with the store's world, which names what "
          "it "
          "generates; voxels of what that does not generate are lost by talusd store rebase --drop-unknown",
          to_integer(voxel.material))};
      return false;
    }
    added = writer.add(chunk, stored.voxels);
    return added.has_value();
  });
  if (!read) return tl::unexpected{read.error()};
  if (added) added = writer.end();
  if (!added) return tl::unexpected{added.error()};
  if (const auto committed = target->commit(); !committed) return tl::unexpected{committed.error().message()};
  return Exported{writer.chunks(), writer.voxels()};
}

tl::expected<Rebuilt, std::string> import_edits(const fs::path& file, const store::DataDirectory& directory,
                                                Winner winner, std::int64_t now_ms,
                                                const terrain::World* world) {
  std::error_code code;
  const std::uint64_t file_bytes = fs::file_size(file, code);
  InputFile input{file};
  auto opened = PortableReader::open([&](std::span<std::byte> into) { return input.read(into); });
  if (!opened) return of_file(file, opened.error());
  PortableReader& reader = *opened;
  const PortableHeader& header = reader.header();
  if (const auto named = check_names_of_file(header.materials); !named) return of_file(file, named.error());
  std::unique_ptr<store::ReadOnlyStore> store;
  if (directory.has_store()) {
    auto there = open_whole(directory);
    if (!there) return tl::unexpected{there.error()};
    store = *std::move(there);
    if (store->meta().fingerprint != header.fingerprint) {
      return of_file(
          file, fmt::format("it is of the world with fingerprint {}, the store of that with {}; import it "
                            "into an empty directory and rebase that",
                            to_string(header.fingerprint), to_string(store->meta().fingerprint)));
    }
  }
  const store::StoreMeta before = store == nullptr ? store::StoreMeta{} : store->meta();
  const auto names = store == nullptr ? std::map<std::string, MaterialId>{} : store->materials();
  const GeneratedIds generated = generated_by(world, header.fingerprint, names);
  const auto mapped = map_materials(header.materials, names, generated);
  if (!mapped) return of_file(file, mapped.error());
  const MaterialMap& materials = *mapped;
  if (const auto enough =
          store::check_space(directory.path(), file_bytes + store::bytes_of_files(directory.path() / "db"));
      !enough) {
    return tl::unexpected{enough.error()};
  }
  const auto staging = store::make_staging(directory.path());
  if (!staging) return tl::unexpected{staging.error()};
  Rebuilt rebuilt;
  rebuilt.store_id = store::random_store_id();
  rebuilt.compared = generated.has_value();
  auto made = store::StoreBuilder::create(*staging, {rebuilt.store_id, header.fingerprint},
                                          before.head.position, before.link);
  if (!made) return tl::unexpected{made.error()};
  store::StoreBuilder& builder = **made;
  const std::uint64_t revision = before.head.revision + 1;

  ProgressBar progress{"import", "bytes"};
  progress.expect(file_bytes);
  std::optional<PortableChunk> next;  // of the file
  std::uint64_t shown = 0;
  const auto take_next = [&]() -> store::StoreBuilder::Done {
    auto chunk = reader.next();
    if (!chunk) return of_file(file, chunk.error());
    next = *std::move(chunk);
    progress.advance(input.bytes() - std::exchange(shown, input.bytes()));
    if (!next) return {};
    for (Override& voxel : next->voxels) {
      const auto at = materials.to.find(voxel.material);
      if (const auto now = materials.generated_now.find(voxel.material);
          now != materials.generated_now.end()) {
        return of_file(
            file, fmt::format("\"{0}\" is placed in it, and the store's world generates a material of that "
                              "name; import it into an empty directory, rebase that to the store's world, "
                              "and import what is exported from there",
                              escaped(now->second)));
      }
      if (const auto none = materials.not_generated.find(voxel.material);
          none != materials.not_generated.end()) {
        return of_file(
            file, fmt::format(
                      "chunk {} has material {}, \"{}\", which its world does not generate; give the world's "
                      "file as --world if that has it by now; else lose those voxels by talusd store "
                      "rebase --drop-unknown where the file was exported, and export it again",
                      to_string(next->chunk), to_integer(voxel.material), escaped(none->second)));
      }
      if (at == materials.to.end()) {
        return of_file(file,
                       fmt::format("chunk {} has material {}, which the file does not name; export it again",
                                   to_string(next->chunk), to_integer(voxel.material)));
      }
      voxel.material = at->second;
    }
    return {};
  };
  store::StoreBuilder::Done done = take_next();
  // The file's chunks that come before `key`; all that are left where there is none.
  const auto add_before = [&](const std::string* key) {
    while (done && next && (key == nullptr || store::chunk_key({next->chunk, Lod{}}) < *key)) {
      done = builder.add(next->chunk, revision, next->voxels);
      if (done) done = take_next();
    }
  };
  if (store != nullptr && done) {
    const auto read = store->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
      const std::string key = store::chunk_key({chunk, Lod{}});
      add_before(&key);
      if (!done) return false;
      if (next && next->chunk == chunk) {
        done = builder.add(chunk, revision, united(next->voxels, stored.voxels, winner, rebuilt.both));
        if (done) done = take_next();
      } else {
        done = builder.add(chunk, stored.revision, stored.voxels);
      }
      return done.has_value();
    });
    if (!read) return tl::unexpected{read.error()};
  }
  add_before(nullptr);
  for (const auto& [name, id] : materials.all) {
    if (done) done = builder.add(name, id);
  }
  // Nothing in the file needs a time to come, and a store that begins there would date all its edits by it.
  if (done) {
    done = builder.finish(revision, std::max(before.head.time_ms, std::min(header.head.time_ms, now_ms)));
  }
  if (!done) return tl::unexpected{done.error()};
  store.reset();
  auto replaced = store::swap_in(directory.path());
  if (!replaced) return tl::unexpected{replaced.error()};
  rebuilt.chunks = builder.chunks();
  rebuilt.voxels = builder.voxels();
  rebuilt.replaced = *std::move(replaced);
  return rebuilt;
}

tl::expected<std::map<std::string, MaterialId>, std::string> rebased_materials(
    const std::map<std::string, MaterialId>& stored, const terrain::World& world) {
  std::map<std::string, MaterialId> names;
  std::set<MaterialId> taken;
  for (const terrain::Material& material : world.materials()) names.emplace(material.name, material.id);
  for (const auto& [name, id] : stored) taken.insert(id);  // for ever
  FreeIds free{taken};
  for (const terrain::Placeable& placeable : world.placeables()) {
    const auto held = stored.find(placeable.name);
    const bool keeps = held != stored.end() && to_integer(held->second) >= edits::kFirstBound;
    const tl::expected<MaterialId, std::string> id = keeps ? held->second : free.next();
    if (!id) return tl::unexpected{id.error()};
    taken.insert(*id);
    names.emplace(placeable.name, *id);
  }
  return names;
}

namespace {

/// What each material of the store is in the world; none where that has none of its name.
struct Renaming {
  std::map<MaterialId, std::string> names;             // of the store
  std::map<MaterialId, std::optional<MaterialId>> to;  // by need
  const std::map<std::string, MaterialId>* into = nullptr;

  std::optional<MaterialId> operator()(MaterialId material) {
    const auto [at, added] = to.try_emplace(material);
    const auto name = added ? names.find(material) : names.end();
    if (name != names.end()) {
      if (const auto id = into->find(name->second); id != into->end()) at->second = id->second;
    }
    return at->second;
  }
  [[nodiscard]] bool changes(MaterialId material) {
    const auto id = (*this)(material);
    return id && *id != material;
  }
};

/// Refuses where the store has voxels of materials that the world has not.
tl::expected<void, std::string> check_names(const store::ReadOnlyStore& store, Renaming& renaming) {
  const auto uses = voxels_by_material(store);
  if (!uses) return tl::unexpected{uses.error()};
  std::map<std::string, std::uint64_t> unknown;
  for (const auto& [material, voxels] : *uses) {
    if (renaming(material)) continue;
    const auto name = renaming.names.find(material);
    unknown[name == renaming.names.end() ? fmt::format("material {}", to_integer(material)) : name->second] =
        voxels;
  }
  if (unknown.empty()) return {};
  std::string list;
  std::uint64_t voxels = 0;
  for (const auto& [name, count] : unknown) {
    if (list.size() < 200) list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", escaped(name), count);
    voxels += count;
  }
  return tl::unexpected{
      fmt::format("the world names no {}: {} voxels; add them to the world as [[placeable]], rename "
                  "them by talusd store rename, or give --drop-unknown to lose those voxels",
                  list, voxels)};
}

/// Chunks as the world generates them, asked for column by column.
class BaseChunkMaker {
 public:
  explicit BaseChunkMaker(const terrain::World& world) : world_{world}, generator_{world} {}

  void make(ChunkCoord chunk, DenseVoxels& voxels) {
    if (const auto material = terrain::uniform_everywhere(world_, {chunk, Lod{}})) {
      voxels.fill(*material);
      return;
    }
    const VoxelPos origin = chunk_origin(chunk);
    const terrain::Region region{origin.x, origin.z, kChunkSize, kChunkSize, Lod{}};
    if (!(stacks_.region == region)) generator_.generate(region, stacks_);
    terrain::extract_chunk(world_, stacks_, chunk).copy_to(voxels);
  }

 private:
  const terrain::World& world_;
  terrain::Generator generator_;
  terrain::Stacks stacks_;
};

}  // namespace

tl::expected<Rebuilt, std::string> rebase_edits(const store::DataDirectory& directory,
                                                const terrain::World& world, bool drop_unknown) {
  auto opened = open_whole(directory);
  if (!opened) return tl::unexpected{opened.error()};
  std::unique_ptr<store::ReadOnlyStore> store = *std::move(opened);
  const store::StoreMeta before = store->meta();
  const bool same_land = before.fingerprint == world.fingerprint();
  const auto named = rebased_materials(store->materials(), world);
  if (!named) return tl::unexpected{fmt::format("data {}: {}", directory.path().string(), named.error())};
  const std::map<std::string, MaterialId>& materials = *named;
  Renaming renaming{{}, {}, &materials};
  for (const auto& [name, id] : store->materials()) renaming.names.emplace(id, name);
  if (same_land) {
    // What is generated has one id, whatever the file called it when the server started last.
    for (const terrain::Material& material : world.materials()) renaming.to.emplace(material.id, material.id);
  }
  if (!drop_unknown || same_land) {
    const auto known = check_names(*store, renaming);
    if (!known && !drop_unknown) return tl::unexpected{known.error()};
    // A material that was placed and is generated now is another one, though nothing is built of it:
    // talusd refuses its name.
    const bool same_materials = std::ranges::none_of(
        store->materials(), [&](const auto& each) { return renaming.changes(each.second); });
    if (known && same_land && same_materials) {
      return tl::unexpected{
          fmt::format("data {}: the store is of that world already, {}; nothing is to be done",
                      directory.path().string(), to_string(before.fingerprint))};
    }
  }
  if (const auto enough =
          store::check_space(directory.path(), store::bytes_of_files(directory.path() / "db"));
      !enough) {
    return tl::unexpected{enough.error()};
  }
  const auto staging = store::make_staging(directory.path());
  if (!staging) return tl::unexpected{staging.error()};
  Rebuilt rebuilt;
  rebuilt.store_id = store::random_store_id();
  auto made = store::StoreBuilder::create(*staging, {rebuilt.store_id, world.fingerprint()},
                                          before.head.position, before.link);
  if (!made) return tl::unexpected{made.error()};
  store::StoreBuilder& builder = **made;
  const std::uint64_t revision = before.head.revision + 1;
  BaseChunkMaker maker{world};
  const auto base = std::make_unique<DenseVoxels>();
  ProgressBar progress{"rebase", "chunks"};
  progress.expect(store->estimated_keys());
  store::StoreBuilder::Done done;
  const auto read = store->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
    progress.advance(1);
    if (stored.voxels.empty()) return true;
    // On the same land an override that keeps its material is unlike the base as before.
    const bool compared = !same_land || std::ranges::any_of(stored.voxels, [&](const Override& voxel) {
      return renaming.changes(voxel.material);
    });
    if (compared) maker.make(chunk, *base);
    std::vector<Override> kept;
    for (const Override& voxel : stored.voxels) {
      const auto material = renaming(voxel.material);
      if (!material) {
        ++rebuilt.unknown;
      } else if (compared && (*base)[voxel.index] == *material) {
        ++rebuilt.as_base;
      } else {
        kept.push_back({voxel.index, *material});
      }
    }
    done = builder.add(chunk, revision, kept);
    return done.has_value();
  });
  if (!read) return tl::unexpected{read.error()};
  for (const auto& [name, id] : materials) {
    if (done) done = builder.add(name, id);
  }
  if (done) done = builder.finish(revision, before.head.time_ms);
  if (!done) return tl::unexpected{done.error()};
  store.reset();
  auto replaced = store::swap_in(directory.path());
  if (!replaced) return tl::unexpected{replaced.error()};
  rebuilt.chunks = builder.chunks();
  rebuilt.voxels = builder.voxels();
  rebuilt.replaced = *std::move(replaced);
  return rebuilt;
}

}  // namespace talus::server
