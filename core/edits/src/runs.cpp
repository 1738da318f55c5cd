#include <talus/edits/runs.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

namespace talus::edits {
namespace {

/// A run of voxels of one material; `place` is the material's index in the list.
struct VoxelRun {
  std::uint32_t first = 0;
  std::uint32_t length = 0;
  std::uint32_t place = 0;
};

void put_varint(std::uint32_t value, std::vector<std::byte>& out) {
  for (; value >= 128; value >>= 7) out.push_back(static_cast<std::byte>(128 | (value & 127)));
  out.push_back(static_cast<std::byte>(value));
}

/// Takes numbers from the front of bytes. After the first error, all numbers are 0.
class NumberReader {
 public:
  explicit NumberReader(std::span<const std::byte> bytes) : bytes_{bytes} {}

  std::uint32_t take(std::uint32_t max_value) {
    std::uint64_t value = 0;
    for (int shift = 0; !fault_; shift += 7) {
      if (bytes_.empty()) {
        fault_ = RunsError::truncated;
        break;
      }
      const auto byte = std::to_integer<std::uint64_t>(bytes_.front());
      bytes_ = bytes_.subspan(1);
      value |= (byte & 127) << shift;
      const bool padded = byte == 0 && shift > 0;
      // Five bytes hold 35 bits, more than any number here needs.
      if (padded || value > max_value || (byte >= 128 && shift == 28)) fault_ = RunsError::bad_number;
      if (byte < 128) break;
    }
    return fault_ ? 0 : static_cast<std::uint32_t>(value);
  }

  /// A count of elements of at least `bytes_each` bytes each.
  std::uint32_t take_count(std::size_t bytes_each) {
    const std::uint32_t count = take(kChunkVolume);
    if (!fault_ && count > bytes_.size() / bytes_each) fault_ = RunsError::truncated;
    return fault_ ? 0 : count;
  }

  [[nodiscard]] std::optional<RunsError> fault() const { return fault_; }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  std::span<const std::byte> bytes_;
  std::optional<RunsError> fault_;
};

std::vector<MaterialId> materials_of(std::span<const Override> voxels) {
  std::vector<MaterialId> materials;
  for (const Override& voxel : voxels) {
    // Neighbours are mostly equal.
    if (materials.empty() || materials.back() != voxel.material) materials.push_back(voxel.material);
  }
  std::ranges::sort(materials);
  materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
  return materials;
}

std::vector<VoxelRun> runs_of(std::span<const Override> voxels, std::span<const MaterialId> materials) {
  std::vector<VoxelRun> runs;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Override voxel = voxels[i];
    if (i > 0 && voxels[i - 1].material == voxel.material && voxels[i - 1].index + 1 == voxel.index) {
      ++runs.back().length;
      continue;
    }
    const auto place = std::ranges::lower_bound(materials, voxel.material) - materials.begin();
    runs.push_back({voxel.index, 1, static_cast<std::uint32_t>(place)});
  }
  return runs;
}

std::vector<Override> spread(std::span<const VoxelRun> runs, std::span<const MaterialId> materials,
                             std::size_t count) {
  std::vector<Override> voxels;
  voxels.reserve(count);
  for (const VoxelRun& run : runs) {
    for (std::uint32_t i = 0; i < run.length; ++i) {
      voxels.push_back({static_cast<std::uint16_t>(run.first + i), materials[run.place]});
    }
  }
  return voxels;
}

}  // namespace

std::string_view describe(RunsError error) {
  switch (error) {
    case RunsError::truncated:
      return "runs: the bytes end too early; they must hold every material and run that they count";
    case RunsError::too_long:
      return "runs: bytes follow the last run; a block must end with it";
    case RunsError::bad_number:
      return "runs: a number is not canonical or too large; it must be in range, in the fewest bytes";
    case RunsError::bad_materials:
      return "runs: the materials are not canonical; ids must rise, and each must be the id of a run";
    case RunsError::split_run:
      return "runs: two runs of one material touch, which is not canonical; they must be one run";
    case RunsError::past_chunk:
      return "runs: a run ends past the chunk; a chunk has voxels 0 to 32767";
    case RunsError::too_many:
      return "runs: there are more voxels than the limit; a block must keep to its reader's limit";
  }
  return "runs: unknown error; it must be one of RunsError";
}

void encode_runs(std::span<const Override> voxels, std::vector<std::byte>& out) {
  assert(std::ranges::adjacent_find(voxels, [](Override a, Override b) { return a.index >= b.index; }) ==
         voxels.end());
  assert(voxels.empty() || voxels.back().index < kChunkVolume);
  if (voxels.size() == 1) {  // the case of most edits
    std::array<std::byte, 16> block;
    auto end = block.begin();
    for (std::uint32_t number :
         {1U, std::uint32_t{to_integer(voxels[0].material)}, 1U, std::uint32_t{voxels[0].index}, 0U}) {
      for (; number >= 128; number >>= 7) *end++ = static_cast<std::byte>(128 | (number & 127));
      *end++ = static_cast<std::byte>(number);
    }
    out.insert(out.end(), block.begin(), end);
    return;
  }
  const std::vector<MaterialId> materials = materials_of(voxels);
  const std::vector<VoxelRun> runs = runs_of(voxels, materials);
  const auto material_count = static_cast<std::uint32_t>(materials.size());
  put_varint(material_count, out);
  for (const MaterialId id : materials) put_varint(to_integer(id), out);
  put_varint(static_cast<std::uint32_t>(runs.size()), out);
  std::uint32_t end = 0;
  for (const VoxelRun& run : runs) {
    put_varint(run.first - end, out);
    put_varint((run.length - 1) * material_count + run.place, out);
    end = run.first + run.length;
  }
}

tl::expected<std::vector<Override>, RunsError> decode_runs(std::span<const std::byte> bytes,
                                                           std::size_t max_voxels) {
  NumberReader reader{bytes};
  std::vector<MaterialId> materials(reader.take_count(1));
  for (MaterialId& id : materials) id = MaterialId{static_cast<std::uint16_t>(reader.take(UINT16_MAX))};
  std::vector<VoxelRun> runs(reader.take_count(2));
  if (reader.fault()) return tl::unexpected{*reader.fault()};
  const bool rise = std::ranges::adjacent_find(materials, std::greater_equal{}) == materials.end();
  if (!rise || runs.size() < materials.size() || (materials.empty() && !runs.empty())) {
    return tl::unexpected{RunsError::bad_materials};
  }

  const auto material_count = static_cast<std::uint32_t>(materials.size());
  std::vector<bool> used(material_count);
  std::size_t voxels = 0;
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::uint32_t gap = reader.take(kChunkVolume - 1);
    const std::uint32_t coded = reader.take(kChunkVolume * material_count - 1);
    if (reader.fault()) return tl::unexpected{*reader.fault()};
    const VoxelRun run{end + gap, coded / material_count + 1, coded % material_count};
    if (run.first + run.length > kChunkVolume) return tl::unexpected{RunsError::past_chunk};
    if (i > 0 && gap == 0 && runs[i - 1].place == run.place) return tl::unexpected{RunsError::split_run};
    used[run.place] = true;
    voxels += run.length;
    if (voxels > max_voxels) return tl::unexpected{RunsError::too_many};
    end = run.first + run.length;
    runs[i] = run;
  }
  if (!reader.at_end()) return tl::unexpected{RunsError::too_long};
  if (std::ranges::find(used, false) != used.end()) return tl::unexpected{RunsError::bad_materials};
  return spread(runs, materials, voxels);
}

}  // namespace talus::edits
