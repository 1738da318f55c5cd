#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <system_error>

#include <talus/files/atomic_file.h>
#include <talus/tools/option_values.h>
#include <talus/tools/world_file.h>

#include "commands/commands.h"
#include "gallery.h"
#include "likeness.h"
#include "lod_error.h"
#include "quality.h"
#include "table1.h"

namespace talus::tools {
namespace {

Expected<void> print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  if (std::fflush(stdout) != 0) return failed(std::string{"standard output: "} + std::strerror(errno));
  return {};
}

// Prints a table to standard output, and writes JSON to a file if requested.
template <class Figures>
Expected<void> report(const Figures& figures, const std::string& json_path) {
  if (auto printed = print(to_text(figures)); !printed) return printed;
  if (json_path.empty()) return {};
  return outcome_of(files::write_file(json_path, to_json(figures)));
}

struct GalleryArguments {
  std::string world;
  int threads = 0;
  std::string output;
  std::string only;
};

Expected<void> run_gallery(const GalleryArguments& arguments) {
  const auto text = read_world_text(arguments.world);
  if (!text) return tl::make_unexpected(text.error());
  ProgressBar progress{"gallery", "rows"};
  return write_gallery(*text, arguments.only, arguments.output, arguments.threads, progress);
}

struct SeedsArguments {
  std::string world;
  int seeds = 20;
  std::string output;
};

Expected<void> run_table1_command(const SeedsArguments& arguments) {
  const auto text = read_world_text(arguments.world);
  if (!text) return tl::make_unexpected(text.error());
  const std::filesystem::path directory = arguments.output;
  if (!directory.empty()) {
    std::error_code made;
    std::filesystem::create_directories(directory, made);
    if (made) return failed(directory.string() + ": cannot make the directory: " + made.message());
  }
  const auto table = [&] {
    ProgressBar progress{"table1", "columns"};
    return run_table1(*text, arguments.seeds, progress);
  }();
  if (!table) return tl::make_unexpected(table.error());
  if (directory.empty()) return print(to_text(*table));
  if (auto reported = report(*table, (directory / "table1.json").string()); !reported) return reported;
  return outcome_of(files::write_file(directory / "table1.svg", to_svg(*table)));
}

Expected<void> run_likeness(const SeedsArguments& arguments) {
  const auto text = read_world_text(arguments.world);
  if (!text) return tl::make_unexpected(text.error());
  const auto likeness = [&] {
    ProgressBar progress{"likeness", "seeds"};
    return measure_likeness(*text, arguments.seeds, progress);
  }();
  if (!likeness) return tl::make_unexpected(likeness.error());
  return report(*likeness, arguments.output);
}

struct LodErrorArguments {
  std::string world;
  std::string centre = "0,0";
  std::int64_t size = 4096;
  int threads = 0;
  std::string output;
};

constexpr std::int64_t kCoarsest = 64;  // base columns per column of level 6

Expected<void> run_lod_error(const LodErrorArguments& arguments) {
  const auto centre = parse_pair("--center", arguments.centre);
  if (!centre) return tl::make_unexpected(centre.error());
  if (arguments.size % kCoarsest != 0) {
    return wrong_use("--size: " + std::to_string(arguments.size) +
                     " is not a multiple of 64, level 6's columns");
  }
  const auto corner = [&](std::int64_t middle) {
    return floor_div(middle - arguments.size / 2, kCoarsest) * kCoarsest;
  };
  const auto region = region_from_origin("--center", {corner(centre->first), corner(centre->second)},
                                         {arguments.size, arguments.size}, Lod{});
  if (!region) return tl::make_unexpected(region.error());
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  const LodError error = [&] {
    ProgressBar progress{"lod-error", "columns"};
    return measure_lod_error(*world, *region, arguments.threads, progress);
  }();
  return report(error, arguments.output);
}

struct QualityArguments {
  std::string world;
  bool quick = false;
  bool json = false;
  int threads = 0;
};

Expected<void> run_quality(const QualityArguments& arguments) {
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  QualityOptions options = QualityOptions::quick(arguments.threads);
  if (!arguments.quick) options = {.threads = arguments.threads};
  const Quality quality = [&] {
    ProgressBar progress{"quality", "columns"};
    return measure_quality(*world, options, progress);
  }();
  return print(arguments.json ? to_json(quality) : to_text(quality));
}

void add_seeds(CLI::App& command, int& seeds, const char* meaning) {
  command.add_option("--seeds", seeds, meaning)
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
}

void add_json(CLI::App& command, std::string& output) {
  command.add_option("-o,--output", output, "Write the figures as JSON, too")->type_name("F.json");
}

}  // namespace

