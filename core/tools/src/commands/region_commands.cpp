#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <talus/files/path_text.h>
#include <talus/map/column_grid.h>
#include <talus/tools/image.h>
#include <talus/tools/option_values.h>
#include <talus/tools/world_file.h>

#include "commands/commands.h"
#include "export.h"
#include "land_edits.h"
#include "map.h"
#include "region_hash.h"
#include "sampled_map.h"
#include "section.h"
#include "tops_of_edits.h"
#include "vox.h"
#include "vox_file.h"

namespace talus::tools {
namespace {

constexpr std::int64_t kMaxExportSide = std::int64_t{1} << 24;
constexpr std::int64_t kMaxHashSide = std::int64_t{1} << 20;

struct Arguments {
  std::string world;
  std::string place;  // --center, --origin or --from
  std::string size;
  std::int64_t lod = 0;
  int threads = 0;
  std::string output;
  std::string store;  // may be empty
};

struct WorldAndRegion {
  terrain::World world;
  terrain::Region region;
};

// Position of a command's region relative to its place.
struct Placement {
  const char* option;
  Expected<terrain::Region> (*region)(std::string_view option, IntegerPair place, IntegerPair size, Lod lod);
};
constexpr Placement kCorner{"--origin", region_from_origin};
constexpr Placement kMiddle{"--center", region_around};

Expected<WorldAndRegion> world_and_region(const Arguments& arguments, const Placement& placement,
                                          std::int64_t longest_side) {
  const auto place = parse_pair(placement.option, arguments.place);
  if (!place) return tl::make_unexpected(place.error());
  const auto size = parse_size("--size", arguments.size, longest_side);
  if (!size) return tl::make_unexpected(size.error());
  const auto lod = parse_lod(arguments.lod);
  if (!lod) return tl::make_unexpected(lod.error());
  const auto region = placement.region(placement.option, *place, *size, *lod);
  if (!region) return tl::make_unexpected(region.error());
  auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  return WorldAndRegion{*std::move(world), *region};
}

/// Null without --store.
Expected<std::unique_ptr<const LandEdits>> edits_of(const Arguments& arguments, const terrain::World& world) {
  if (arguments.store.empty()) return nullptr;
  return open_store(arguments.store, world);
}

Expected<void> run_map(const Arguments& arguments) {
  const auto where = world_and_region(arguments, kMiddle, kMaxPictureSide);
  if (!where) return tl::make_unexpected(where.error());
  const terrain::Region& region = where->region;
  if (auto fits = check_picture_size("--size", region.width, region.depth); !fits) return fits;
  const auto edits = edits_of(arguments, where->world);
  if (!edits) return tl::make_unexpected(edits.error());
  auto file = PngFile::create(files::to_path(arguments.output));
  if (!file) return tl::make_unexpected(file.error());
  ProgressBar progress{"map", "columns"};
  std::optional<TopsOfEdits> tops;
  if (*edits != nullptr) tops.emplace(where->world, **edits);
  const Image image = render_map(where->world, region,
                                 {.threads = arguments.threads, .edits = tops ? &*tops : nullptr}, progress);
  if (const auto failure = tops ? tops->failure() : std::nullopt) return tl::make_unexpected(*failure);
  return file->write(image);
}

struct MapArguments : Arguments {
  std::int64_t every = 0;  // 0: not given
};

// The same centre as a region of columns; fails too if the region leaves the world.
Expected<map::ColumnGrid> grid_of(const MapArguments& arguments) {
  const auto place = parse_pair("--center", arguments.place);
  if (!place) return tl::make_unexpected(place.error());
  const auto size = parse_size("--size", arguments.size, kMaxPictureSide);
  if (!size) return tl::make_unexpected(size.error());
  const IntegerPair span{size->first * arguments.every, size->second * arguments.every};
  if (auto inside = region_around("--center", *place, span, Lod{}); !inside) {
    return tl::make_unexpected(inside.error());
  }
  return map::grid_around(place->first, place->second, arguments.every, static_cast<int>(size->first),
                          static_cast<int>(size->second));
}

Expected<void> run_map_from_afar(const MapArguments& arguments) {
  const auto grid = grid_of(arguments);
  if (!grid) return tl::make_unexpected(grid.error());
  if (auto fits = check_picture_size("--size", grid->width, grid->depth); !fits) return fits;
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  auto file = PngFile::create(files::to_path(arguments.output));
  if (!file) return tl::make_unexpected(file.error());
  ProgressBar progress{"map", "columns"};
  return file->write(render_sampled_map(*world, *grid, {.threads = arguments.threads}, progress));
}

struct SectionArguments : Arguments {
  std::int64_t length = 1024;
  std::string axis = "x";
  int scale = 1;
};

Expected<void> run_section(const SectionArguments& arguments) {
  const auto from = parse_pair("--from", arguments.place);
  if (!from) return tl::make_unexpected(from.error());
  if (auto fits = check_picture_size("--length", arguments.length * arguments.scale, 1); !fits) return fits;
  const IntegerPair size =
      arguments.axis == "x" ? IntegerPair{arguments.length, 1} : IntegerPair{1, arguments.length};
  const auto line = region_from_origin("--from", *from, size, Lod{});
  if (!line) return tl::make_unexpected(line.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  auto file = PngFile::create(files::to_path(arguments.output));
  if (!file) return tl::make_unexpected(file.error());
  ProgressBar progress{"section", "columns"};
  const auto image =
      render_section(*world, *line, {.threads = arguments.threads, .scale = arguments.scale}, progress);
  if (!image) return tl::make_unexpected(image.error());
  return file->write(*image);
}

Expected<void> run_export(const Arguments& arguments) {
  const auto where = world_and_region(arguments, kCorner, kMaxExportSide);
  if (!where) return tl::make_unexpected(where.error());
  const auto edits = edits_of(arguments, where->world);
  if (!edits) return tl::make_unexpected(edits.error());
  ProgressBar progress{"export", "columns"};
  return export_region(where->world, where->region, files::to_path(arguments.output),
                       {.threads = arguments.threads, .edits = edits->get()}, progress);
}

Expected<void> run_hash(const Arguments& arguments) {
  const auto where = world_and_region(arguments, kCorner, kMaxHashSide);
  if (!where) return tl::make_unexpected(where.error());
  std::string digits;
  {
    ProgressBar progress{"hash", "chunk columns"};
    digits = to_string(hash_region(where->world, where->region, {.threads = arguments.threads}, progress));
  }
  if (std::printf("%s\n", digits.c_str()) < 0 || std::fflush(stdout) != 0) {
    return failed(std::string{"standard output: cannot write the hash: "} + std::strerror(errno));
  }
  return {};
}

struct VoxArguments : Arguments {
  int depth = VoxOptions{}.depth;
};

Expected<void> run_vox(const VoxArguments& arguments) {
  const auto where = world_and_region(arguments, kCorner, kVoxSceneSide);
  if (!where) return tl::make_unexpected(where.error());
  ProgressBar progress{"vox", "models"};
  return write_vox(where->world, where->region, files::to_path(arguments.output),
                   {.threads = arguments.threads, .depth = arguments.depth}, progress);
}

void add_place(CLI::App& command, Arguments& arguments, const char* option, const char* meaning) {
  command.add_option(option, arguments.place, meaning)->type_name("X,Z")->required();
}

void add_size(CLI::App& command, Arguments& arguments, const char* meaning) {
  command.add_option("--size", arguments.size, meaning)->type_name("W,H")->required();
}

CLI::Option* add_store(CLI::App& command, Arguments& arguments) {
  return command
      .add_option("--store", arguments.store,
                  "With the edits of this store: a directory that talusd was given as --data and that no "
                  "talusd uses now, or a backup of one. It is only read. Give the server's --world, too: its "
                  "file has the names and colours of placeable materials")
      ->type_name("DIR");
}

void add_common(CLI::App& command, Arguments& arguments) {
  add_world(command, arguments.world);
  add_threads(command, arguments.threads);
}

}  // namespace

Command add_map(CLI::App& app) {
  auto* map = app.add_subcommand("map", "Draw a shaded map of materials, north (low z) at the top");
  const auto arguments = std::make_shared<MapArguments>();
  add_place(*map, *arguments, "--center",
            "Base voxel at the middle of the picture, at every level of detail");
  add_size(*map, *arguments,
           "Pixels, each one column of the level of detail, or one of --every; at most 2^28 in all");
  add_lod(*map, arguments->lod);
  map->add_option("--every", arguments->every,
                  "Instead of --lod: one pixel for every N base columns along x and z, 1 to 4096")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{4096}))
      ->type_name("N")
      ->excludes("--lod")
      ->excludes(add_store(*map, *arguments));
  add_output(*map, arguments->output, "Picture to write", "F.png");
  add_common(*map, *arguments);
  map->footer(
      "--every samples the world: at 64, a picture of 1024 x 1024 pixels shows 65,536 columns. From 16 on, "
      "worlds\n"
      "with looks are drawn by look and height alone, without walls of bare rock, and mountains are lifted.");
  return {map,
          [arguments] { return arguments->every > 0 ? run_map_from_afar(*arguments) : run_map(*arguments); }};
}

