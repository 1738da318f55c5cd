// Functions of talus_local.h: checks arguments, and converts failures to a status and a message.
#include <talus_local.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/world_files/world_files.h>

#include "edit_argument.h"
#include "error_line.h"
#include "local/land.h"
#include "local/local_structs.h"

using namespace talus;
using namespace talus::c_api;

struct talus_local_world {
  std::shared_ptr<Land> land;
};

// Of an edit, at all levels: 64 chunks, those into which loose material slides, and one of each level for
// each.
constexpr std::size_t kMaxChangedChunks = 1'024;

struct talus_workspace {
  std::shared_ptr<Land> land;
  std::size_t ground_bytes = 0;
  std::optional<local::Workspace> workspace;  // none after an exception
  std::atomic<bool> cancel = false;
  std::vector<talus_chunk_key> changed;  // by the last edit; allocated before it
};

namespace {

thread_local ErrorLine error_of_thread;

talus_status fail(const char* function, talus_status status, std::string_view what) noexcept {
  error_of_thread.set(function, what);
  return status;
}

// Runs `work`, which gets how to fail. An exception becomes a status.
template <typename Work>
talus_status guarded(const char* function, Work&& work) noexcept {
  const auto failed = [function](talus_status status, std::string_view what) {
    return fail(function, status, what);
  };
  try {
    return work(failed);
  } catch (const std::bad_alloc&) {
    return failed(TALUS_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(TALUS_INTERNAL, error.what());
  } catch (...) {
    return failed(TALUS_INTERNAL, "a fault of the library");
  }
}

std::string wrong_struct(const char* name) {
  return std::string{name} + " is NULL or has a wrong size; set its size to sizeof the struct";
}

std::string newer_struct(const char* name) {
  return std::string{name} + " asks for what only a newer library can do, this one is " +
         std::to_string(TALUS_LOCAL_API_MAJOR) + "." + std::to_string(TALUS_LOCAL_API_MINOR);
}

talus_status status_of(saves::SaveError::Kind kind) {
  using Kind = saves::SaveError::Kind;
  switch (kind) {
    case Kind::in_use:
      return TALUS_FILE_IN_USE;
    case Kind::foreign:
    case Kind::damaged:
      return TALUS_BAD_SAVE;
    case Kind::other:
      return TALUS_OTHER_SAVE;
    default:
      return TALUS_FILE_FAILED;
  }
}

// The reader of files that talus_world_options asks for.
local::FileReader reader_of(const talus_world_options& options) {
  if (options.read_file != nullptr) {
    return [&options](const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
      const void* bytes = nullptr;
      std::size_t count = 0;
      if (options.read_file(options.user, name.c_str(), &bytes, &count) != 0 ||
          (bytes == nullptr && count > 0)) {
        return tl::unexpected<std::string>{"was not given"};
      }
      const auto* const first = static_cast<const std::byte*>(bytes);
      return std::vector<std::byte>{first, first + count};
    };
  }
  if (options.folder == nullptr || options.folder[0] == '\0') return {};
  return world_files::bytes_beside(std::filesystem::path{options.folder} / "world.toml");
}

// Keys of the world; the error says which is none.
tl::expected<std::vector<ChunkKey>, std::string> keys_of(const talus_chunk_key* keys, std::size_t count) {
  if (keys == nullptr && count > 0) return tl::unexpected<std::string>{"keys is NULL but count is not 0"};
  std::vector<ChunkKey> own;
  own.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto lod = Lod::checked(keys[i].level > Lod::kMax ? -1 : static_cast<int>(keys[i].level));
    if (!lod) return tl::unexpected{"keys[" + std::to_string(i) + "].level is not 0 to 6"};
    const auto key = checked_chunk(keys[i].x, keys[i].y, keys[i].z, *lod);
    if (!key) return tl::unexpected{"keys[" + std::to_string(i) + "]: " + key.error().message};
    own.push_back(*key);
  }
  return own;
}

talus_chunk_key key_of(ChunkKey key) {
  return {key.coord.x, key.coord.y, key.coord.z, static_cast<std::uint32_t>(key.lod.value())};
}

// Gives chunks, with edits unless told otherwise, to `take(index, uniform, chunk)`.
template <typename Take>
class Generation final : public local::ChunkSink {
 public:
  Generation(const Land* land, std::span<const ChunkKey> keys, Take take)
      : land_{land}, take_{std::move(take)} {
    for (std::size_t i = 0; i < keys.size(); ++i) places_[keys[i]].push_back(i);
  }
  void take(ChunkKey key, const Chunk& generated) override {
    std::deque<std::size_t>& places = places_.at(key);
    const std::size_t index = places.front();  // a key may be there twice
    places.pop_front();
    const auto give = [&](const Chunk& chunk) {
      take_(index, chunk.is_uniform() ? std::int32_t{to_integer(chunk.at({}))} : -1, chunk);
    };
    if (land_ == nullptr) {
      give(generated);
    } else {
      give(land_->merged_over(key, generated));
    }
  }