Command add_gallery(CLI::App& app) {
  auto* gallery = app.add_subcommand("gallery", "Draw the figures of the thesis from this world's voxels");
  const auto arguments = std::make_shared<GalleryArguments>();
  add_output(*gallery, arguments->output, "Directory for the pictures; created if missing", "DIR");
  add_world(*gallery, arguments->world);
  add_threads(*gallery, arguments->threads);
  gallery->add_option("--only", arguments->only, "Draw only figures whose name contains TEXT; default: all")
      ->type_name("TEXT");
  gallery->footer(
      "The thesis is Furtado Machado's (KTH, 2019). Draws gallery-NN-*.png, where NN is the figure's number\n"
      "there, and gallery-levels.png. Chooses places near the origin that show most. Some panels change the\n"
      "world's resolution, roughness or exponent. The same world gives the same pictures.");
  return {gallery, [arguments] { return run_gallery(*arguments); }};
}

Command add_table1(CLI::App& app) {
  auto* table =
      app.add_subcommand("table1", "Measure table 1 of the thesis again: seconds of both methods by size");
  const auto arguments = std::make_shared<SeedsArguments>();
  add_seeds(*table, arguments->seeds, "Number of terrains of each size; their seeds are 1, 2, ...");
  table
      ->add_option("-o,--output", arguments->output,
                   "Directory for table1.json and table1.svg, a plot; created if missing")
      ->type_name("DIR");
  add_world(*table, arguments->world);
  table->footer(
      "Measures seconds for the whole terrain on one thread. Terrains have 50 to 200 columns a side, and as\n"
      "many voxels a terrain unit, so each is one unit of the same terrain. Erosion runs on a bounded map\n"
      "until nothing moves. The thesis' own seconds are printed next to them.");
  return {table, [arguments] { return run_table1_command(*arguments); }};
}

Command add_likeness(CLI::App& app) {
  auto* likeness = app.add_subcommand("likeness", "Compare the loose layers of both methods, in numbers");
  const auto arguments = std::make_shared<SeedsArguments>();
  add_seeds(*likeness, arguments->seeds, "Number of terrains; their seeds are 1, 2, ...");
  add_json(*likeness, arguments->output);
  add_world(*likeness, arguments->world);
  likeness->footer(
      "Generates two terrain units a side at 100 voxels a unit, by the slope method and by erosion until\n"
      "nothing moves. A column is covered if it has any of the material. Both / either: columns that both\n"
      "methods cover, divided by columns that at least one covers. If independent: the same quotient for\n"
      "independent covers of the same sizes. Thickness, r: Pearson's correlation over all columns.");
  return {likeness, [arguments] { return run_likeness(*arguments); }};
}

Command add_lod_error(CLI::App& app) {
  auto* error = app.add_subcommand("lod-error", "Measure how far the levels of detail deviate from level 0");
  const auto arguments = std::make_shared<LodErrorArguments>();
  error->add_option("--center", arguments->centre, "Base voxel at the middle of the region")
      ->type_name("X,Z")
      ->capture_default_str();
  error->add_option("--size", arguments->size, "Base columns along each side: a multiple of 64, up to 65536")
      ->check(CLI::Range(kCoarsest, std::int64_t{1} << 16))
      ->type_name("N")
      ->capture_default_str();
  add_json(*error, arguments->output);
  add_world(*error, arguments->world);
  add_threads(*error, arguments->threads);
  error->footer(
      "Each base column is held against the column of the level that it is a part of. Surface: the heights\n"
      "themselves; voxels: the tops of the highest solid voxels, which is what a client draws.");
  return {error, [arguments] { return run_lod_error(*arguments); }};
}

Command add_quality(CLI::App& app) {
  auto* quality = app.add_subcommand(
      "quality", "Measure a world: evenness of directions, variety, water, steps, slopes and heights");
  const auto arguments = std::make_shared<QualityArguments>();
  quality->add_flag("--quick", arguments->quick,
                    "Look at a tenth of the places: seconds instead of up to minutes, and wide errors");
  quality->add_flag("--json", arguments->json, "Print JSON instead of a table");
  add_world(*quality, arguments->world);
  add_threads(*quality, arguments->threads);
  quality->footer(
      "Places lie up to 2^24 columns from the origin and are the same each time, so equal worlds have equal "
      "figures,\n"
      "whatever the threads. Directions: power of heights in octave bands of wavelength, within 15 degrees "
      "of the\n"
      "axes and of the diagonals, of windows of 256 x 256 samples, 8 to a wave; each window weighs alike. "
      "Blocks: one\n"
      "column of 50 along x and z. Water: columns whose top voxel lies under the sea's; a lone piece is less "
      "than 16\n"
      "columns that touch no other water, not even at a corner. Slope: rise to the highest of eight "
      "neighbours or fall\n"
      "to the lowest, over one column (thesis, equation 1). Heights are heights of the rock's surface before "
      "talus and\n"
      "erosion move it, in voxels over the sea. Of regions also: steps that no terrace makes; how high beds "
      "of "
      "rivers\n"
      "lie over their flood plain; heights at the lattice points of each noise next to heights in the "
      "middles of its cells.\n"
      "The default world's requirements are printed, each with its result.");
  return {quality, [arguments] { return run_quality(*arguments); }};
}

}  // namespace talus::tools