Command add_section(CLI::App& app) {
  auto* section = app.add_subcommand("section", "Draw a vertical cut that shows the layers, voxel by voxel");
  const auto arguments = std::make_shared<SectionArguments>();
  add_place(*section, *arguments, "--from", "Base voxel at the left end of the cut");
  section->add_option("--length", arguments->length, "Columns, eastward (southward with --axis z)")
      ->check(CLI::Range(std::int64_t{1}, kMaxPictureSide))
      ->type_name("N")
      ->required();
  section->add_option("--axis", arguments->axis, "Direction of the cut: x (eastward) or z (southward)")
      ->check(CLI::IsMember({"x", "z"}))
      ->type_name("x|z")
      ->capture_default_str();
  section->add_option("--scale", arguments->scale, "Pixels a voxel, 1 to 64")
      ->check(CLI::Range(1, 64))
      ->type_name("S")
      ->capture_default_str();
  add_output(*section, arguments->output, "Picture to write", "F.png");
  add_common(*section, *arguments);
  return {section, [arguments] { return run_section(*arguments); }};
}

Command add_export(CLI::App& app) {
  auto* command = app.add_subcommand(
      "export", "Write every intermediate result over a region, and its voxels, as NumPy arrays");
  const auto arguments = std::make_shared<Arguments>();
  add_place(*command, *arguments, "--origin", "Base voxel at the region's north-west corner, at every level");
  add_size(*command, *arguments,
           "Columns of the level of detail along x and z; refused if the arrays could exceed 8 GiB");
  add_lod(*command, arguments->lod);
  add_output(*command, arguments->output, "Directory for the arrays and export.json; created if missing",
             "DIR");
  add_store(*command, *arguments);
  add_common(*command, *arguments);
  command->footer(
      "Heights and thicknesses are int32 in 1/256 voxel of the level; export.json documents every array.\n"
      "  surface.npy [z][x]         slope.npy [z][x], 1/256 of rise over run\n"
      "  apron.npy [z][x], what talus aprons added to the ground (not with the erosion method)\n"
      "  place.npy, eroded.npy [m][z][x], thickness that the place allows, and settled, in the spec's order\n"
      "  strata.npy [layer][z][x], tops before loose material is inserted; the last is the surface\n"
      "  shown.npy [plane][z][x], uint16, ids that strata, loose material bottom up and water show\n"
      "  fields.npy [f][z][x], quantities such as temperature, times 65536\n"
      "  look.npy [z][x], uint8, in worlds with looks\n"
      "  voxels.npy [y][z][x], material ids (uint8; uint16 in worlds with ids over 255), from y = 0, or -1\n"
      "             at coarse levels, up to the highest voxel that is not air\n"
      "With --store voxels.npy has the edits, from the lowest chunk that was edited up; all other arrays are "
      "as\n"
      "generated.");
  return {command, [arguments] { return run_export(*arguments); }};
}

