#include "export_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <talus/terrain/extraction.h>
#include <talus/terrain/places.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

namespace talus::tools {
namespace {

// First and last chunk with a voxel of [first, first + count).
struct ChunkSpan {
  ChunkSpan(std::int64_t first_voxel, std::int64_t count)
      : first{floor_div(first_voxel, kChunkSize)}, last{floor_div(first_voxel + count - 1, kChunkSize)} {}
  [[nodiscard]] std::int64_t origin() const { return first * kChunkSize; }
  [[nodiscard]] int columns() const { return static_cast<int>(last - first + 1) * kChunkSize; }
  std::int64_t first;
  std::int64_t last;
};

// Voxels of a patch's columns in a row of chunks, from y0 up: [z][y][x].
template <typename Item>
class VoxelSlab {
 public:
  VoxelSlab(const terrain::Region& patch, std::int32_t y0, std::int64_t chunk_z)
      : patch_{patch},
        y0_{y0},
        first_z_{std::max(patch.z, chunk_z * kChunkSize)},
        last_z_{std::min(patch.z + patch.depth, (chunk_z + 1) * kChunkSize)} {}

  /// Relative to the patch's z.
  [[nodiscard]] int first_z() const { return static_cast<int>(first_z_ - patch_.z); }
  [[nodiscard]] int last_z() const { return static_cast<int>(last_z_ - patch_.z); }
  /// Number of rows from y0 up to the highest that is not all air.
  [[nodiscard]] std::int32_t rows() const { return rows_; }
  [[nodiscard]] std::span<const Item> row(std::int32_t y, int z) const {
    return std::span{items_}.subspan(index(patch_.x, y, z + patch_.z),
                                     static_cast<std::size_t>(patch_.width));
  }

  void reserve_rows(std::int64_t rows) {
    max_rows_ = static_cast<std::size_t>(std::max<std::int64_t>(rows, 0));
    items_.assign(max_rows_ * static_cast<std::size_t>((last_z_ - first_z_) * patch_.width), Item{});
  }

  void copy(const Chunk& chunk, ChunkCoord coord) {
    const VoxelPos origin = chunk_origin(coord);
    const std::int64_t to_x = std::min(origin.x + kChunkSize, patch_.x + patch_.width);
    for (std::int64_t z = first_z_; z < last_z_; ++z) {
      for (std::int64_t x = std::max(origin.x, patch_.x); x < to_x; ++x) {
        for (const Run& run : chunk.runs(static_cast<int>(x - origin.x), static_cast<int>(z - origin.z))) {
          if (run.material != kAir)
            fill(x, z, origin.y - y0_ + run.from, origin.y - y0_ + run.to, run.material);
        }
      }
    }
  }

 private:
  void fill(std::int64_t x, std::int64_t z, std::int64_t from, std::int64_t to, MaterialId material) {
    for (std::int64_t y = std::max<std::int64_t>(from, 0); y < to; ++y) {
      items_[index(x, static_cast<std::int32_t>(y), z)] = static_cast<Item>(to_integer(material));
    }
    rows_ = std::max(rows_, static_cast<std::int32_t>(to));
  }
  [[nodiscard]] std::size_t index(std::int64_t x, std::int32_t y, std::int64_t z) const {
    const auto row = static_cast<std::size_t>(z - first_z_) * max_rows_ + static_cast<std::size_t>(y);
    return row * static_cast<std::size_t>(patch_.width) + static_cast<std::size_t>(x - patch_.x);
  }

