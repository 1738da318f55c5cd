#include "export.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <talus/files/atomic_file.h>
#include <talus/files/npy_file.h>
#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

#include "export_json.h"
#include "ordered_work.h"
#include "patch_grid.h"
#include "voxel_grid.h"

namespace talus::tools {
namespace {

struct Arrays {
  files::NpyFile surface;
  files::NpyFile slope;
  files::NpyFile eroded;
  files::NpyFile strata;
  files::NpyFile voxels;
};

files::NpyType voxel_type(const terrain::World& world) {
  return world.materials().size() > 256 ? files::NpyType::uint16 : files::NpyType::uint8;
}

Expected<Arrays> create_arrays(const terrain::World& world, const std::filesystem::path& directory) {
  auto surface = files::NpyFile::create(directory / "surface.npy", files::NpyType::int32);
  if (!surface) return tl::make_unexpected(surface.error());
  auto slope = files::NpyFile::create(directory / "slope.npy", files::NpyType::int32);
  if (!slope) return tl::make_unexpected(slope.error());
  auto eroded = files::NpyFile::create(directory / "eroded.npy", files::NpyType::int32);
  if (!eroded) return tl::make_unexpected(eroded.error());
  auto strata = files::NpyFile::create(directory / "strata.npy", files::NpyType::int32);
  if (!strata) return tl::make_unexpected(strata.error());
  auto voxels = files::NpyFile::create(directory / "voxels.npy", voxel_type(world));
  if (!voxels) return tl::make_unexpected(voxels.error());
  return Arrays{std::move(*surface), std::move(*slope), std::move(*eroded), std::move(*strata),
                std::move(*voxels)};
}

// Writes a patch where it belongs in the arrays of the whole region.
class PatchWriter {
 public:
  PatchWriter(const terrain::World& world, const terrain::Region& region, const Arrays& arrays)
      : world_{world}, region_{region}, arrays_{arrays} {}

  // The rows of voxels that the patch needs.
  [[nodiscard]] Expected<std::int32_t> write(const terrain::Terrain& terrain) const {
    if (auto done = write_field(arrays_.surface, 0, terrain.region, terrain.surface); !done)
      return error(done);
    if (auto done = write_field(arrays_.slope, 0, terrain.region, terrain.slope); !done) return error(done);
    if (auto done = write_fields(arrays_.eroded, terrain.region, terrain.loose); !done) return error(done);
    if (auto done = write_fields(arrays_.strata, terrain.region, terrain.strata); !done) return error(done);
    return voxel_type(world_) == files::NpyType::uint8 ? write_voxels<std::uint8_t>(terrain)
                                                       : write_voxels<std::uint16_t>(terrain);
  }

 private:
  static tl::unexpected<Failure> error(const tl::expected<void, files::FileError>& failed) {
    return tl::unexpected{Failure{failed.error()}};
  }

  // The item of column (x, z) of the patch in the region's array, on its `slice`th plane.
  std::size_t item(const terrain::Region& patch, std::size_t slice, int z) const {
    const auto region_z = static_cast<std::size_t>(patch.z - region_.z + z);
    const auto region_x = static_cast<std::size_t>(patch.x - region_.x);
    const auto width = static_cast<std::size_t>(region_.width);
    return (slice * static_cast<std::size_t>(region_.depth) + region_z) * width + region_x;
  }

  tl::expected<void, files::FileError> write_field(const files::NpyFile& file, std::size_t slice,
                                                   const terrain::Region& patch,
                                                   const terrain::Field& field) const {
    for (int z = 0; z < patch.depth; ++z) {
      if (auto done = file.write(item(patch, slice, z), field.row(z)); !done) return done;
    }
    return {};
  }

  tl::expected<void, files::FileError> write_fields(const files::NpyFile& file, const terrain::Region& patch,
                                                    const std::vector<terrain::Field>& fields) const {
    for (std::size_t slice = 0; slice < fields.size(); ++slice) {
      if (auto done = write_field(file, slice, patch, fields[slice]); !done) return done;
    }
    return {};
  }

  template <typename Item>
  Expected<std::int32_t> write_voxels(const terrain::Terrain& terrain) const {
    const terrain::Region& patch = terrain.region;
    const auto& heights = terrain.surface.values;
    const std::int32_t highest_fx = *std::max_element(heights.begin(), heights.end());
    const std::int32_t rows = terrain::boundary_row(std::max(highest_fx, world_.sea_fx().value_or(0)));
    const auto width = static_cast<std::size_t>(patch.width);
    // Writes one z of a row of chunks at a time, as [y][x]: memory stays small, and every row of voxels is
    // one write.
    std::vector<Item> slab(static_cast<std::size_t>(rows) * width);
    for (int z = 0; z < patch.depth;) {
      const int to_next_chunk = kChunkSize - static_cast<int>(floor_mod(patch.z + z, kChunkSize));
      const int depth = std::min(to_next_chunk, patch.depth - z);
      const VoxelGrid grid =
          grid_of_chunks(world_, {patch.x, patch.z + z, patch.width, depth, patch.lod}, 0, rows);
      for (int end = z + depth; z < end; ++z) {
        for (std::size_t x = 0; x < width; ++x) {
          const auto column = grid.column(static_cast<int>(x), z - end + depth);
          for (std::size_t y = 0; y < column.size(); ++y) {
            slab[y * width + x] = static_cast<Item>(to_integer(column[y]));
          }
        }
        for (std::size_t y = 0; y < static_cast<std::size_t>(rows); ++y) {
          const auto row = std::span<const Item>{slab}.subspan(y * width, width);
          if (auto done = arrays_.voxels.write(item(patch, y, z), row); !done) return error(done);
        }
      }
    }
    return rows;
  }

