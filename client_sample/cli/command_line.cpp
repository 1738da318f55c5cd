#include "command_line.h"

#include <filesystem>
#include <iomanip>
#include <sstream>

#include <talus/files/path_text.h>
#include <CLI/CLI.hpp>

#include "command_line/connect_options.h"
#include "command_line/parse.h"
#include "picture.h"
#include "surface_map.h"

namespace talus::cli {
namespace {

using command_line::Exit;
using command_line::kExitWrongUse;
using command_line::within;

constexpr double kMaxSeconds = 86400;
constexpr double kMaxFlight = 10e6;  // voxels: its heights are requested and stored before it begins

// Values that the parser cannot store in one option.
struct Words {
  std::int64_t x = 0, y = 0, z = 0, lod = 0;
  std::vector<std::int64_t> center;
  std::vector<std::int64_t> from;
  std::vector<std::int64_t> columns;
  std::vector<std::int64_t> box;
  bool as_generated = false;
  std::vector<std::int64_t> size{1024, 1024};
};

void add_timeout(CLI::App& command, double& seconds) {
  command.add_option("--timeout", seconds, "Give up after this many seconds without an answer")
      ->check(within(0.1, kMaxSeconds))
      ->capture_default_str();
}

CLI::Option* add_path(CLI::App& command, const char* names, std::filesystem::path& path,
                      const char* meaning) {
  const auto set = [&path](const std::string& text) { path = files::to_path(text); };
  return command.add_option_function<std::string>(names, set, meaning);
}

void add_get(CLI::App& app, GetOptions& options, Words& words) {
  auto* command = app.add_subcommand("get", "Fetch one chunk");
  command->add_option("x", words.x, "East of the origin, in chunks of the level")->required();
  command->add_option("y", words.y, "Up, in chunks of the level")->required();
  command->add_option("z", words.z, "South of the origin, in chunks of the level")->required();
  command->add_option("--lod", words.lod, "Level of detail L, 0 to 6: a voxel spans 2^L base voxels")
      ->capture_default_str();
  add_path(*command, "-o,--output", options.output,
           "Write the voxels as .npy, [y][z][x], instead of printing a summary");
  add_timeout(*command, options.timeout_seconds);
}

void add_at(CLI::App& app, AtOptions& options, Words& words) {
  auto* command = app.add_subcommand("at", "Print the ground's height and the place's properties at columns");
  command->add_option("columns", words.columns, "X,Z of each column, base columns")
      ->delimiter(',')
      ->required();
  add_timeout(*command, options.timeout_seconds);
}

void add_fly(CLI::App& app, FlyOptions& options, Words& words) {
  const auto or_less = [](int radius) {
    return " (default: " + std::to_string(radius) + ", or as far as the server allows)";
  };
  auto* command = app.add_subcommand("fly", "Fly over the world, streaming the chunks around the camera");
  command->add_option("--seconds", options.seconds, "Length of the flight in seconds")
      ->check(within(0.1, kMaxSeconds))
      ->capture_default_str();
  command
      ->add_option("--radius", options.radius,
                   "View radius in chunks of level 0" + or_less(FlyOptions::kRadius))
      ->check(CLI::Range(1, 1000));
  command
      ->add_option("--far", options.far_radius,
                   "Radius out to which coarser levels fill the view, in chunks of level 0" +
                       or_less(FlyOptions::kFarRadius))
      ->check(CLI::Range(0, 4096));
  command
      ->add_option("--from", words.from,
                   "X,Z where the flight begins, base voxels (default: the spawn point)")
      ->delimiter(',')
      ->expected(2);
  command
      ->add_option("--heading", options.heading,
                   "Degrees clockwise from north (default: towards open ground with high land behind it)")
      ->check(within(-360, 360));
  command->add_option("--height", options.height, "Flying height in voxels above the ground")
      ->check(within(1, 10000))
      ->capture_default_str();
  command->add_option("--speed", options.speed, "Voxels per second")
      ->check(within(0, 100000))
      ->capture_default_str();
  command_line::add_generate_option(*command, options.generate,
                                    "Make chunks here and receive only edits: auto (default: where the "
                                    "server publishes its world), never, "
                                    "or always");
  add_path(*command, "-o,--output", options.output,
           "Write a map of the chunks received, as .png; hatched where chunks are missing");
  add_path(*command, "--view", options.view, "Write the camera's picture at the end, as .png");
}

void add_map(CLI::App& app, MapOptions& options, Words& words) {
  auto* command = app.add_subcommand("map", "Draw a map of the ground");
  command->add_option("--center", words.center, "X,Z of the middle, base voxels (default: the spawn point)")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--size", words.size, "W,H in base voxels, at most 8192 each (default: 1024,1024)")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 8192));
  add_path(*command, "-o,--output", options.output, "Picture to write, .png")->required();
  add_timeout(*command, options.timeout_seconds);
}

void add_edit(CLI::App& app, EditOptions& options, Words& words) {
  auto* command = app.add_subcommand(
      "edit",
      "Make a box of voxels one material, or as generated; needs a token with the right edit. At most 65,536 "
      "voxels (such as 40 x 40 x 40) in 64 chunks; several edits for more");
  command
      ->add_option("box", words.box,
                   "X,Y,Z of a voxel, or X,Y,Z X,Y,Z of two corners, both included; base voxels")
      ->delimiter(',')
      ->required();
  auto* material =
      command->add_option("--material", options.material, "Name of the material, \"air\" to dig");
  command->add_flag("--as-generated", words.as_generated, "Undo all edits there")->excludes(material);
  command->add_option("--only", options.only, "Change voxels of this material alone");
  command->add_option("--subject", options.subject,
                      "Subject for which a game server edits; needs a token with the right gateway");
  add_timeout(*command, options.timeout_seconds);
}

// Checks beyond the parser's. The error is one line.
using CheckResult = tl::expected<CommandLine, std::string>;

CheckResult check_get(CommandLine line, GetOptions options, const Words& words) {
  const auto lod = Lod::checked(words.lod);
  if (!lod) return tl::unexpected{"--lod: " + lod.error().message};
  const auto key = checked_chunk(words.x, words.y, words.z, *lod);
  if (!key) return tl::unexpected{key.error().message};
  options.key = *key;
  line.options = std::move(options);
  return line;
}

CheckResult check_at(CommandLine line, AtOptions options, const Words& words) {
  if (words.columns.size() % 2 != 0) {
    return tl::unexpected{std::string{"columns: "} + std::to_string(words.columns.back()) +
                          " has no z; X,Z of each is needed"};
  }
  for (std::size_t i = 0; i < words.columns.size(); i += 2) {
    options.columns.push_back({words.columns[i], words.columns[i + 1]});
  }
  line.options = std::move(options);
  return line;
}

CheckResult check_fly(CommandLine line, FlyOptions options, const Words& words) {
  if (!words.from.empty()) {
    options.from = client::Column{words.from[0], words.from[1]};
    const auto there = extent_around(options.from->x, options.from->z, 1, 1);
    if (!there) return tl::unexpected{"--from leaves the world: " + there.error().message};
  }
  if (options.seconds * options.speed > kMaxFlight) {
    std::ostringstream text;
    text << "--seconds " << options.seconds << " at --speed " << options.speed << " is a flight longer than "
         << std::fixed << std::setprecision(0) << kMaxFlight << " voxels";
    return tl::unexpected{text.str()};
  }
  if (auto png = check_png_name(options.output, "--output"); !png) return tl::unexpected{png.error()};
  if (auto png = check_png_name(options.view, "--view"); !png) return tl::unexpected{png.error()};
  line.options = std::move(options);
  return line;
}

CheckResult check_map(CommandLine line, MapOptions options, const Words& words) {
  if (auto png = check_png_name(options.output, "--output"); !png) return tl::unexpected{png.error()};
  options.width = words.size[0];
  options.depth = words.size[1];
  if (!words.center.empty()) {
    options.center = client::Column{words.center[0], words.center[1]};
    const auto extent = extent_around(options.center->x, options.center->z, options.width, options.depth);
    if (!extent) return tl::unexpected{"--center and --size leave the world: " + extent.error().message};
  }
  line.options = std::move(options);
  return line;
}

CheckResult check_edit(CommandLine line, EditOptions options, const Words& words) {
  if (options.material.empty() && !words.as_generated) {
    return tl::unexpected{std::string{"edit: give --material NAME, or --as-generated"}};
  }
  const std::vector<std::int64_t>& box = words.box;
  if (box.size() != 3 && box.size() != 6) {
    return tl::unexpected{"edit: a box of " + std::to_string(box.size()) +
                          " numbers; X,Y,Z of a voxel or of two corners is needed"};
  }
  options.from = {box[0], box[1], box[2]};
  options.to = box.size() == 3 ? options.from : VoxelPos{box[3], box[4], box[5]};
  line.options = std::move(options);
  return line;
}

}  // namespace

tl::expected<CommandLine, Exit> read_command_line(int argc, const char* const* argv,
                                                  const std::string& version) {
  CLI::App app{"A sample client for Talus servers."};
  app.set_version_flag("--version", "talus-client " + version);
  app.require_subcommand(1);
  app.fallthrough();
  CommandLine line;
  Words words;
  line.target.options.client_name = "talus-client " TALUS_VERSION;
  line.target.options.reconnect.max_attempts = 8;
  command_line::ConnectWords connect;
  command_line::add_connect_options(app, connect);
  GetOptions get_options;
  AtOptions at_options;
  FlyOptions fly_options;
  MapOptions map_options;
  EditOptions edit_options;
  add_get(app, get_options, words);
  add_at(app, at_options, words);
  add_fly(app, fly_options, words);
  add_map(app, map_options, words);
  add_edit(app, edit_options, words);

  if (auto exit = command_line::parse(app, argc, argv)) return tl::unexpected{*std::move(exit)};
  auto connection = command_line::read_connect_options(connect);
  if (!connection) return tl::unexpected{Exit{kExitWrongUse, connection.error()}};
  line.target.server = std::move(connection->server);
  line.target.options.token = std::move(connection->token);
  line.target.options.tls = std::move(connection->tls);
  line.target.options.more_servers = command_line::more_servers(*connection);
  line.target.options.websocket = std::move(connection->websocket);

  auto checked = app.got_subcommand("get")    ? check_get(std::move(line), get_options, words)
                 : app.got_subcommand("at")   ? check_at(std::move(line), at_options, words)
                 : app.got_subcommand("edit") ? check_edit(std::move(line), edit_options, words)
                 : app.got_subcommand("fly")  ? check_fly(std::move(line), fly_options, words)
                                              : check_map(std::move(line), map_options, words);
  return std::move(checked).map_error([](std::string text) { return Exit{kExitWrongUse, std::move(text)}; });
}

}  // namespace talus::cli
