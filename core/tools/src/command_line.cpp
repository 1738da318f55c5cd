#include "command_line.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <new>
#include <span>

#include <talus/vectors/instruction_set.h>
#include <CLI/CLI.hpp>

#include "atomic_file.h"
#include "erode_height_map.h"
#include "export.h"
#include "failure.h"
#include "gallery.h"
#include "image.h"
#include "map.h"
#include "option_values.h"
#include "region_hash.h"
#include "section.h"
#include "table1.h"
#include "vox.h"
#include "vox_file.h"
#include "world_file.h"

namespace talus::tools {
namespace {

constexpr std::int64_t kMaxExportSide = std::int64_t{1} << 24;
constexpr std::int64_t kMaxHashSide = std::int64_t{1} << 20;
constexpr std::int64_t kMaxDroplets = 1'000'000'000;

// What the options of all commands hold, as typed.
struct Arguments {
  std::string world;
  std::string place;  // --center, --origin or --from
  std::string size = "1024,1024";
  std::int64_t lod = 0;
  std::int64_t length = 1024;
  std::string axis = "x";
  int scale = 1;
  int depth = VoxOptions{}.depth;
  int threads = 0;
  int seeds = 20;
  std::string input;
  std::int64_t droplets = 100000;
  std::int64_t seed = 1;
  std::string output;
};

Expected<void> run_map(const Arguments& arguments) {
  const auto centre = parse_pair("--center", arguments.place);
  if (!centre) return tl::make_unexpected(centre.error());
  const auto size = parse_size("--size", arguments.size, kMaxPictureSide);
  if (!size) return tl::make_unexpected(size.error());
  if (auto fits = check_picture_size("--size", size->first, size->second); !fits) return fits;
  const auto lod = parse_lod(arguments.lod);
  if (!lod) return tl::make_unexpected(lod.error());
  const auto region = region_around("--center", *centre, *size, *lod);
  if (!region) return tl::make_unexpected(region.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  auto file = PngFile::create(arguments.output);
  if (!file) return tl::make_unexpected(file.error());
  Progress progress{"map", "columns"};
  return file->write(render_map(*world, *region, {.threads = arguments.threads}, progress));
}

Expected<void> run_section(const Arguments& arguments) {
  const auto from = parse_pair("--from", arguments.place);
  if (!from) return tl::make_unexpected(from.error());
  if (auto fits = check_picture_size("--length", arguments.length * arguments.scale, 1); !fits) return fits;
  const IntegerPair size =
      arguments.axis == "x" ? IntegerPair{arguments.length, 1} : IntegerPair{1, arguments.length};
  const auto line = region_from_origin("--from", *from, size, Lod{});
  if (!line) return tl::make_unexpected(line.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  auto file = PngFile::create(arguments.output);
  if (!file) return tl::make_unexpected(file.error());
  Progress progress{"section", "columns"};
  const auto image =
      render_section(*world, *line, {.threads = arguments.threads, .scale = arguments.scale}, progress);
  if (!image) return tl::make_unexpected(image.error());
  return file->write(*image);
}

Expected<void> run_export(const Arguments& arguments) {
  const auto origin = parse_pair("--origin", arguments.place);
  if (!origin) return tl::make_unexpected(origin.error());
  const auto size = parse_size("--size", arguments.size, kMaxExportSide);
  if (!size) return tl::make_unexpected(size.error());
  const auto region = region_from_origin("--origin", *origin, *size, Lod{});
  if (!region) return tl::make_unexpected(region.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  Progress progress{"export", "columns"};
  return export_region(*world, *region, arguments.output, {.threads = arguments.threads}, progress);
}

Expected<void> run_hash(const Arguments& arguments) {
  const auto origin = parse_pair("--origin", arguments.place);
  if (!origin) return tl::make_unexpected(origin.error());
  const auto size = parse_size("--size", arguments.size, kMaxHashSide);
  if (!size) return tl::make_unexpected(size.error());
  const auto lod = parse_lod(arguments.lod);
  if (!lod) return tl::make_unexpected(lod.error());
  const auto region = region_from_origin("--origin", *origin, *size, *lod);
  if (!region) return tl::make_unexpected(region.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  std::string digits;
  {
    Progress progress{"hash", "chunk columns"};
    digits = to_string(hash_region(*world, *region, {.threads = arguments.threads}, progress));
  }
  if (std::printf("%s\n", digits.c_str()) < 0 || std::fflush(stdout) != 0) {
    return failed(std::string{"standard output: cannot write the hash: "} + std::strerror(errno));
  }
  return {};
}

Expected<void> run_vox(const Arguments& arguments) {
  const auto origin = parse_pair("--origin", arguments.place);
  if (!origin) return tl::make_unexpected(origin.error());
  const auto size = parse_size("--size", arguments.size, kVoxSceneSide);
  if (!size) return tl::make_unexpected(size.error());
  const auto lod = parse_lod(arguments.lod);
  if (!lod) return tl::make_unexpected(lod.error());
  const auto region = region_from_origin("--origin", *origin, *size, *lod);
  if (!region) return tl::make_unexpected(region.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  Progress progress{"vox", "models"};
  return write_vox(*world, *region, arguments.output,
                   {.threads = arguments.threads, .depth = arguments.depth}, progress);
}

Expected<void> run_gallery(const Arguments& arguments) {
  const auto text = read_world_text(arguments.world);
  if (!text) return tl::make_unexpected(text.error());
  Progress progress{"gallery", "rows"};
  return write_gallery(*text, arguments.output, arguments.threads, progress);
}

Expected<void> write_whole(const std::filesystem::path& path, const std::string& text) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  if (auto written = file->write_at(0, std::as_bytes(std::span{text})); !written) return written;
  return file->commit();
}

Expected<void> run_table1_command(const Arguments& arguments) {
  const auto text = read_world_text(arguments.world);
  if (!text) return tl::make_unexpected(text.error());
  const std::filesystem::path directory = arguments.output;
  if (!directory.empty()) {
    std::error_code made;
    std::filesystem::create_directories(directory, made);
    if (made) return failed(directory.string() + ": cannot make the directory: " + made.message());
  }
  const auto table = [&] {
    Progress progress{"table1", "columns"};
    return run_table1(*text, arguments.seeds, progress);
  }();
  if (!table) return tl::make_unexpected(table.error());
  std::fputs(to_text(*table).c_str(), stdout);
  if (std::fflush(stdout) != 0) return failed(std::string{"standard output: "} + std::strerror(errno));
  if (directory.empty()) return {};
  if (auto json = write_whole(directory / "table1.json", to_json(*table)); !json) return json;
  return write_whole(directory / "table1.svg", to_svg(*table));
}

Expected<void> run_erode(const Arguments& arguments) {
  return erode_height_map(
      arguments.input, arguments.output,
      {static_cast<std::uint64_t>(arguments.droplets), static_cast<std::uint64_t>(arguments.seed)});
}

void add_world(CLI::App& command, Arguments& arguments) {
  command.add_option("--world", arguments.world, "World spec (world.toml); default: the built-in world")
      ->type_name("FILE");
}

void add_common_options(CLI::App& command, Arguments& arguments) {
  add_world(command, arguments);
  command.add_option("--threads", arguments.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->type_name("N")
      ->capture_default_str();
}

void add_place(CLI::App& command, Arguments& arguments, const char* option, const char* meaning) {
  command.add_option(option, arguments.place, meaning)->type_name("X,Z")->required();
}

void add_size(CLI::App& command, Arguments& arguments, const char* meaning) {
  command.add_option("--size", arguments.size, meaning)->type_name("W,H")->required();
}

void add_lod(CLI::App& command, Arguments& arguments) {
  command.add_option("--lod", arguments.lod, "Level of detail, 0 to 6: one column spans 2^L base voxels")
      ->type_name("L")
      ->capture_default_str();
}

void add_output(CLI::App& command, Arguments& arguments, const char* meaning, const char* type) {
  command.add_option("-o,--output", arguments.output, meaning)->type_name(type)->required();
}

CLI::App* add_map(CLI::App& app, Arguments& arguments) {
  auto* map = app.add_subcommand("map", "Shaded material map from above, north (low z) at the top");
  add_place(*map, arguments, "--center", "Base voxel at the middle of the picture, at every level of detail");
  add_size(*map, arguments, "Pixels, each one column of the level of detail; at most 2^28 in all");
  add_lod(*map, arguments);
  add_output(*map, arguments, "Picture to write", "F.png");
  return map;
}

CLI::App* add_section(CLI::App& app, Arguments& arguments) {
  auto* section = app.add_subcommand("section", "Vertical cut that shows the layers, voxel by voxel");
  add_place(*section, arguments, "--from", "Base voxel at the left end of the cut");
  section->add_option("--length", arguments.length, "Columns, eastward (southward with --axis z)")
      ->check(CLI::Range(std::int64_t{1}, kMaxPictureSide))
      ->type_name("N")
      ->required();
  section->add_option("--axis", arguments.axis, "Direction of the cut: x (eastward) or z (southward)")
      ->check(CLI::IsMember({"x", "z"}))
      ->type_name("x|z")
      ->capture_default_str();
  section->add_option("--scale", arguments.scale, "Pixels a voxel, 1 to 64")
      ->check(CLI::Range(1, 64))
      ->type_name("S")
      ->capture_default_str();
  add_output(*section, arguments, "Picture to write", "F.png");
  return section;
}

CLI::App* add_export(CLI::App& app, Arguments& arguments) {
  auto* command = app.add_subcommand(
      "export", "Surface, slope, loose material, strata and voxels of a region as NumPy arrays");
  add_place(*command, arguments, "--origin", "Base voxel at the region's north-west corner");
  add_size(*command, arguments, "Columns along x and z; refused where the arrays could pass 8 GiB");
  add_output(*command, arguments, "Directory for the arrays and export.json; made where it is missing",
             "DIR");
  command->footer(
      "Heights and thicknesses are int32 in 1/256 voxel.\n"
      "  surface.npy [z][x]         slope.npy [z][x], rise over a run of one column\n"
      "  eroded.npy [m][z][x], settled thickness, materials in the order of the spec\n"
      "  strata.npy [layer][z][x], tops before loose material is inserted; the last is the surface\n"
      "  voxels.npy [y][z][x], material ids (uint8; uint16 in worlds with ids over 255), from y = 0 up to\n"
      "             the highest row that ground or sea reaches");
  return command;
}

CLI::App* add_hash(CLI::App& app, Arguments& arguments) {
  auto* hash = app.add_subcommand("hash", "One hash over the encoded chunks of a region: 32 hex digits");
  add_place(*hash, arguments, "--origin", "Base voxel at the region's north-west corner, at every level");
  add_size(*hash, arguments, "Columns of the level of detail along x and z; at most 2^20 a side");
  add_lod(*hash, arguments);
  hash->footer(
      "Covers every chunk column that holds a column of the region. A column's hash is XXH3-128 over its\n"
      "chunks from row -1 up to the row of the highest voxel that the world can have; each gives x, y, z "
      "and\n"
      "level (int32), the payload's length (uint32) and the payload. The region's hash is XXH3-128 over the\n"
      "column hashes (low 64 bits, then high), z slowest, then x. All numbers little endian. The same for\n"
      "any number of threads, on any machine.");
  return hash;
}

CLI::App* add_vox(CLI::App& app, Arguments& arguments) {
  auto* vox = app.add_subcommand("vox", "The voxels of a region as MagicaVoxel models");
  add_place(*vox, arguments, "--origin", "Base voxel at the region's north-west corner, at every level");
  add_size(*vox, arguments, "Columns of the level of detail along x and z; at most 2048 a side");
  add_lod(*vox, arguments);
  vox->add_option("--depth", arguments.depth, "Voxels below the lowest ground, 1 to 4096")
      ->check(CLI::Range(1, 4096))
      ->type_name("N")
      ->capture_default_str();
  add_output(*vox, arguments, "File to write", "F.vox");
  vox->footer(
      "Holds the voxels that can be seen: those with a face to air, to water or to one of the region's four\n"
      "sides. What lies inside is left out and the underside stays open. Water is a material like the\n"
      "others; the bed under it is there, so it may be made glass. East is x, north is y, up is z, the\n"
      "region's middle stands at x = y = 0 and its lowest row at z = 0. Over 256 voxels a side the region\n"
      "becomes several models that the scene graph places, each named by the voxel (x y z) at its lowest,\n"
      "north-western corner. A voxel's palette index is its material's id.");
  return vox;
}

CLI::App* add_gallery(CLI::App& app, Arguments& arguments) {
  auto* gallery =
      app.add_subcommand("gallery", "The figures of the thesis as pictures of this world's voxels");
  add_output(*gallery, arguments, "Directory for the pictures; made where it is missing", "DIR");
  gallery->footer(
      "Draws gallery-NN-*.png, NN being the figure's number in the thesis. The places are those near the\n"
      "origin that make the best pictures; figures may change the world's resolution, roughness or exponent\n"
      "for a panel. The same world gives the same pictures.");
  return gallery;
}

CLI::App* add_table1(CLI::App& app, Arguments& arguments) {
  auto* table =
      app.add_subcommand("table1", "Table 1 of the thesis, run again: what both methods take, by size");
  table->add_option("--seeds", arguments.seeds, "Terrains of each size, with the seeds 1, 2, ...")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  table
      ->add_option("-o,--output", arguments.output,
                   "Directory for table1.json and table1.svg, a plot; made where missing")
      ->type_name("DIR");
  table->footer(
      "Seconds for the whole terrain on one thread: 50 to 200 columns a side at as many voxels a terrain "
      "unit,\n"
      "so always one unit of the same terrain. The slope method as everywhere; the erosion method on a map "
      "that\n"
      "ends at its edges, to rest. Beside them what the thesis measured.");
  return table;
}

CLI::App* add_erode(CLI::App& app, Arguments& arguments) {
  auto* erode = app.add_subcommand("erode-heightmap", "Hydraulic erosion of a height map by droplets");
  erode->add_option("input", arguments.input, "16-bit grey PNG, or .npy of two axes (uint16, int32, float32)")
      ->type_name("IN")
      ->required();
  erode->add_option("--droplets", arguments.droplets, "Droplets that fall; about one a sample is much")
      ->check(CLI::Range(std::int64_t{0}, kMaxDroplets))
      ->type_name("N")
      ->capture_default_str();
  erode->add_option("--seed", arguments.seed, "Decides where they fall")
      ->type_name("S")
      ->capture_default_str();
  add_output(*erode, arguments, "Height map to write: .png for 16-bit samples, .npy for any", "OUT");
  erode->footer(
      "The same seed gives the same samples on every machine. What comes out is an input of a world\n"
      "(surface.height_map.file) like any other.");
  return erode;
}

int report(const Failure& failure, const std::string& command) {
  std::fprintf(stderr, "talus-gen %s: %s\n", command.c_str(), failure.message.c_str());
  return failure.exit_code;
}

int parse_failure(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    return app.exit(error);  // --help and --version arrive here
  }
  std::fprintf(stderr, "talus-gen: %s (see --help)\n", error.what());
  return kExitWrongUse;
}

}  // namespace

int run_command_line(int argc, const char* const* argv, const std::string& version) {
  if (const auto set = forced_instruction_set(); !set) {
    std::fprintf(stderr, "talus-gen: %s\n", std::string{set.error()}.c_str());
    return kExitWrongUse;
  }
  CLI::App app{
      "The Talus terrain generator without a network: pictures, models, exports and hashes of a world.\n"
      "Places are base voxels, x east and z south, and may be negative: --center -640,32. Exit codes: 0 "
      "done,\n"
      "1 failed, 2 wrong use."};
  app.name("talus-gen");
  app.set_version_flag("--version", "talus-gen " + version + " (generator version " +
                                        std::to_string(terrain::kGeneratorVersion) + ", " +
                                        std::string{to_string(instruction_set())} + " kernels)");
  app.get_formatter()->column_width(34);

  Arguments arguments;
  using Run = std::function<Expected<void>(const Arguments&)>;
  const std::vector<std::pair<CLI::App*, Run>> commands{{add_map(app, arguments), run_map},
                                                        {add_section(app, arguments), run_section},
                                                        {add_export(app, arguments), run_export},
                                                        {add_hash(app, arguments), run_hash},
                                                        {add_vox(app, arguments), run_vox},
                                                        {add_gallery(app, arguments), run_gallery},
                                                        {add_table1(app, arguments), run_table1_command},
                                                        {add_erode(app, arguments), run_erode}};
  for (const auto& [command, run] : commands) {
    const std::string name = command->get_name();
    if (name == "erode-heightmap") continue;  // no world in it
    if (name == "table1") {
      add_world(*command, arguments);  // times are taken on one thread
    } else {
      add_common_options(*command, arguments);
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return parse_failure(app, error);
  }
  for (const auto& [command, run] : commands) {
    if (!command->parsed()) continue;
    try {
      const Expected<void> done = run(arguments);
      return done ? kExitDone : report(done.error(), command->get_name());
    } catch (const std::bad_alloc&) {
      return report({kExitFailed, "not enough memory; ask for a smaller region or fewer --threads"},
                    command->get_name());
    }
  }
  std::fputs(
      "talus-gen: a command is needed: map, section, export, hash, vox, gallery, table1 or erode-heightmap "
      "(see --help)\n",
      stderr);
  return kExitWrongUse;
}

}  // namespace talus::tools