 private:
  const Land* land_;
  Take take_;
  std::unordered_map<ChunkKey, std::deque<std::size_t>> places_;
};

// Both functions that generate, by what they do before the first chunk and with each.
template <typename Prepare, typename Take>
talus_status generate(const char* function, talus_workspace* workspace, const talus_chunk_key* keys,
                      std::size_t count, std::uint32_t flags, Prepare prepare, Take take) noexcept {
  return guarded(function, [&](const auto& failed) {
    if (workspace == nullptr) return failed(TALUS_INVALID_ARGUMENT, "workspace is NULL");
    if ((flags & ~std::uint32_t{TALUS_WITHOUT_EDITS}) != 0) {
      return failed(TALUS_INVALID_ARGUMENT, "flags may hold TALUS_WITHOUT_EDITS");
    }
    const auto own = keys_of(keys, count);
    if (!own) return failed(TALUS_INVALID_ARGUMENT, own.error());
    prepare();
    // Put back at the end, so that an exception leaves none.
    std::optional<local::Workspace> memory = std::exchange(workspace->workspace, std::nullopt);
    if (!memory) memory.emplace(workspace->land->world(), workspace->ground_bytes);
    Generation<Take> sink{(flags & TALUS_WITHOUT_EDITS) != 0 ? nullptr : workspace->land.get(), *own,
                          std::move(take)};
    const std::size_t made = local::generate(*memory, *own, sink, &workspace->cancel);
    workspace->workspace = std::move(memory);
    if (made == count) return talus_status{TALUS_OK};
    workspace->cancel = false;
    return failed(TALUS_CANCELLED,
                  "cancelled after " + std::to_string(made) + " of " + std::to_string(count) + " chunks");
  });
}

void copy_voxels(const Chunk& chunk, std::uint16_t* into) {
  // An enumeration is laid out as its underlying type, and the caller's compiler does not see this store.
  static_assert(sizeof(MaterialId) == sizeof(std::uint16_t));
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{reinterpret_cast<MaterialId*>(into), kChunkVolume});
}

talus_status failed_save(const char* function, const saves::SaveError& error) {
  return fail(function, status_of(error.kind), error.message);
}

}  // namespace

uint32_t talus_local_api_version(void) {
  return (std::uint32_t{TALUS_LOCAL_API_MAJOR} << 16) | TALUS_LOCAL_API_MINOR;
}

const char* talus_local_version(void) {
  return TALUS_VERSION;
}

const char* talus_local_error(void) {
  return error_of_thread.text();
}

talus_status talus_world_open(const talus_world_options* options, talus_local_world** world) {
  return guarded("talus_world_open", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL; give where to put it");
    if (!has_size(options)) return failed(TALUS_INVALID_ARGUMENT, wrong_struct("options"));
    const auto own = read_struct(options);
    if (!own) return failed(TALUS_INVALID_ARGUMENT, newer_struct("options"));
    if ((own->flags & ~std::uint32_t{TALUS_SETTLES}) != 0) {
      return failed(TALUS_INVALID_ARGUMENT, "options.flags may hold TALUS_SETTLES");
    }
    std::string_view toml = terrain::default_world_toml();
    if (own->toml != nullptr) toml = {own->toml, static_cast<std::size_t>(own->toml_bytes)};
    auto source = saves::read_world(std::as_bytes(std::span{toml}), reader_of(*own));
    if (!source) return failed(TALUS_BAD_WORLD, source.error().message);
    auto land = std::make_shared<Land>(*std::move(source), (own->flags & TALUS_SETTLES) != 0);
    *world = new talus_local_world{std::move(land)};
    return talus_status{TALUS_OK};
  });
}

void talus_world_close(talus_local_world* world) {
  delete world;
}

