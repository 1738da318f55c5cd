// The world as a WebAssembly module: core/local behind numbers and addresses. One world and one thread an
// instance; its host makes an instance for each.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/local/edits.h>
#include <talus/local/local.h>
#include <talus/map/tile_painting.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/world.h>
#include <talus/vectors/instruction_set.h>
#include <talus/voxel/codec.h>
#include <talus/voxel/content_hash.h>
#include <xxhash.h>

#include "abi.h"
#include "about.h"
#include "edit_numbers.h"

namespace talus::wasm {
namespace {

/// All that an instance holds.
struct Instance {
  std::map<std::string, std::vector<std::byte>> files;
  std::shared_ptr<const local::World> world;
  std::optional<local::Workspace> workspace;
  local::Edits edits;
  local::SpecProblem problem;
  Problem problem_answer;
  // The last answer.
  std::string text;
  std::vector<std::byte> payload;
  std::vector<std::int32_t> numbers;
  std::vector<std::uint8_t> picture;
  DenseVoxels voxels;
  Bytes bytes;
  ChunkAnswer chunk;
};

Instance& instance() {
  static Instance& only = *new Instance;  // not in the module's data, which would have its zeros
  return only;
}

std::nullptr_t refused(std::string text) {
  instance().problem = {};
  instance().problem.text = std::move(text);
  return nullptr;
}

/// A chunk of the world; refused() if it is none, or no world is open.
std::optional<ChunkKey> key_of(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z) {
  if (!instance().world) return refused("no world is open"), std::nullopt;
  const auto lod = Lod::checked(level);
  if (!lod) return refused(lod.error().message), std::nullopt;
  const auto key = checked_chunk(x, y, z, *lod);
  if (!key) return refused(key.error().message), std::nullopt;
  return *key;
}

const ChunkAnswer* answer(const Chunk& chunk, std::uint32_t what) {
  Instance& all = instance();
  all.chunk = {};
  all.chunk.uniform = chunk.is_uniform() ? 1 : 0;
  if (chunk.is_uniform()) {
    all.chunk.material = to_integer(chunk.at({}));
  } else if (what & kVoxels) {
    chunk.copy_to(all.voxels);
    all.chunk.voxels = bytes_of(std::span<const MaterialId>{all.voxels});
  }
  if (what & kPayload) {
    all.payload.clear();
    encode(chunk, all.payload);
    all.chunk.payload = bytes_of(std::span<const std::byte>{all.payload});
  }
  if (what & kHash) {
    const ContentHash hash = content_hash(chunk);
    all.chunk.hash_low = hash.low;
    all.chunk.hash_high = hash.high;
  }
  return &all.chunk;
}

const Bytes* answer(Bytes bytes) {
  instance().bytes = bytes;
  return &instance().bytes;
}

/// The numbers so far, then level, x, y and z of each chunk.
const Bytes* answer_with(std::span<const ChunkKey> chunks) {
  std::vector<std::int32_t>& numbers = instance().numbers;
  for (const ChunkKey& key : chunks) {
    numbers.insert(numbers.end(), {key.lod.value(), key.coord.x, key.coord.y, key.coord.z});
  }
  return answer(bytes_of(std::span<const std::int32_t>{numbers}));
}

}  // namespace

/// Memory of the host's; talus_release() gives it back.
TALUS_EXPORT(talus_allocate) void* talus_allocate(std::uint32_t bytes) {
  return ::operator new(bytes);
}
TALUS_EXPORT(talus_release) void talus_release(void* memory) {
  ::operator delete(memory);
}

TALUS_EXPORT(talus_problem) const Problem* talus_problem() {
  Instance& all = instance();
  all.problem_answer = {static_cast<std::uint32_t>(all.problem.line),
                        static_cast<std::uint32_t>(all.problem.column), bytes_of(all.problem.key),
                        bytes_of(all.problem.text)};
  return &all.problem_answer;
}

TALUS_EXPORT(talus_instruction_set) const Bytes* talus_instruction_set() {
  return answer(bytes_of(to_string(instruction_set())));
}

/// A file that the world may name.
TALUS_EXPORT(talus_add_file)
void talus_add_file(const char* name, std::uint32_t name_size, const std::byte* bytes, std::uint32_t size) {
  instance().files[{name, name_size}].assign(bytes, bytes + size);
}

/// Text about the world, as JSON; null: talus_problem().
TALUS_EXPORT(talus_world_open)
const Bytes* talus_world_open(const std::byte* toml, std::uint32_t size, std::uint32_t ground_bytes) {
  Instance& all = instance();
  all.workspace.reset();
  all.world.reset();
  const auto file = [&](const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
    const auto found = all.files.find(name);
    if (found == all.files.end()) return tl::unexpected<std::string>{"was not given"};
    return found->second;
  };
  auto world = local::open_world({toml, size}, file);
  all.files.clear();
  if (!world) return all.problem = std::move(world).error(), nullptr;
  all.world = *std::move(world);
  all.workspace.emplace(all.world, ground_bytes);
  all.edits = {};
  all.text = about(*all.world);
  return answer(bytes_of(all.text));
}

/// Makes the columns of tiles; those of one chunk are made when it is asked for. Null: talus_problem().
TALUS_EXPORT(talus_prepare)
const Bytes* talus_prepare(std::int32_t level, std::int32_t x, std::int32_t z, std::int32_t width,
                           std::int32_t depth) {
  constexpr std::int32_t kMaxTiles = 64;
  const auto first = key_of(level, x, 0, z);
  if (!first) return nullptr;
  if (width < 1 || width > kMaxTiles || depth < 1 || depth > kMaxTiles)
    return refused("1 to 64 tiles along each edge");
  const auto last = checked_chunk(std::int64_t{x} + width - 1, 0, std::int64_t{z} + depth - 1, first->lod);
  if (!last) return refused(last.error().message);
  instance().workspace->prepare({x, z, width, depth, first->lod});
  return answer({});
}

/// Chunk rows `first` to `last` at a tile may be mixed; under them all is `below`, above them air. Three
/// numbers.
TALUS_EXPORT(talus_rows) const Bytes* talus_rows(std::int32_t level, std::int32_t x, std::int32_t z) {
  const auto key = key_of(level, x, 0, z);
  if (!key) return nullptr;
  const terrain::MixedRange rows = instance().workspace->rows(*key);
  instance().numbers = {rows.first, rows.last, to_integer(rows.below)};
  return answer(bytes_of(std::span<const std::int32_t>{instance().numbers}));
}

/// What `what` asks for of a chunk. Null: talus_problem().
TALUS_EXPORT(talus_generate)
const ChunkAnswer* talus_generate(std::int32_t level, std::int32_t x, std::int32_t y, std::int32_t z,
                                  std::uint32_t what) {
  struct Sink final : local::ChunkSink {
    explicit Sink(std::uint32_t asked) : what{asked} {}
    void take(ChunkKey key, const Chunk& chunk) override {
      answer(instance().edits.merged_over(key, chunk), what);
    }
    std::uint32_t what;
  };
  const auto key = key_of(level, x, y, z);
  if (!key) return nullptr;
  Sink sink{what};
  local::generate(*instance().workspace, {&*key, 1}, sink);
  return &instance().chunk;
}

/// Applies the edit of edit_of(). Two numbers and more: the first guard that does not hold, or -1; how many
/// voxels changed; then level, x, y and z of each chunk that changed. Null: talus_problem().
TALUS_EXPORT(talus_edit) const Bytes* talus_edit(const double* numbers, std::uint32_t count) {
  Instance& all = instance();
  if (!all.world) return refused("no world is open");
  const auto edit = edit_of({numbers, count});
  if (!edit) return refused("not an edit; whole coordinates and materials from 0 to 65535 are needed");
  const auto outcome = all.edits.apply(*all.workspace, *edit);
  if (!outcome) return refused(outcome.error().message);
  all.numbers = {outcome->conflict ? static_cast<std::int32_t>(*outcome->conflict) : -1,
                 static_cast<std::int32_t>(outcome->changed)};
  return answer_with(outcome->chunks);
}

/// The edits of a chunk of level 0 as runs (core/edits/FORMAT.md). Null: talus_problem().
TALUS_EXPORT(talus_overrides)
const Bytes* talus_overrides(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto key = key_of(0, x, y, z);
  if (!key) return nullptr;
  instance().payload = instance().edits.overrides(key->coord);
  return answer(bytes_of(std::span<const std::byte>{instance().payload}));
}

/// Replaces a chunk's edits by runs: level, x, y and z of each chunk that changed. Null: talus_problem().
TALUS_EXPORT(talus_restore)
const Bytes* talus_restore(std::int32_t x, std::int32_t y, std::int32_t z, const std::byte* runs,
                           std::uint32_t size) {
  Instance& all = instance();
  const auto key = key_of(0, x, y, z);
  if (!key) return nullptr;
  const auto changed = all.edits.restore(*all.world, key->coord, {runs, size});
  if (!changed) return refused(changed.error().message);
  all.numbers.clear();
  return answer_with(*changed);
}

/// The voxel for a player's feet: x, y, z. Null: talus_problem().
TALUS_EXPORT(talus_spawn) const Bytes* talus_spawn() {
  static std::array<double, 3> numbers;
  if (!instance().world) return refused("no world is open");
  const VoxelPos feet = terrain::find_spawn(*instance().world);
  numbers = {static_cast<double>(feet.x), static_cast<double>(feet.y), static_cast<double>(feet.z)};
  return answer(bytes_of(std::span<const double>{numbers}));
}

/// The same of a payload that a server sent.
TALUS_EXPORT(talus_decode)
const ChunkAnswer* talus_decode(const std::byte* payload, std::uint32_t size, std::uint32_t what) {
  const auto chunk = decode({payload, size});
  return chunk ? answer(*chunk, what) : refused(std::string{describe(chunk.error())});
}

/// The ground of columns of a level, in subvoxels: local::heights(). Null: talus_problem().
TALUS_EXPORT(talus_heights)
const Bytes* talus_heights(std::int32_t level, double x, double z, std::int32_t width, std::int32_t depth) {
  constexpr std::int32_t kMaxSide = 2048;
  if (!instance().world) return refused("no world is open");
  const auto lod = Lod::checked(level);
  if (!lod) return refused(lod.error().message);
  if (width < 1 || width > kMaxSide || depth < 1 || depth > kMaxSide)
    return refused("1 to 2048 columns along each edge");
  const auto end = static_cast<double>(chunk_limit(*lod) * kChunkSize);
  const auto fits = [end](double from, std::int32_t length) {
    return from == std::floor(from) && from >= -end && from + length <= end;
  };
  if (!fits(x, width) || !fits(z, depth))
    return refused("the columns are not whole, or lie outside the world");
  instance().numbers = local::heights(
      *instance().world, {static_cast<std::int64_t>(x), static_cast<std::int64_t>(z), width, depth, *lod});
  return answer(bytes_of(std::span<const std::int32_t>{instance().numbers}));
}

/// A tile of the map: 256 x 256 pixels of red, green and blue. Null: talus_problem().
TALUS_EXPORT(talus_map) const Bytes* talus_map(std::int32_t zoom, double x, double z) {
  if (!instance().world) return refused("no world is open");
  const auto whole = [](double number) {
    return std::abs(number) < 1e15 ? static_cast<std::int64_t>(number) : INT64_MAX;
  };
  const auto tile = map::checked_tile(zoom, whole(x), whole(z));
  if (!tile) return refused(tile.error());
  map::TilePainting painting{*instance().world, *tile};
  while (painting.step()) {
  }
  instance().picture = painting.take().rgb;
  return answer(bytes_of(std::span<const std::uint8_t>{instance().picture}));
}

/// XXH3-128, as all hashes here: low half, high half.
TALUS_EXPORT(talus_hash) const Bytes* talus_hash(const void* bytes, std::uint32_t size) {
  static std::array<std::uint64_t, 2> halves;
  const XXH128_hash_t hash = XXH3_128bits(bytes, size);
  halves = {hash.low64, hash.high64};
  return answer(bytes_of(std::span<const std::uint64_t>{halves}));
}

}  // namespace talus::wasm
