#include "command_line.h"

#include <charconv>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "command_line/connect_options.h"
#include "command_line/parse.h"
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
  app.add_option("--players", options.players, "Players")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--duration", options.seconds, "Seconds that are measured")
      ->check(within(0.1, kDay))
      ->capture_default_str();
  app.add_option("--ramp-up", options.ramp_up_seconds, "Seconds in which the players join, evenly")
      ->check(within(0, kDay))
      ->capture_default_str();
  app.add_option(
         "--warm-up", options.warm_up_seconds,
         "Measure from so many seconds after the last player was to join (default: from the first on, "
         "the ramp-up included)")
      ->check(within(0, kDay));
  app.add_option("--drain", options.drain_seconds,
                 "Seconds at the end to wait for chunks that have not come; those that never come are the "
                 "figure unanswered")
      ->check(within(0, kDay))
      ->capture_default_str();
  app.add_option(
         "--model", options.model,
         "How they move: stand, walk, fly, teleport, swarm (into one place), trace:FILE (lines of "
         "\"seconds x y z\", voxels from the start), mixed, or shares as in walk=80,fly=15,teleport=5")
      ->capture_default_str();
  app.add_option("--speed", options.speed, "Voxels a second (default: walk 5, fly and swarm 20)")
      ->check(within(0, 100'000));
  app.add_option("--groups", options.groups,
                 "Number of groups whose players stand and move together; 0: each player is alone")
      ->check(CLI::Range(0U, kMaxClients))
      ->capture_default_str();
  app.add_option("--radius", options.radius, "Chunks of the View to each side")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--vertical", options.vertical, "Chunks of the View up and down")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option(
         "--tick", options.tick_hz,
         "Times a second at which a player looks where it is; a View is sent in another chunk and after a "
         "turn of 15 degrees")
      ->check(within(0.1, 1000))
      ->capture_default_str();
  app.add_flag("--every-tick", options.every_tick, "Send a View at every tick, as a careless client does");
  app.add_option("--dwell", options.dwell_seconds, "Seconds between a teleporter's jumps")
      ->check(within(0.05, kDay))
      ->capture_default_str();
  app.add_option(
         "--churn", options.churn_seconds,
         "Players are cut off after so many seconds (mean), half of them by a reset, and come back within "
         "one; 0: they stay")
      ->check(within(0, kDay))
      ->capture_default_str();
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
  app.add_option("--slow-rate", options.slow_kbit, "Kilobits a second that each slow client reads")
      ->check(within(0.2, 1e6))
      ->capture_default_str();
  app.add_option("--in-flight", options.in_flight,
                 "Requests instead of Views: each player keeps this many in flight, of a fixed set of chunks "
                 "(a closed "
                 "loop); 0: Views")
      ->check(CLI::Range(0U, 65535U))
      ->capture_default_str();
  app.add_option("--set", options.fixed_set,
                 "Chunks in that set, taken from the ground around the spawn point")
      ->check(CLI::Range(1U, 1'000'000U))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of everything random, such as where players begin")
      ->check([](const std::string& text) {  // CLI11 takes one past 64 bits for the largest
        std::uint64_t seed = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, seed);
        return error == std::errc{} && stop == end
                   ? std::string{}
                   : "'" + text + "' is no seed; give a whole number from 0 to 18446744073709551615";
      })
      ->capture_default_str();
  app.add_option("--threads", options.threads, "Threads of this program")
      ->check(CLI::Range(1U, 64U))
      ->capture_default_str();
  app.add_option("--from-addresses", options.from_addresses,
                 "Source addresses to connect from: 127.0.0.1 and those after it")
      ->check(CLI::Range(1U, 65534U))
      ->capture_default_str();
}

void add_results(CLI::App& app, Options& options, Words& words) {
  app.add_option("--verify", options.verify_percent,
                 "Percent of the chunks that are decoded and hashed; 100 takes more CPU time than the server")
      ->check(within(0, 100))
      ->capture_default_str();
  app.add_option("--ring-tolerance", options.ring_tolerance,
                 "Rings by which a chunk may arrive before a nearer one, in a first View, without being "
                 "counted as out of order")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--metrics", words.metrics,
                 "HOST:PORT of the server's /metrics, to report its CPU time and memory");
  app.add_option("--server-pid", options.server_pid,
                 "Process id of a server on this machine, to report the same from /proc")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", options.json, "Write all figures to this file");
  app.add_option("--plot", options.plot, "Write the latencies by percentile, as .svg");
  app.add_option("--compare", options.compare, "Print the ratios to a file that --json wrote before")
      ->check(CLI::ExistingFile);
  app.add_option("--fail-if", words.fail_if,
                 "Exit with status 1 if this holds, as in p99_ms>50; may be repeated")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace

tl::expected<Options, Exit> read_command_line(int argc, const char* const* argv) {
  const auto wrong = [](const std::string& line) {
    return tl::unexpected{Exit{command_line::kExitWrongUse, line}};
  };
  CLI::App app{
      "Load generator for a Talus server: simulated players that check what they receive and measure "
      "latencies."};
  app.set_version_flag("--version", "talus-load " TALUS_VERSION);
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  Options options;
  Words words;
  command_line::ConnectWords connect;
  command_line::add_connect_options(app, connect);
  add_players(app, options);
  add_others(app, options);
  add_results(app, options, words);
  app.footer(
      "Latencies count from when a View was due, not from when it could be sent.\n"
      "Figures for --fail-if: " +
      figure_names() +
      "\nMany players from one address need --from-addresses, or a server whose "
      "limits.connections_per_address and "
      "rates.address_* allow them.\n"
      "Exit status: 0 done, whatever was found; 1 failed, or a --fail-if holds; 2 wrong use.");
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
  if (options.players + options.idle + options.greedy + options.slow == 0) {
    return wrong("--players 0 and nobody else: there is nothing to do");
  }
  return options;
}

}  // namespace talus::load
