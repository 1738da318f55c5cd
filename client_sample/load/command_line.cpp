#include "command_line.h"

#include <charconv>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "command_line/connect_options.h"
#include "command_line/parse.h"
#include "edit_site.h"
#include "figures.h"

namespace talus::load {
namespace {

using command_line::Exit;
using command_line::within;

struct Words {
  std::string metrics;
  std::vector<std::string> fail_if;
};

constexpr double kDay = 86400;
constexpr std::uint32_t kMaxClients = 100'000;

void add_players(CLI::App& app, Options& options) {
  app.add_option("--players", options.players, "Number of simulated players")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--duration", options.seconds, "Measured time in seconds")
      ->check(within(0.1, kDay))
      ->capture_default_str();
  app.add_option("--ramp-up", options.ramp_up_seconds, "Seconds over which the players join, evenly")
      ->check(within(0, kDay))
      ->capture_default_str();
  app.add_option(
         "--warm-up", options.warm_up_seconds,
         "Seconds between the last scheduled join and the start of measuring (default: measure from the "
         "first join on, ramp-up included)")
      ->check(within(0, kDay));
  app.add_option(
         "--drain", options.drain_seconds,
         "Seconds to wait at the end for chunks still missing; chunks that never arrive count as unanswered")
      ->check(within(0, kDay))
      ->capture_default_str();
  app.add_option(
         "--model", options.model,
         "Movement of the players: stand, walk, fly, teleport, swarm (all to one place), trace:FILE (lines "
         "of \"seconds x y z\", voxels from the start), mixed, or shares: walk=80,fly=15,teleport=5")
      ->capture_default_str();
  app.add_option("--speed", options.speed, "Voxels per second (default: walk 5, fly and swarm 20)")
      ->check(within(0, 100'000));
  app.add_option("--groups", options.groups,
                 "Number of groups whose players stay together; 0: each player is alone")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--radius", options.radius, "Horizontal radius of the View in chunks")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--vertical", options.vertical, "Vertical radius of the View in chunks")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--horizon", options.horizon,
                 "Chunks out to which the View has rings of levels 1 to 6 with the whole height of the "
                 "world; 0: no rings")
      ->check(CLI::Range(0, 32'768))
      ->capture_default_str();
  app.add_option(
         "--tick", options.tick_hz,
         "Ticks per second of a player; it sends a View at a tick if it is in another chunk or has turned "
         "by 15 degrees")
      ->check(within(0.1, 1000))
      ->capture_default_str();
  app.add_flag("--every-tick", options.every_tick,
               "Send a View at every tick, as a badly written client does");
  app.add_option("--dwell", options.dwell_seconds, "Seconds between a teleporter's jumps")
      ->check(within(0.05, kDay))
      ->capture_default_str();
  command_line::add_generate_option(
      app, options.generate,
      "Players make the chunks of Views themselves, and receive only edits: never (default), auto (where "
      "the "
      "server publishes its world) or always. They share one world here, and make only the chunks that they "
      "compare with the server's: as many as a real player");
  app.add_option("--churn", options.churn_seconds,
                 "Mean seconds until a player's connection is cut (half of the cuts are resets); the player "
                 "reconnects within a second; 0: never")
      ->check(within(0, kDay))
      ->capture_default_str();
}

void add_builders(CLI::App& app, Options& options) {
  auto* const rate = app.add_option(
      "--edits", options.edits,
      "Edits per second of each player, which stands, and digs and builds one voxel after the other; all "
      "players near must receive each acknowledged edit, or the exit status is 1. They build of the world's "
      "last material, at places that the seed chooses, and it stays: give each run on one store another "
      "--seed, or the server a new --data directory");
  auto* const in_flight =
      app.add_option("--edit-in-flight", options.edits_in_flight,
                     "Instead of a rate: edits that each player keeps unanswered (a closed loop)");
  auto* const group = app.add_option("--edit-group", options.edit_group,
                                     "Number of players that edit and watch at one place");
  app.add_option("--edits-file", options.edits_file,
                 "Append a line to this file for each acknowledged edit that changed its voxel: revision, x, "
                 "y, z, material id");
  rate->check(within(0.001, 10'000))->excludes(in_flight);
  in_flight->check(CLI::Range(1U, 64U));
  group->check(CLI::Range(1U, EditSite::kMaxBuilders))->capture_default_str();
  for (CLI::Option* const edits : {rate, in_flight}) {
    for (const char* other : {"--model", "--groups", "--in-flight"}) edits->excludes(app.get_option(other));
  }
}

void add_others(CLI::App& app, Options& options) {
  app.add_option("--idle", options.idle,
                 "Idle connections, which join before the players and send only Hello and Ping")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option(
         "--greedy", options.greedy,
         "Additional clients that keep as many requests for new terrain in flight as the server allows")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--slow", options.slow, "Additional clients that walk and read slowly")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--slow-rate", options.slow_kbit, "Kilobits per second that each slow client reads")
      ->check(within(0.2, 1e6))
      ->capture_default_str();
  app.add_option("--in-flight", options.in_flight,
                 "Send requests instead of Views: each player keeps this many in flight (a closed loop), for "
                 "chunks of a fixed set; 0: Views")
      ->check(CLI::Range(0U, 65535U))
      ->capture_default_str();
  app.add_option("--set", options.fixed_set,
                 "Number of chunks in that set, which lie at the ground around the spawn point")
      ->check(CLI::Range(1U, 1'000'000U))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of all randomness, such as the players' start positions")
      ->check([](const std::string& text) {  // CLI11 reads more than 64 bits as the maximum
        std::uint64_t seed = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, seed);
        return error == std::errc{} && stop == end
                   ? std::string{}
                   : "'" + text + "' is not a seed; give a whole number from 0 to 18446744073709551615";
      })
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Number of threads of this program")
      ->check(CLI::Range(1U, 64U))
      ->capture_default_str();
  app.add_flag("--groups-together", options.groups_together,
               "If --connect names several servers: all players of a group connect to the same one; else "
               "each connects to any");
  app.add_option("--from-addresses", options.from_addresses,
                 "Number of source addresses to connect from: 127.0.0.1 and the following")
      ->check(CLI::Range(1U, 65534U))
      ->capture_default_str();
}

void add_results(CLI::App& app, Options& options, Words& words) {
  app.add_option("--verify", options.verify_percent,
                 "Percentage of chunks to decode and hash; 100 takes more CPU time than the server")
      ->check(within(0, 100))
      ->capture_default_str();
  app.add_option("--ring-tolerance", options.ring_tolerance,
                 "Rings by which a chunk of a first View may precede a nearer one without counting as out of "
                 "order")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--patch-tiles", options.patch_tiles,
                 "The server's generation.patch_tiles, to report with --metrics how many patches it "
                 "generated for each "
                 "that is new to a player; 0: not")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--metrics", words.metrics,
                 "HOST:PORT of the server's /metrics, to report its CPU time and memory");
  app.add_option("--server-pid", options.server_pid,
                 "Process id of the server, on this machine, to report the same from /proc")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", options.json, "Write all figures to this file");
  app.add_option("--plot", options.plot, "Write the latencies by percentile, as .svg");
  app.add_option("--compare", options.compare,
                 "Print the ratios to the figures in this file, which an earlier --json wrote")
      ->check(CLI::ExistingFile);
  app.add_option("--fail-if", words.fail_if,
                 "Exit with status 1 if this holds, as in p99_ms>50; may be repeated")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

tl::expected<Options, Exit> read_command_line(int argc, const char* const* argv, const std::string& version) {
  const auto wrong = [](const std::string& line) {
    return tl::unexpected{Exit{command_line::kExitWrongUse, line}};
  };
  CLI::App app{
      "Load generator for a Talus server: simulated players that check what they receive and measure "
      "latencies."};
  app.set_version_flag("--version", "talus-load " + version);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  Options options;
  Words words;
  command_line::ConnectWords connect;
  command_line::add_connect_options(app, connect);
  add_players(app, options);
  add_others(app, options);
  add_builders(app, options);
  add_results(app, options, words);
  app.footer(
      "Latencies are measured from the scheduled time of a View, not from when it could be sent.\n"
      "Figures for --fail-if: " +
      figure_names() +
      "\nFor many players, use --from-addresses, or raise the server's limits.connections_per_address and "
      "rates.address_*.\n"
      "Exit status: 0 finished, whatever was found; 1 failure, a --fail-if holds, or with\n"
      "--edits an acknowledged edit is missing, no edit was acknowledged or no edit changed a voxel;\n"
      "2 wrong arguments.");
  if (auto exit = command_line::parse(app, argc, argv)) return tl::unexpected{*std::move(exit)};
  auto connecting = command_line::read_connect_options(connect);
  if (!connecting) return wrong(connecting.error());
  options.connect = *std::move(connecting);
  if (!words.metrics.empty()) {
    const auto metrics = command_line::read_server_address("--metrics", words.metrics);
    if (!metrics) return wrong(metrics.error());
    options.metrics = *metrics;
  }
  const auto mix = parse_player_mix(options.model);
  if (!mix) return wrong(mix.error());
  options.mix = *mix;
  for (const std::string& text : words.fail_if) {
    auto threshold = parse_threshold(text);
    if (!threshold) return wrong(threshold.error());
    options.fail_if.push_back(*std::move(threshold));
  }
  if (options.builds()) {
    options.groups = (options.players + options.edit_group - 1) / options.edit_group;
    if (options.horizon != 0 || options.vertical == 0) {
      return wrong("players who edit have no --horizon, and look up and down: --vertical is at least 1");
    }
    if (options.players == 0) return wrong("--players 0: edits need players");
  }
  if (options.horizon != 0 && options.horizon <= options.radius) {
    return wrong("--horizon " + std::to_string(options.horizon) + " is not beyond --radius " +
                 std::to_string(options.radius));
  }
  if (options.players + options.idle + options.greedy + options.slow == 0) {
    return wrong("--players 0 and no other clients: there is nothing to do");
  }
  return options;
}

}  // namespace talus::load
