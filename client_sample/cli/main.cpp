// talus-client: one chunk, a flight, or a map, from a running server.
#include <functional>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <asio/co_spawn.hpp>
#include <asio/io_context.hpp>

#include "commands.h"

namespace {

using namespace talus::cli;

constexpr int kFailed = 1;
constexpr int kWrongUse = 2;

int run(const std::function<asio::awaitable<Outcome>()>& command) {
  asio::io_context io{1};
  Outcome outcome;
  std::exception_ptr thrown;
  asio::co_spawn(io, command, [&](std::exception_ptr exception, Outcome result) {
    thrown = exception;
    outcome = std::move(result);
  });
  io.run();
  if (thrown) std::rethrow_exception(thrown);
  if (outcome) return 0;
  std::cerr << "talus-client: " << outcome.error() << '\n';
  return kFailed;
}

void add_get(CLI::App& app, GetOptions& options) {
  auto* command = app.add_subcommand("get", "Fetch one chunk");
  command->add_option("x", options.x, "Chunk coordinates, in chunks of the level")->required();
  command->add_option("y", options.y, "")->required();
  command->add_option("z", options.z, "")->required();
  command->add_option("--lod", options.lod, "Level of detail, 0 to 6: a voxel spans 2^L base voxels")
      ->capture_default_str();
  command->add_option("-o,--output", options.output,
                      "Write the voxels as .npy, [y][z][x], instead of printing a summary");
}

void add_fly(CLI::App& app, FlyOptions& options) {
  auto* command = app.add_subcommand("fly", "Fly over the world, keeping the view filled");
  command->add_option("--seconds", options.seconds, "Length of the flight, seconds")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  command->add_option("--radius", options.radius, "Chunks of level 0 to each side")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--far", options.far_radius, "Chunks of level 0 out to which coarser ones fill the view")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command->add_option("--height", options.height, "Voxels above the ground")
      ->check(CLI::Range(1.0, 10000.0))
      ->capture_default_str();
  command->add_option("--speed", options.speed, "Voxels a second")
      ->check(CLI::Range(0.0, 100000.0))
      ->capture_default_str();
  command->add_option("-o,--output", options.output, "Write a map of what came, as .png");
  command->add_option("--view", options.view, "Write what the camera saw at the end, as .png");
}

struct MapWords {
  std::vector<std::int64_t> center;
  std::vector<std::int64_t> size{1024, 1024};
};

void add_map(CLI::App& app, MapOptions& options, MapWords& words) {
  auto* command = app.add_subcommand("map", "Draw a map of the ground");
  command->add_option("--center", words.center, "X,Z in voxels (default: the spawn point)")
      ->delimiter(',')
      ->expected(2);
  command->add_option("--size", words.size, "W,H in voxels, at most 8192 each (default: 1024,1024)")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 8192));
  command->add_option("-o,--output", options.output, "Where to write the .png")->required();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Sample client of a Talus server."};
  app.set_version_flag("--version", "talus-client " TALUS_VERSION);
  app.require_subcommand(1);
  app.fallthrough();
  std::string server = "localhost:4780";
  Connecting connecting;
  connecting.options.client_name = "talus-client " TALUS_VERSION;
  connecting.options.reconnect.max_attempts = 5;
  app.add_option("--connect", server, "HOST:PORT of the server")->capture_default_str();
  app.add_option("--token", connecting.options.token, "What the server's operator gave out");

  GetOptions get_options;
  FlyOptions fly_options;
  MapOptions map_options;
  MapWords map_words;
  add_get(app, get_options);
  add_fly(app, fly_options);
  add_map(app, map_options, map_words);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version arrive here
    std::cerr << "talus-client: " << error.what() << " (see --help)\n";
    return kWrongUse;
  }
  const auto endpoint = parse_endpoint(server);
  if (!endpoint) {
    std::cerr << "talus-client: " << endpoint.error() << '\n';
    return kWrongUse;
  }
  connecting.server = *endpoint;

  if (app.got_subcommand("get")) return run([&] { return get(connecting, get_options); });
  if (app.got_subcommand("fly")) return run([&] { return fly(connecting, fly_options); });
  map_options.at_spawn = map_words.center.empty();
  if (!map_options.at_spawn) {
    map_options.center_x = map_words.center[0];
    map_options.center_z = map_words.center[1];
  }
  map_options.width = map_words.size[0];
  map_options.depth = map_words.size[1];
  return run([&] { return map(connecting, map_options); });
}
