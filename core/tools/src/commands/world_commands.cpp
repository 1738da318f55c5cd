#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/files/path_text.h>
#include <talus/terrain/boundary_row.h>
#include <talus/terrain/heights.h>
#include <talus/tools/image.h>
#include <talus/tools/option_values.h>
#include <talus/tools/world_file.h>

#include "commands/commands.h"
#include "find_look.h"
#include "preview.h"

namespace talus::tools {
namespace {

Expected<void> print_line(const std::string& line) {
  if (std::printf("%s\n", line.c_str()) < 0 || std::fflush(stdout) != 0) {
    return failed(std::string{"standard output: "} + std::strerror(errno));
  }
  return {};
}

struct PreviewArguments {
  std::string world;
  std::string centre;
  int threads = 0;
  std::string output;
};

Expected<void> run_preview(const PreviewArguments& arguments) {
  std::optional<IntegerPair> centre;
  if (!arguments.centre.empty()) {
    const auto given = parse_pair("--center", arguments.centre);
    if (!given) return tl::make_unexpected(given.error());
    centre = *given;
  }
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  if (!centre) {
    const VoxelPos spawn = terrain::find_spawn(*world);
    centre = IntegerPair{spawn.x, spawn.z};
  }
  auto file = PngFile::create(files::to_path(arguments.output));
  if (!file) return tl::make_unexpected(file.error());
  const std::string name =
      arguments.world.empty() ? "default" : files::to_text(files::to_path(arguments.world).stem());
  const auto sheet =
      draw_preview(*world, name, centre->first, centre->second, {.threads = arguments.threads});
  if (!sheet) return tl::make_unexpected(sheet.error());
  return file->write(*sheet);
}

struct FindArguments {
  std::string world;
  std::string look;
  bool looks = false;
  std::string near;
  std::int64_t within = 65536;
};
constexpr std::int64_t kFarthest = std::int64_t{1} << 24;

std::string listed(const std::vector<std::string>& look_names) {
  std::string list;
  for (std::size_t look = 1; look < look_names.size(); ++look) {
    list += (look == 1 ? "" : ", ") + look_names[look];
  }
  return list;
}

Expected<void> print_looks(const terrain::World& world, IntegerPair near, std::int64_t within) {
  const std::vector<double> shares = look_shares(world, near.first, near.second, within);
  std::string text;
  for (std::size_t look = 1; look < shares.size(); ++look) {
    char share[32];
    std::snprintf(share, sizeof share, "%6.2f %%  ", 100 * shares[look]);
    text += (look == 1 ? "" : "\n") + std::string{share} + world.look_names()[look];
  }
  return print_line(text);
}

Expected<void> run_find(const FindArguments& arguments) {
  if (arguments.looks == !arguments.look.empty()) return wrong_use("one of --look and --looks is needed");
  const auto near = parse_pair("--near", arguments.near);
  if (!near) return tl::make_unexpected(near.error());
  if (auto inside = region_around("--near", *near, {1, 1}, Lod{}); !inside) {
    return tl::make_unexpected(inside.error());
  }
  const auto world = load_world(arguments.world);
  if (!world) return tl::make_unexpected(world.error());
  const auto& names = world->look_names();
  if (names.size() < 2) return failed("this world has no looks; [[look]] in its file makes them");
  if (arguments.looks) return print_looks(*world, *near, arguments.within);
  const auto name = std::find(names.begin() + 1, names.end(), arguments.look);
  if (name == names.end()) {
    return wrong_use("--look: no look is named '" + arguments.look + "'; the looks are " + listed(names));
  }
  const auto found = [&] {
    ProgressBar progress{"find", "rings"};
    return find_look(*world, static_cast<std::uint8_t>(name - names.begin()), near->first, near->second,
                     arguments.within, progress);
  }();
  if (!found) {
    return failed("no column with look '" + arguments.look + "' within " + std::to_string(arguments.within) +
                  " columns of " + arguments.near);
  }
  const terrain::BaseColumn column{found->x, found->z};
  const std::int32_t row = terrain::boundary_row(terrain::surface_heights(*world, {&column, 1}).front());
  return print_line(std::to_string(found->x) + "," + std::to_string(found->z) + " " + std::to_string(row));
}

}  // namespace

Command add_preview(CLI::App& app) {
  auto* preview = app.add_subcommand("preview", "Draw one sheet that shows what a world is like");
  const auto arguments = std::make_shared<PreviewArguments>();
  add_output(*preview, arguments->output, "Picture to write", "F.png");
  preview
      ->add_option("--center", arguments->centre,
                   "Base column in the middle of all maps; default: where players arrive")
      ->type_name("X,Z");
  add_world(*preview, arguments->world);
  add_threads(*preview, arguments->threads);
  preview->footer(
      "Three maps of 616 pixels a side, of every column, every 8th and every 64th; a section with the "
      "layers; the\n"
      "fields and quantities of the largest map; shares of looks, materials and slopes, heights, and what "
      "columns and\n"
      "chunks cost. Times are CPU time on this machine, so two sheets differ in them and in nothing else.");
  return {preview, [arguments] { return run_preview(*arguments); }};
}

Command add_find(CLI::App& app) {
  auto* find = app.add_subcommand("find", "Find the nearest column with a look, such as a desert");
  const auto arguments = std::make_shared<FindArguments>();
  find->add_option("--look", arguments->look, "Name of a [[look]] of the world")->type_name("NAME");
  find->add_flag("--looks", arguments->looks, "Instead: list all looks, with their shares of what is near");
  find->add_option("--near", arguments->near, "Base column to begin at")->type_name("X,Z")->required();
  find->add_option("--within", arguments->within, "Base columns to go along x and z at most, 1 to 2^24")
      ->check(CLI::Range(std::int64_t{1}, kFarthest))
      ->type_name("COLUMNS")
      ->capture_default_str();
  add_world(*find, arguments->world);
  find->footer(
      "Prints \"X,Z HEIGHT\": the column, and the row of the first free voxel over its ground, which may lie "
      "under\n"
      "water. Looks at every column up to 256 away, at every second up to 512, and so on, so it may overlook "
      "a\n"
      "patch narrower than 1/128 of its distance. The same world gives the same column. Exit status 1: "
      "none.");
  return {find, [arguments] { return run_find(*arguments); }};
}

}  // namespace talus::tools