talus_status talus_world_get_info(talus_local_world* world, talus_world_info* info) {
  return guarded("talus_world_get_info", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    if (!has_size(info)) return failed(TALUS_INVALID_ARGUMENT, wrong_struct("info"));
    const Land& land = *world->land;
    const Land::State state = land.state();
    const HeightRange rows = terrain::height_range(*land.world());
    const VoxelPos spawn = land.spawn();
    talus_world_info own{};
    own.flags = (state.settles ? std::uint32_t{TALUS_SETTLES} : 0U) |
                (state.has_save ? std::uint32_t{TALUS_HAS_SAVE} : 0U) |
                (state.unsaved ? std::uint32_t{TALUS_UNSAVED} : 0U);
    own.fingerprint_low = land.world()->fingerprint().low;
    own.fingerprint_high = land.world()->fingerprint().high;
    own.min_y = rows.low;
    own.max_y = rows.high;
    own.spawn_x = spawn.x;
    own.spawn_y = spawn.y;
    own.spawn_z = spawn.z;
    own.revision = state.revision;
    own.hash_low = state.hash.low;
    own.hash_high = state.hash.high;
    own.material_count = static_cast<std::uint32_t>(land.materials().size());
    own.generator_version =
        static_cast<std::uint32_t>(terrain::to_integer(land.world()->generator_version()));
    write_struct(info, own);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_world_get_material(talus_local_world* world, uint32_t index, talus_material* material) {
  return guarded("talus_world_get_material", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    if (!has_size(material)) return failed(TALUS_INVALID_ARGUMENT, wrong_struct("material"));
    const std::vector<LandMaterial>& all = world->land->materials();
    if (index >= all.size()) {
      return failed(TALUS_INVALID_ARGUMENT,
                    "index is " + std::to_string(index) + "; there are " + std::to_string(all.size()));
    }
    talus_material own{};
    own.id = to_integer(all[index].id);
    own.colour = all[index].colour;
    own.phase = all[index].phase;
    own.name = all[index].name.c_str();
    write_struct(material, own);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_workspace_create(talus_local_world* world, uint64_t memory_bytes,
                                    talus_workspace** workspace) {
  return guarded("talus_workspace_create", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    if (workspace == nullptr)
      return failed(TALUS_INVALID_ARGUMENT, "workspace is NULL; give where to put it");
    constexpr std::uint64_t kDefaultBytes = std::uint64_t{64} << 20;
    auto made = std::make_unique<talus_workspace>();
    made->land = world->land;
    made->ground_bytes = static_cast<std::size_t>(memory_bytes == 0 ? kDefaultBytes : memory_bytes);
    made->workspace.emplace(made->land->world(), made->ground_bytes);
    made->changed.reserve(kMaxChangedChunks);
    *workspace = made.release();
    return talus_status{TALUS_OK};
  });
}

void talus_workspace_destroy(talus_workspace* workspace) {
  delete workspace;
}

talus_status talus_generate(talus_workspace* workspace, const talus_chunk_key* keys, size_t count,
                            uint32_t flags, uint16_t* voxels, int32_t* uniform_materials) {
  constexpr std::int32_t kNotMade = -2;
  return generate(
      "talus_generate", workspace, keys, count, flags,
      [=] {
        if (uniform_materials != nullptr) std::fill_n(uniform_materials, count, kNotMade);
      },
      [voxels, uniform_materials](std::size_t index, std::int32_t uniform, const Chunk& chunk) {
        if (uniform_materials != nullptr) uniform_materials[index] = uniform;
        if (voxels != nullptr) copy_voxels(chunk, voxels + index * TALUS_CHUNK_VOLUME);
      });
}

talus_status talus_generate_each(talus_workspace* workspace, const talus_chunk_key* keys, size_t count,
                                 uint32_t flags, talus_take_chunk take, void* user) {
  if (take == nullptr) return fail("talus_generate_each", TALUS_INVALID_ARGUMENT, "take is NULL");
  std::vector<std::uint16_t> voxels;
  return generate(
      "talus_generate_each", workspace, keys, count, flags, [&] { voxels.resize(TALUS_CHUNK_VOLUME); },
      [&](std::size_t index, std::int32_t uniform, const Chunk& chunk) {
        copy_voxels(chunk, voxels.data());
        take(user, index, uniform, voxels.data());
      });
}

void talus_cancel_generate(talus_workspace* workspace) {
  if (workspace != nullptr) workspace->cancel = true;
}

talus_status talus_heights(talus_local_world* world, int64_t x, int64_t z, uint32_t width, uint32_t depth,
                           uint32_t level, int32_t* heights_fx, size_t count) {
  return guarded("talus_heights", [&](const auto& failed) {
    constexpr std::uint64_t kMaxColumns = std::uint64_t{1} << 22;
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    if (heights_fx == nullptr) return failed(TALUS_INVALID_ARGUMENT, "heights_fx is NULL");
    const std::uint64_t columns = std::uint64_t{width} * depth;
    if (columns == 0 || columns > kMaxColumns || columns != count) {
      return failed(TALUS_INVALID_ARGUMENT, "width * depth is " + std::to_string(columns) + " and count " +
                                                std::to_string(count) +
                                                "; both must be one number, 1 to 2^22");
    }
    if (level > Lod::kMax) return failed(TALUS_INVALID_ARGUMENT, "level is not 0 to 6");
    const Lod lod = Lod::of(static_cast<int>(level));
    const std::int64_t end = chunk_limit(lod) * kChunkSize;
    const auto fits = [end](std::int64_t from, std::uint32_t length) {
      return from >= -end && from <= end && from + std::int64_t{length} <= end;
    };
    if (!fits(x, width) || !fits(z, depth))
      return failed(TALUS_OUT_OF_RANGE, "columns lie outside of the world");
    const auto ground =
        local::heights(*world->land->world(), {x, z, static_cast<int>(width), static_cast<int>(depth), lod});
    std::copy(ground.begin(), ground.end(), heights_fx);
    return talus_status{TALUS_OK};
  });
}

talus_status talus_apply_edit(talus_workspace* workspace, const talus_edit* edit, talus_edit_result* result) {
  return guarded("talus_apply_edit", [&](const auto& failed) {
    if (workspace == nullptr) return failed(TALUS_INVALID_ARGUMENT, "workspace is NULL");
    if (!has_size(edit)) return failed(TALUS_INVALID_ARGUMENT, wrong_struct("edit"));
    if (result != nullptr && !has_size(result)) return failed(TALUS_INVALID_ARGUMENT, wrong_struct("result"));
    const auto given = read_struct(edit);
    if (!given) return failed(TALUS_INVALID_ARGUMENT, newer_struct("edit"));
    const auto own = plain_edit_of(*given);
    if (!own) return failed(TALUS_INVALID_ARGUMENT, own.error());
    std::optional<local::Workspace> memory = std::exchange(workspace->workspace, std::nullopt);
    if (!memory) memory.emplace(workspace->land->world(), workspace->ground_bytes);
    const auto applied = workspace->land->apply(*memory, *own);
    workspace->workspace = std::move(memory);
    if (!applied) return failed(TALUS_OUT_OF_RANGE, applied.error().message);
    const auto& [outcome, revision] = *applied;
    workspace->changed.clear();
    for (const ChunkKey key : outcome.chunks) workspace->changed.push_back(key_of(key));
    if (result != nullptr) {
      talus_edit_result told{};
      told.conflict = outcome.conflict ? static_cast<std::int32_t>(*outcome.conflict) : -1;
      told.changed_voxels = static_cast<std::uint32_t>(outcome.changed);
      told.chunk_count = static_cast<std::uint32_t>(workspace->changed.size());
      told.chunks = workspace->changed.empty() ? nullptr : workspace->changed.data();
      told.revision = revision;
      write_struct(result, told);
    }
    if (!outcome.conflict) return talus_status{TALUS_OK};
    return failed(TALUS_CONFLICT,
                  "guard " + std::to_string(*outcome.conflict) + " does not hold; nothing was applied");
  });
}

talus_status talus_get_changed_chunks(talus_local_world* world, talus_chunk_key* chunks, size_t capacity,
                                      size_t* count) {
  return guarded("talus_get_changed_chunks", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    if (count == nullptr || (chunks == nullptr && capacity > 0)) {
      return failed(TALUS_INVALID_ARGUMENT, "count or chunks is NULL");
    }
    const std::vector<ChunkCoord> changed = world->land->changed_chunks();
    for (std::size_t i = 0; i < std::min(changed.size(), capacity); ++i)
      chunks[i] = key_of({changed[i], Lod{}});
    *count = changed.size();
    return talus_status{TALUS_OK};
  });
}

talus_status talus_save_create(talus_local_world* world, const char* file) {
  return guarded("talus_save_create", [&](const auto& failed) {
    if (world == nullptr || file == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world or file is NULL");
    const auto done = world->land->create_save(file);
    if (!done) return failed(TALUS_INVALID_ARGUMENT, "the world has a save; close it and open that");
    return *done ? talus_status{TALUS_OK} : failed_save("talus_save_create", done->error());
  });
}

talus_status talus_save_open(const char* file, uint32_t flags, talus_local_world** world) {
  return guarded("talus_save_open", [&](const auto& failed) {
    if (world == nullptr || file == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world or file is NULL");
    if ((flags & ~std::uint32_t{TALUS_READ_ONLY}) != 0) {
      return failed(TALUS_INVALID_ARGUMENT, "flags may hold TALUS_READ_ONLY");
    }
    const auto access = (flags & TALUS_READ_ONLY) != 0 ? saves::Access::read : saves::Access::write;
    auto save = saves::Save::open(file, access);
    if (!save) return failed_save("talus_save_open", save.error());
    auto land = std::make_shared<Land>(*std::move(save));
    *world = new talus_local_world{std::move(land)};
    return talus_status{TALUS_OK};
  });
}

talus_status talus_save_commit(talus_local_world* world) {
  return guarded("talus_save_commit", [&](const auto& failed) {
    if (world == nullptr) return failed(TALUS_INVALID_ARGUMENT, "world is NULL");
    const auto done = world->land->commit();
    if (!done) return failed(TALUS_INVALID_ARGUMENT, "the world has no save; create one first");
    return *done ? talus_status{TALUS_OK} : failed_save("talus_save_commit", done->error());
  });
}