  const terrain::Region& patch_;
  std::int32_t y0_;
  std::int64_t first_z_;
  std::int64_t last_z_;
  std::size_t max_rows_ = 0;
  std::int32_t rows_ = 0;
  std::vector<Item> items_;
};

std::int32_t scaled(float value) {
  // Rounds to even, the default mode of programs.
  const double rounded = std::nearbyint(double{value} * kFieldScale);
  return static_cast<std::int32_t>(std::clamp<double>(rounded, std::numeric_limits<std::int32_t>::min(),
                                                      std::numeric_limits<std::int32_t>::max()));
}

}  // namespace

Expected<PatchSummary> PatchWriter::write(const terrain::Region& patch) const {
  const terrain::Terrain terrain = generate_terrain(*plan_.world, patch);
  PatchSummary summary;
  for (std::size_t i = 0; i < plan_.arrays.size(); ++i) {
    const PlannedArray& array = plan_.arrays[i];
    if (array.array != ExportArray::voxels) {
      if (auto done = write_array(files_[i], array.array, terrain); !done)
        return tl::unexpected{Failure{done.error()}};
      continue;
    }
    const auto rows = array.type == files::NpyType::uint8 ? write_voxels<std::uint8_t>(files_[i], patch)
                                                          : write_voxels<std::uint16_t>(files_[i], patch);
    if (!rows) return tl::unexpected{rows.error()};
    summary.rows = *rows;
  }
  const auto inside = [&](std::int64_t place, std::int64_t first, int count) {
    const std::int64_t column = (place >> patch.lod.value()) - first;
    return column >= 0 && column < count;
  };
  for (const terrain::PlacedObject& object : terrain.objects) {
    const bool seen_alone = patch.lod.value() > 2;
    if (inside(seen_alone ? object.seen_x : object.x, patch.x, patch.width) &&
        inside(seen_alone ? object.seen_z : object.z, patch.z, patch.depth)) {
      summary.objects.push_back(object);
    }
  }
  return summary;
}

PatchWriter::Status PatchWriter::write_array(const files::NpyFile& file, ExportArray array,
                                             const terrain::Terrain& terrain) const {
  const terrain::Region& patch = terrain.region;
  switch (array) {
    case ExportArray::surface:
      return write_field(file, 0, patch, terrain.surface);
    case ExportArray::slope:
      return write_field(file, 0, patch, terrain.slope);
    case ExportArray::apron:
      return write_apron(file, terrain);
    case ExportArray::place:
      return write_fields(file, patch, terrain.place);
    case ExportArray::eroded:
      return write_fields(file, patch, terrain.loose);
    case ExportArray::strata:
      return write_fields(file, patch, terrain.strata);
    case ExportArray::shown:
      return write_shown(file, terrain);
    case ExportArray::fields:
      return write_quantities(file, patch);
    case ExportArray::look:
      return write_field(file, 0, patch, terrain.looks.front());
    case ExportArray::voxels:
      break;
  }
  return {};
}

std::size_t PatchWriter::item(const terrain::Region& patch, std::size_t slice, int z) const {
  const auto region_z = static_cast<std::size_t>(patch.z - plan_.region.z + z);
  const auto region_x = static_cast<std::size_t>(patch.x - plan_.region.x);
  const auto width = static_cast<std::size_t>(plan_.region.width);
  return (slice * static_cast<std::size_t>(plan_.region.depth) + region_z) * width + region_x;
}

template <typename Field>
PatchWriter::Status PatchWriter::write_field(const files::NpyFile& file, std::size_t slice,
                                             const terrain::Region& patch, const Field& field) const {
  for (int z = 0; z < patch.depth; ++z) {
    if (auto done = file.write(item(patch, slice, z), field.row(z)); !done) return done;
  }
  return {};
}

PatchWriter::Status PatchWriter::write_fields(const files::NpyFile& file, const terrain::Region& patch,
                                              const std::vector<terrain::Field>& fields) const {
  for (std::size_t slice = 0; slice < fields.size(); ++slice) {
    if (auto done = write_field(file, slice, patch, fields[slice]); !done) return done;
  }
  return {};
}

PatchWriter::Status PatchWriter::write_apron(const files::NpyFile& file,
                                             const terrain::Terrain& terrain) const {
  terrain::Field apron = terrain.surface;
  for (std::size_t i = 0; i < apron.values.size(); ++i) apron.values[i] -= terrain.bare.values[i];
  return write_field(file, 0, terrain.region, apron);
}

PatchWriter::Status PatchWriter::write_shown(const files::NpyFile& file,
                                             const terrain::Terrain& terrain) const {
  terrain::BasicField<std::uint16_t> shown{terrain.region.width, terrain.region.depth};
  for (std::size_t plane = 0; plane < plan_.planes.size(); ++plane) {
    const MaterialId material = plan_.planes[plane];
    const terrain::World::ShownBy* const by = plan_.world->shown_by(material);
    if (by == nullptr) {
      std::fill(shown.values.begin(), shown.values.end(), to_integer(material));
    } else {
      const auto& looks = terrain.looks[by->looks].values;
      std::transform(looks.begin(), looks.end(), shown.values.begin(),
                     [&](std::uint8_t look) { return to_integer(by->by_look[look]); });
    }
    if (auto done = write_field(file, plane, terrain.region, shown); !done) return done;
  }
  return {};
}

PatchWriter::Status PatchWriter::write_quantities(const files::NpyFile& file,
                                                  const terrain::Region& patch) const {
  auto sampler = terrain::PlaceSampler::make(*plan_.world, plan_.fields).value();
  const std::int64_t step = std::int64_t{1} << patch.lod.value();
  std::vector<std::int64_t> xs;
  for (int x = 0; x < patch.width; ++x) xs.push_back((patch.x + x) * step);
  sampler.start(xs);
  std::vector<std::int32_t> row(xs.size());
  for (int z = 0; z < patch.depth; ++z) {
    sampler.row((patch.z + z) * step);
    for (std::size_t f = 0; f < plan_.fields.size(); ++f) {
      const std::span<const float> values = sampler.values(f);
      std::transform(values.begin(), values.end(), row.begin(), scaled);
      if (auto done = file.write(item(patch, f, z), std::span<const std::int32_t>{row}); !done) return done;
    }
  }
  return {};
}

Expected<Chunk> PatchWriter::chunk_at(const terrain::Stacks& stacks, ChunkKey key) const {
  Chunk chunk = extract_chunk(*plan_.world, stacks, key.coord);
  if (plan_.edits == nullptr || !plan_.edits->edited_rows(key).contains(key.coord.y)) return chunk;
  const auto overrides = plan_.edits->overrides(key);
  if (!overrides) return tl::unexpected{overrides.error()};
  return overrides->merged_over(chunk);
}

template <typename Item>
Expected<std::int32_t> PatchWriter::write_voxels(const files::NpyFile& file,
                                                 const terrain::Region& patch) const {
  const ChunkSpan xs{patch.x, patch.width};
  const ChunkSpan zs{patch.z, patch.depth};
  const terrain::Stacks stacks =
      generate_stacks(*plan_.world, {xs.origin(), zs.origin(), xs.columns(), zs.columns(), patch.lod});
  std::int32_t rows = 0;
  // One row of chunks at a time: memory stays small, and every row of voxels is one write.
  for (std::int64_t chunk_z = zs.first; chunk_z <= zs.last; ++chunk_z) {
    const auto z = static_cast<std::int32_t>(chunk_z);
    std::int32_t last_y = -1;
    for (std::int64_t x = xs.first; x <= xs.last; ++x) {
      last_y = std::max(last_y, mixed_range(*plan_.world, stacks, static_cast<std::int32_t>(x), z).last);
      if (plan_.edits == nullptr) continue;
      const ChunkRange edited = plan_.edits->edited_rows({{static_cast<std::int32_t>(x), 0, z}, patch.lod});
      if (edited.size() > 0) last_y = std::max(last_y, static_cast<std::int32_t>(edited.last));
    }
    VoxelSlab<Item> slab{patch, plan_.y0, chunk_z};
    slab.reserve_rows((std::int64_t{last_y} + 1) * kChunkSize - plan_.y0);
    for (std::int64_t x = xs.first; x <= xs.last; ++x) {
      for (auto y = static_cast<std::int32_t>(floor_div(plan_.y0, kChunkSize)); y <= last_y; ++y) {
        const ChunkCoord coord{static_cast<std::int32_t>(x), y, z};
        const auto chunk = chunk_at(stacks, {coord, patch.lod});
        if (!chunk) return tl::unexpected{chunk.error()};
        slab.copy(*chunk, coord);
      }
    }
    for (int of = slab.first_z(); of < slab.last_z(); ++of) {
      for (std::int32_t y = 0; y < slab.rows(); ++y) {
        if (auto done = file.write(item(patch, static_cast<std::size_t>(y), of), slab.row(y, of)); !done)
          return tl::unexpected{Failure{done.error()}};
      }
    }
    rows = std::max(rows, slab.rows());
  }
  return rows;
}

}  // namespace talus::tools