Command add_hash(CLI::App& app) {
  auto* hash =
      app.add_subcommand("hash", "Print one hash over the encoded chunks of a region: 32 hex digits");
  const auto arguments = std::make_shared<Arguments>();
  add_place(*hash, *arguments, "--origin", "Base voxel at the region's north-west corner, at every level");
  add_size(*hash, *arguments, "Columns of the level of detail along x and z; at most 2^20 a side");
  add_lod(*hash, arguments->lod);
  add_common(*hash, *arguments);
  hash->footer(
      "Covers every chunk column that holds a column of the region. A column's hash is XXH3-128 over its\n"
      "chunks from row -1 up to the row of the highest voxel that the world can have. Each chunk "
      "contributes\n"
      "x, y, z and level (int32), the payload's length (uint32) and the payload. The region's hash is\n"
      "XXH3-128 over the column hashes (low 64 bits, then high), z slowest, then x. Numbers are "
      "little-endian.\n"
      "The hash is the same for any number of threads, on any machine.");
  return {hash, [arguments] { return run_hash(*arguments); }};
}

Command add_vox(CLI::App& app) {
  auto* vox = app.add_subcommand("vox", "Write the voxels of a region as MagicaVoxel models");
  const auto arguments = std::make_shared<VoxArguments>();
  add_place(*vox, *arguments, "--origin", "Base voxel at the region's north-west corner, at every level");
  add_size(*vox, *arguments, "Columns of the level of detail along x and z; at most 2048 a side");
  add_lod(*vox, arguments->lod);
  vox->add_option("--depth", arguments->depth, "Voxels below the lowest ground, 1 to 4096")
      ->check(CLI::Range(1, 4096))
      ->type_name("N")
      ->capture_default_str();
  add_output(*vox, arguments->output, "File to write", "F.vox");
  add_common(*vox, *arguments);
  vox->footer(
      "Writes the visible voxels, which have a face to air, to water or to one of the region's four sides.\n"
      "Hidden voxels are left out, and the underside is open. Water has a glass material, so that its bed\n"
      "shows when the scene is rendered. East is x, north is y, up is z; the region's middle is at x = y = "
      "0,\n"
      "its lowest row at z = 0. A region of more than 256 voxels a side becomes several models, placed by "
      "the\n"
      "scene graph; each is named by the voxel (x y z) at its lowest, north-western corner. A voxel's "
      "palette\n"
      "index is its material's id.");
  return {vox, [arguments] { return run_vox(*arguments); }};
}

}  // namespace talus::tools