  const terrain::World& world_;
  const terrain::Region& region_;
  const Arrays& arrays_;
};

// Every column has the same planes, so that one tells what all have.
std::vector<MaterialId> strata_materials(const terrain::World& world, const terrain::Region& region) {
  return generate_terrain(world, {region.x, region.z, 1, 1, region.lod}).strata_materials;
}

Expected<void> check_bytes(const terrain::World& world, const terrain::Region& region, std::size_t planes,
                           std::uint64_t max_bytes) {
  const auto rows = static_cast<std::size_t>(static_cast<std::int32_t>(highest_row(world, Lod{})));
  const std::size_t column_bytes =
      (2 + world.loose().size() + planes) * sizeof(std::int32_t) + rows * item_bytes(voxel_type(world));
  if (region.columns() <= max_bytes / column_bytes) return {};
  std::array<char, 160> text{};
  std::snprintf(
      text.data(), text.size(),
      "--size: %d x %d columns could take %.1f GiB, the limit is %.1f GiB; at most %llu columns fit",
      region.width, region.depth,
      static_cast<double>(column_bytes) * static_cast<double>(region.columns()) / (1 << 30),
      static_cast<double>(max_bytes) / (1 << 30), static_cast<unsigned long long>(max_bytes / column_bytes));
  return wrong_use(text.data());
}

tl::expected<void, files::FileError> finish(Arrays& arrays, const terrain::World& world,
                                            const terrain::Region& region, std::size_t planes,
                                            std::size_t rows) {
  const auto w = static_cast<std::size_t>(region.width);
  const auto d = static_cast<std::size_t>(region.depth);
  const std::array plane_shape{d, w};
  const std::array eroded_shape{world.loose().size(), d, w};
  const std::array strata_shape{planes, d, w};
  const std::array voxel_shape{rows, d, w};
  if (auto done = arrays.surface.finish(plane_shape); !done) return done;
  if (auto done = arrays.slope.finish(plane_shape); !done) return done;
  if (auto done = arrays.eroded.finish(eroded_shape); !done) return done;
  if (auto done = arrays.strata.finish(strata_shape); !done) return done;
  if (auto done = arrays.voxels.finish(voxel_shape); !done) return done;
  for (files::NpyFile* file :
       {&arrays.surface, &arrays.slope, &arrays.eroded, &arrays.strata, &arrays.voxels}) {
    if (auto done = file->commit(); !done) return done;
  }
  return {};
}

}  // namespace

Expected<void> export_region(const terrain::World& world, const terrain::Region& region,
                             const std::filesystem::path& directory, const ExportOptions& options,
                             ProgressBar& progress) {
  const std::vector<MaterialId> layers = strata_materials(world, region);
  if (auto fits = check_bytes(world, region, layers.size(), options.max_bytes); !fits) return fits;
  std::error_code made;
  std::filesystem::create_directories(directory, made);
  if (made) return failed(directory.string() + ": cannot make the directory: " + made.message());
  auto arrays = create_arrays(world, directory);
  if (!arrays) return tl::make_unexpected(arrays.error());
  auto json = files::AtomicFile::create(directory / "export.json");
  if (!json) return tl::make_unexpected(json.error());

  const PatchGrid grid{region, options.patch_edge};
  const PatchWriter writer{world, region, *arrays};
  progress.expect(region.columns());
  std::int32_t rows = 0;
  Expected<void> outcome;
  const auto produce = [&](std::size_t index) {
    return writer.write(generate_terrain(world, grid.patch(index)));
  };
  work_in_order(grid.count(), thread_count(options.threads), produce,
                [&](std::size_t index, const Expected<std::int32_t>& patch_rows) {
                  if (!patch_rows) {
                    outcome = tl::make_unexpected(patch_rows.error());
                    return false;
                  }
                  rows = std::max(rows, *patch_rows);
                  progress.advance(grid.patch(index).columns());
                  return true;
                });
  if (!outcome) return outcome;
  if (auto done = finish(*arrays, world, region, layers.size(), static_cast<std::size_t>(rows)); !done)
    return outcome_of(done);
  const std::string text = export_json(world, region, layers);
  if (auto done = json->write_at(0, std::as_bytes(std::span{text})); !done) return outcome_of(done);
  return outcome_of(json->commit());
}

}  // namespace talus::tools
